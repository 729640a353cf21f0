// A kernel: one thing that a scene asks for, compiled to programs and decisions for any target.
#pragma once
#include "gen/bound/bound.hpp"
#include "gen/lower/expand/expand.hpp"
#include "gen/lower/expand/rule.hpp"
#include "gen/lower/expand/stored_numbers.hpp"
#include "gen/lower/programs/build.hpp"

namespace meetc::lower {

using algebra::blade;

// A request whose operands have different names: 'norm2(meet(sphere, line))' on X: sphere, Y: line.
struct request {
  std::string text;                       // as the scene wrote it
  std::string function;                   // "norm2_meet", or the predicate's name
  lang::expr_ptr body;                    // with kinds replaced by operand names; null for a predicate
  const lang::predicate *asked = nullptr; // the predicate, if it is one
  std::vector<std::string> names;         // operand names
  std::vector<const lang::kind *> kinds;  // of the operands
  location where;

  std::string name() const; // "norm2_meet_sphere_line"
};

// Resolves what a scene may ask for: a predicate by name, or functions applied to kinds.
request resolve(const lower::model &m, const lang::expr_ptr &what);
// Resolves an expression over operands that the caller names ('S: sphere').
request resolve(const lower::model &m, const lang::expr_ptr &what,
                const std::vector<std::pair<std::string, std::string>> &with);

// The basis blades on which a kind can be non-zero, over all its constructors, in the order of output.
std::vector<blade> support(const lower::model &m, const lang::kind &k, bool declared = false);

// One way to compute a blade from stored numbers; the coefficients are those of support().
struct blade_maker {
  std::string name, text; // name: "" for the stored form; text: of the expression that says it
  std::vector<lang::field> of;
  std::vector<std::string> inputs; // "a.x", in memory order
  program code;
  std::shared_ptr<poly::ring> numbers;
};

// A relation of an operand's kind that a program takes for granted.
struct assumption {
  std::string operand, text; // "X", "motor * rev(motor) = 1"
  bool nearly = false;       // otherwise it holds identically in the stored numbers
  double within = 0;         // nearly: the most by which a coefficient of either side may differ
  // By result: a value differs from the formula's by at most `within` times the sum of the sizes of these terms.
  std::vector<poly::poly> left_out;
};
// The assumptions of a program on blades: its values are the formula's wherever the relations hold.
struct assumptions {
  std::vector<assumption> taken;    // none: the values are those of the polynomials
  std::vector<poly::poly> computed; // the program's polynomials, where something is taken
};

// A value as a function of general blades and of stored operands.
struct formula {
  std::vector<blade> result;               // the blades of the results; {0} for a number
  std::vector<basis_blade> result_names;   // of the same
  const lang::kind *result_kind = nullptr; // the kind whose blade has room for them
  program from_blades;                     // inputs: operands' support() coefficients, one operand after another
  std::vector<std::string> blade_inputs;   // their names, as "X.e1^n"
  assumptions assumed;                     // by from_blades
  // The same values from blades where one operand computes once what it alone decides, as a motor its matrix; without results
  // where that saves nothing. Only for multivectors of two operands.
  program prepared;
  assumptions prepared_assumed;
  program from_stored; // numbers only; inputs: stored numbers, one operand after another
  // The same number with the fewest operations for a pair whose objects store what each alone decides (its `stored`,
  // after the passes). Only for numbers of two operands; without results where nothing would be stored.
  program for_pairs;
  std::vector<std::string> stored_inputs;
  std::vector<poly::poly> polynomials; // of from_blades, in `numbers`; none where they are too long to be expanded
  std::shared_ptr<poly::ring> numbers, stored_numbers;

