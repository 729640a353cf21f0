// Expansion: evaluates expressions of a spec on symbolic operands. Numbers become exact polynomials in the operands'
// stored numbers; signs and truths become a decision.
#pragma once
#include "gen/algebra/operators.hpp"
#include "gen/lang/operators.hpp"
#include "gen/lower/expand/decision.hpp"
#include "gen/lower/expand/model.hpp"

#include <functional>
#include <memory>
#include <variant>

namespace meetc::lower {

struct value;
using list = std::vector<value>;

// An operand, or a part of one: a kind with values for what it stores. Its blade is computed on first use.
struct object {
  const lang::kind *kind;
  std::vector<value> fields;
  mutable std::unique_ptr<multivector> blade;
};

struct truth {
  int id;
};

struct value {
  std::variant<multivector, sign_value, truth, std::shared_ptr<const object>, std::shared_ptr<const list>> is;
  std::string text = {}; // the value in terms of the operands' names, "A.c"; "" where there is none
};

// A call of one predicate by another: the truth that it became, and each sign that the call took, in order.
struct predicate_call {
  int truth;
  const lang::predicate *callee;
  std::string text; // "segment_triangle(segment(A.a, A.b), B)"
  std::vector<sign_value> signs;
};

using environment = std::vector<std::pair<std::string, value>>; // for equal names the last entry counts

// An expansion that took more steps or more terms than it may. Where a value can be composed of its parts, it is.
struct too_long : spec_error {
  using spec_error::spec_error;
};
inline constexpr long most_steps = 2'000'000;      // far above any reasonable spec
inline constexpr std::size_t most_terms = 200'000; // the same

// Makes numbers that are no polynomials, as variables of the ring: 1/x, and the square root of x.
struct number_maker {
  virtual poly::poly reciprocal(const poly::poly &x, const location &where) = 0;
  virtual poly::poly root(const poly::poly &x, const location &where) = 0;
  virtual ~number_maker() = default;
};

class expander {
public:
  // `numbers` is the ring of all polynomials.
  expander(const model &m, const poly::ring &numbers, decision &signs);
  // Expands in the declared basis instead of the working one.
  expander(const model &m, const poly::ring &numbers, decision &signs, const metric &basis,
           std::vector<std::vector<rational>> declared_vectors);

  // An operand whose stored numbers are the ring's variables prefix + path ("X." + "c.x").
  value operand(const lang::kind &k, const std::string &prefix) const;
  // An operand whose stored numbers are those that `next` gives, in memory order.
  value operand(const lang::kind &k, const std::function<rational()> &next) const;
  // An operand whose blade has one variable for each basis blade: prefix + names[i] at blades[i].
  value general(const std::vector<blade> &blades, const std::vector<std::string> &names) const;

  value evaluate(const lang::expr &e, const environment &env);
  multivector evaluate_multivector(const lang::expr &e, const environment &env);
  multivector blade_of(const value &v, const location &where);
  poly::poly scalar_of(const multivector &m, const location &where) const; // throws where it is no number
  // `taken` receives the signs that the hit takes, in order.
  staged evaluate_predicate(const lang::predicate &p, const std::vector<value> &args, std::vector<sign_value> *taken);

  const metric &basis() const { return *basis_; }
  // Steps that expansion may take (most_steps where nothing is said), and those that it has taken.
  void limit(long steps) { limit_ = steps; }
  long steps() const { return steps_; }
  // Lets numbers have this many bits, for operands that are numbers themselves.
  void allow_bits(std::size_t most) { most_bits_ = most; }
  // Lets 0 be of any grade in the domain of a function, for operands that are numbers themselves.
  void allow_zero() { zero_allowed_ = true; }
  // Lets expressions divide by numbers and call sqrt.
  void allow(number_maker &roots) { roots_ = &roots; }
  // Throws where a call of `f` is not defined for these arguments.
  void check_domain(const lang::function &f, const std::vector<value> &args, const lang::expr &call);
  const std::vector<predicate_call> &calls() const { return calls_; }

private:
  const model &model_;
  const poly::ring &ring_;
  decision &signs_;
  const metric *basis_;
  std::vector<std::vector<rational>> declared_vectors_; // in the basis of expansion
  std::vector<std::pair<std::string, value>> constants_;
  std::vector<sign_value> taken_; // in order
  std::vector<predicate_call> calls_;
  long steps_ = 0, limit_ = most_steps;
  int depth_ = 0;
  number_maker *roots_ = nullptr;
  std::size_t most_bits_ = 4096; // of a constant, far above any reasonable spec
  bool zero_allowed_ = false;

  struct level; // counts the depth of evaluation

  bool holds_for_grades_of_zero(const lang::function &f, const std::vector<value> &args, const lang::expr &call);
  void charge(std::size_t work, const location &where); // throws when a spec asks for too much
  multivector number(const rational &q) const;
  value name(const lang::expr &e, const environment &env);
  value call(const lang::expr &e, const environment &env);
  value member(const lang::expr &e, const environment &env);
  value index(const lang::expr &e, const environment &env);
  void check_index(const lang::expr &e, const environment &env);
  value compare(const lang::expr &e, const environment &env);
  value quantify(const lang::expr &e, const environment &env);
  value arithmetic(const lang::expr &e, const environment &env);
  void charge_product(const multivector &x, const multivector &y, const location &where);
  value checked(const multivector &m, const location &where) const; // throws where it is too long or too large
  // Operators of the language.
  value builtin(const lang::builtin &of, const lang::expr &e, const environment &env);
  multivector pseudoscalar(const location &where);
  std::pair<multivector, rational> squared_pseudoscalar(const location &where);
  multivector complement(const multivector &m, bool right, const lang::expr &e);
  multivector inverse(const multivector &v, const lang::expr &of);
  int grade_of(const lang::expr &e, const environment &env);
  // From the basis of expansion, and into it.
  multivector in_declared(const multivector &m) const;
  multivector in_working(const multivector &m) const;
  multivector in_expansion(const multivector &declared) const;
  environment bind(const object &o) const;
  environment bind(const lang::predicate &p, const std::vector<value> &args, const location &where);
  int truth_of(const lang::expr &e, const environment &env);
  // The expression with its names replaced by what they stand for: "side(t, s.p)" becomes "side(B, A.a)".
  std::string said(const lang::expr &e, const environment &env);
  sign_value sign_of(const poly::poly &p); // records it in taken_
  static std::string describe(const value &v);
};

// A text of several lines as one, since it becomes a part of an emitted comment.
std::string on_one_line(const std::string &text);
// The expression that an operator stands for, by the parity of its versor. `call` is what the author wrote.
const lang::expr &body_of(const lang::builtin &of, algebra::parity versor, const lang::expr &call);
std::size_t versor_argument(const lang::builtin &of); // its place, and 0 where there is no versor

} // namespace meetc::lower
