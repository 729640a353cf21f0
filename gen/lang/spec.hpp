// A spec as it was read: an algebra (with its imports) and a scene that uses it. Names are checked here; expressions
// get their meaning where they are expanded.
#pragma once
#include "gen/lang/rungs.hpp"
#include "gen/lang/syntax.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace meetc::lang {

// 'name: type', where type is 'real' or a kind.
struct field {
  std::string name, type;
  location where;
};

struct named_expr {
  std::string name;
  expr_ptr body;
  location where;
};

// Another way to construct a kind's blade: [kinds.sphere.from.points].
struct constructor {
  std::string name;
  std::vector<field> of;
  expr_ptr blade;
  location where;
};

// 'left = right', true of the kind's blade, for which the kind's name stands.
struct relation {
  expr_ptr left, right;
  bool nearly = false; // what rounding makes true; otherwise it holds identically in the stored numbers
  location where;
};

struct kind {
  std::string name;
  location where;
  std::vector<field> store; // in memory order and CSV order
  expr_ptr blade;
  std::vector<int> grades; // of a kind of all blades of these grades, whose `store` and `blade` follow; else empty
  location grades_where;
  std::vector<constructor> from;
  std::vector<named_expr> parts; // computed members: corners, edges
  expr_ptr rule;                 // `where`: the condition on a valid element, or null
  expr_ptr hull, pad;            // for bounded kinds: the element is the hull of these points, padded by a length
  bool position = false;         // its reals are coordinates that a translation moves
  std::vector<relation> relations;
  double within = 0; // the most by which a coefficient of either side of a relation that holds nearly may differ
  // Blades that satisfy the relations exactly, constructed from these operands: [kinds.motor.samples].
  std::vector<field> sample_of;
  std::vector<expr_ptr> samples;
};

// The geometry that is read back from the blade of a kind, for which the kind's name stands: [gives.circle]. Each entry sees
// those before it.
struct reading {
  std::string kind;
  std::vector<named_expr> entries;
  location where;
};

struct function {
  std::string name;
  std::vector<std::string> params;
  expr_ptr body;
  expr_ptr domain; // `where`: the condition on the arguments, or null
  location where;
  // The predicate whose second operands it orders: the function's value says which of two of them the first operand meets
  // first. Empty: none.
  std::string orders;
  location orders_where;
};

// The meaning of a hit: a fact about the two elements as closed convex bodies, by which `meetc verify` judges.
enum class meaning {
  touch,    // they share a point
  beyond,   // they share a point beyond the simplex of their common corners
  overlap,  // their interiors meet: no translation that is short enough parts them
  contains, // the first holds all of the second
};

// The key `contacts` says this in place of a function: a runtime places one point of both operands.
inline constexpr const char *one_witness = "witness";

struct predicate {
  std::string name;
  location where;
  std::vector<field> of;        // two operands
  std::vector<named_expr> lets; // names for parts of the expressions
  std::vector<expr_ptr> reject; // cheap conditions, each sufficient for a miss
  expr_ptr hit;
  std::string mode; // "solid", "surface", or "" where the two do not differ
  meaning means = meaning::touch;
  location means_where;
  int common = 0; // of meaning::beyond: this many first points of both hulls are the same; 0: those that are equal
  location common_where;
  // The function of an operand and a point by whose sign a runtime finds where the operands meet, or one_witness. Empty: none.
  std::string contacts;
  location contacts_where;
};

// A predicate's meaning in words: "touch", "beyond 1 common point".
std::string text_of(const predicate &p);

// A basis blade of the key `order`, by its vectors in the order of their product. None: the scalar.
struct ordered_blade {
  std::vector<std::string> vectors;
  location where;
};

struct algebra {
  std::string name;
  location where;
  std::vector<std::string> vectors;             // the declared basis, in order
  std::vector<std::vector<std::string>> metric; // exact rationals
  std::vector<named_expr> null;                 // constants that replace declared vectors in lowering, in order
  std::vector<ordered_blade> order;             // of basis blades in output; those that it lacks stand as they would
  std::vector<named_expr> constants;
  std::vector<kind> kinds;
  std::vector<function> functions;
  std::vector<predicate> predicates;
  std::vector<reading> readings;

  const kind *find_kind(const std::string &name) const;
  const function *find_function(const std::string &name) const;
  const predicate *find_predicate(const std::string &name) const;
  const named_expr *find_constant(const std::string &name) const;
  const reading *find_reading(const std::string &kind) const;
  std::vector<std::string> kind_names() const;
};

struct kernel_request {
  expr_ptr what; // the name of a predicate, or a function applied to kinds
  location where;
};

struct scene {
  std::string name, space; // the file's stem; the C++ namespace
  algebra in;
  std::vector<kernel_request> kernels;
  std::vector<kernel_request> analytic; // those that are no polynomials: gives(circle), exp(bivector)
  std::vector<kernel_request> zero;     // kernels that the scene says to be zero for all operands
  std::vector<field> kinds;             // that a wildcard stands for, by their types; empty: those of the algebra
  std::vector<rung> rungs;
  std::vector<std::string> backends;
  bool asks(rung r) const { return std::find(rungs.begin(), rungs.end(), r) != rungs.end(); }
  // An answer of the rung tolerant may be wrong where moving one operand by at most this changes it; 0: not stated.
  double tolerance = 0;
  location tolerance_where;
  double box = 0; // every coordinate lies in [-box, box], every length in [0, 2 box]; 0: not stated
  std::vector<std::shared_ptr<const source_file>> files; // all files that were read, for the content hash
};

// The backends that a scene may name, and those of a scene that names none.
struct backend_choice {
  std::vector<std::string> known, unless_said;
};

// Reads a scene file and the algebra that it names, which is looked for in `algebra_path` too. Throws spec_error.
scene load_scene(const std::string &path, const backend_choice &backends,
                 const std::vector<std::string> &algebra_path = {});

// Adds the content of an algebra file, and of the one that it extends, to `out`. Imports are relative to the file.
void load_algebra(const std::string &path, algebra &out, std::vector<std::shared_ptr<const source_file>> &files,
                  const std::vector<std::string> &algebra_path = {});

// Throws for duplicate names, unknown kinds, kinds that contain themselves, unknown names in expressions, and
// recursion.
void check(const algebra &a);

} // namespace meetc::lang
