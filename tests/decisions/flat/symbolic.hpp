// The emitted decisions as formulas: the very functions of the headers, run on signs that are names.
//
// Include this before any header of a predicate: those name the connectives as ::meetc::both and so on, and
// see only what was declared before them.
//
// A formula is kept in a form that depends neither on the order, the grouping nor the repetition of what
// `both` and `either` join. One form, then, means one truth for all signs whatever; the converse is not
// needed. This is written without the compiler's own decision graphs, which it judges.
#ifndef MEETC_TESTS_DECISIONS_SYMBOLIC_HPP
#define MEETC_TESTS_DECISIONS_SYMBOLIC_HPP

#ifdef MEETC_3_cga_kernel_triangle_triangle_HPP
#error "include symbolic.hpp before the headers of predicates"
#endif

#include <meetc/support.hpp>

#include <vector>

namespace meetc::decisions_test {

using formula = int; // a number a form

formula constant(bool value);
// Whether the product of these atoms is in the mask (1 negative, 2 zero, 4 positive).
formula test(std::vector<int> atoms, int mask);
formula all_of(std::vector<formula> parts);
formula any_of(std::vector<formula> parts);
formula negation(formula f);
// What an any_of joins; a formula of another kind alone.
std::vector<formula> alternatives(formula f);
// What is left of f where none of these formulas is true.
formula where_false(formula f, const std::vector<formula> &untrue);

} // namespace meetc::decisions_test

namespace meetc {

struct symbolic_sign {
  int unit;               // 1 or -1
  std::vector<int> atoms; // their product
};
struct symbolic_truth {
  meetc::decisions_test::formula form;
};

inline symbolic_sign operator-(symbolic_sign s) {
  s.unit = -s.unit;
  return s;
}
inline symbolic_sign operator*(symbolic_sign a, const symbolic_sign &b) {
  a.unit *= b.unit;
  a.atoms.insert(a.atoms.end(), b.atoms.begin(), b.atoms.end());
  return a;
}
template <int Mask> symbolic_truth in(const symbolic_sign &s) {
  constexpr int negated = (Mask & 2) | (Mask & 1) << 2 | (Mask & 4) >> 2;
  return {meetc::decisions_test::test(s.atoms, s.unit > 0 ? Mask : negated)};
}
inline symbolic_truth both(symbolic_truth a, symbolic_truth b) {
  return {meetc::decisions_test::all_of({a.form, b.form})};
}
inline symbolic_truth either(symbolic_truth a, symbolic_truth b) {
  return {meetc::decisions_test::any_of({a.form, b.form})};
}
inline symbolic_truth negate(symbolic_truth a) {
  return {meetc::decisions_test::negation(a.form)};
}

} // namespace meetc

#endif