  bool is_expanded() const { return !polynomials.empty(); }
  bool is_number() const { return result_names.size() == 1 && result_names[0].is_scalar(); }
};

// One stage of a predicate: some of its atoms, as one program.
struct stage {
  std::vector<int> atoms; // ids in the decision
  program code;           // results follow `atoms`
};

struct predicate;
// A part of a decision that is another predicate's decision on other signs.
struct sub_decision {
  std::shared_ptr<const predicate> callee;
  std::string name, text;        // of the callee; text: "segment_triangle(segment(A.a, A.b), B)"
  int whole = 0, usual = 0;      // truths of the calling decision
  std::vector<sign_value> signs; // the sign in place of each of callee->order()
};

struct predicate {
  std::shared_ptr<poly::ring> numbers;
  std::vector<std::string> stored_inputs;
  int inputs_a = 0, inputs_b = 0;
  std::shared_ptr<poly::local_origin> local;
  lower::decision signs;
  lower::staged truths;
  std::vector<int> conditions;   // if any is true, the rare stage is needed
  int usual = 0;                 // the hit where none is true
  lower::sign_value value;       // for a kernel that is one sign, which has only the common stage
  stage reject, common, rare;    // no atoms: there is no such stage
  std::vector<sign_value> taken; // every sign that the hit takes, in the order of the spec
  std::vector<sub_decision> calls;
  bool symmetric = false; // proved: the operands may be exchanged (gen/lower/predicate/symmetric.hpp)
  bool by_boxes = false;  // proved: it holds where the operands' boxes touch (gen/lower/predicate/by_boxes.hpp)
  bool by_balls =
      false; // proved: it holds where the operands, balls or points, touch (gen/lower/predicate/by_balls.hpp)

  // The atoms in the order in which the stages compute them.
  std::vector<int> order() const;
};

// The stages in the order in which they run, for predicates and for all else that has stages (bounds).
enum class stage_kind : std::uint8_t { reject, common, rare };
inline constexpr std::array<stage_kind, 3> stage_kinds{stage_kind::reject, stage_kind::common, stage_kind::rare};
inline constexpr const char *name_of(stage_kind s) {
  return std::array{"reject", "common", "rare"}[static_cast<std::size_t>(s)];
}
template <class ByStage> auto stages(ByStage &of) {
  return std::array{&of.reject, &of.common, &of.rare};
}

struct kernel {
  request asked;
  bool is_predicate = false; // consists of signs: a predicate, or one sign
  bool is_sign = false;      // is one sign, as 'side(triangle, point)'
  formula value;             // where it does not consist of signs
  predicate decision;        // where it does
  // The predicate whose hits along the first operand this sign orders, or null: the value is -1 where that operand meets the
  // first element of the second one's pair before the other one.
  const lang::predicate *orders = nullptr;
  // A sign that tells on which side of an element of this kind, three points or a ball, a point lies; else null.
  const lang::kind *sides_of = nullptr;
};

// Turns a request into programs as lowering leaves them. Passes follow, and then bounds.
kernel compile(const lower::model &m, const request &r);
std::vector<blade_maker> makers(const lower::model &m, const lang::kind &k);

// The use of a program, which decides the values that are stored beside an object.
enum class use {
  once,  // on two single objects, or for few pairs of two sets, as a predicate's rare stage
  sets,  // for most pairs of two sets, whose objects the runtime prepares: a predicate's other stages
  pairs, // by callers that prepare objects themselves: a formula's for_pairs
};

// Every program of a kernel, with the ring and the names of its inputs.
struct kernel_program {
  std::string title; // "stage of 2 signs", "from blades"
  program *code;
  const poly::ring *numbers;
  const std::vector<std::string> *inputs;
  use as = use::once;
};
std::vector<kernel_program> programs(kernel &k);

// The input of the error analysis. Borrows from the predicate.
bound::subject subject_of(const predicate &p);

// A bounded kind as a runtime must know it: the points of the hull as inputs by axis, the input of the pad (-1:
// none), and the rule that a valid element obeys.
struct enclosure {
  std::vector<std::vector<int>> hull;
  // A point of the hull takes its coordinates from several stored points, as a corner of a box does.
  bool mixes_points = false;
  int pad = -1;
  std::optional<element_rule> rule;
};
// An empty hull means that the kind is not bounded, so sets of it cannot be searched.
enclosure enclosing(const lower::model &m, const lang::kind &k);

} // namespace meetc::lower
