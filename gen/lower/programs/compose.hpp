// Values of an expression, computed from values of its parts.
//
// Problem: the expansion of a product of products in the operands' numbers grows exponentially with its depth, while
// the program that its author wrote grows with its length.
// Method: an expression is expanded over the values that its names stand for, and each coefficient becomes a Horner
// scheme, as long as it is short. If it is long, its parts become values of the program first: the arguments of a call,
// and then the operands of each product in the body of the function. The rest is expanded over those. Constants and
// signs are not hidden in values, so that they still simplify the expressions that hold them.
// An expression that is short takes the cheapest program: expanded, found by a search (searched_forms.hpp), or as its
// author wrote it.
// Limits: relations between the values of parts are lost. A coefficient can therefore be zero without being seen as
// zero: the arguments of a function with a domain, which asks for their grades, are rid of these, and the caller drops
// the others.
#pragma once
#include "gen/lower/expand/expand.hpp"
#include "gen/lower/programs/build.hpp"

namespace meetc::lower {

using node_values = std::map<blade, node_id>; // a multivector by its coefficients

// The coefficients that are not zero for all inputs (gen/ir/residue.hpp).
node_values without_zeros(const builder &code, const node_values &v);

// The parts that become values: those whose expansion is long; also the arguments of the outermost call; all.
enum class parts { long_ones, arguments, all };

class composer {
public:
  // Programs are built by `code`. For `searched`, polynomials in the inputs, the caller has searched.
  composer(const model &m, builder &code, parts which, std::vector<poly::poly> searched = {})
      : model_(m), code_(code), parts_(which), searched_(std::move(searched)) {}

  using scope = std::vector<std::pair<std::string, node_values>>;
  // Throws too_long where even the parts take too many steps, and spec_error for all mistakes that expansion finds.
  node_values compose(const lang::expr &e, const scope &names);

  // A value whose coefficients are inputs of the program, from `first` on.
  static node_values inputs(builder &code, const std::vector<blade> &blades, int first);

private:
  const model &model_;
  builder &code_;
  parts parts_;
  std::vector<poly::poly> searched_;
  long steps_ = 0;
  std::map<node_id, int> degrees_; // in the inputs; 1 where nothing is said
  // Composed values, by the expression and the values of the names in it.
  std::map<std::pair<const lang::expr *, scope>, node_values> known_;

  node_values composed(const lang::expr &e, const scope &names);
  node_values expanded(const lang::expr &e, const scope &names, long most_steps, bool is_short);
  // The cheaper of two programs of the coefficients of x, which is x where they cost the same or y lacks one.
  node_values cheaper(const node_values &x, const node_values &y) const;
  node_values of_parts(const lang::expr &e, const scope &names);
  node_values of_call(const lang::expr &e, const scope &names);
  node_values of_builtin(const lang::builtin &of, const lang::expr &e, const scope &names);
  bool is_value(const lang::expr &e) const;
  void charge(long steps, const location &where);
  int degree(node_id id) const;
};

} // namespace meetc::lower
