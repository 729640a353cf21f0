// The emitted decisions as formulas: the functions of the headers, run on symbolic signs.
//
// Include this before any header of a predicate: those name the connectives ::meetc::both and so on, and see
// only what was declared before them.
//
// A formula is kept in a form that depends neither on the order, the grouping nor the repetition of what
// `both` and `either` join. Equal forms therefore mean equal truths for all signs; the converse is not
// needed. This does not use the decision graphs of the compiler, which it checks.
#ifndef MEETC_TESTS_DECISIONS_SYMBOLIC_HPP
#define MEETC_TESTS_DECISIONS_SYMBOLIC_HPP

#ifdef MEETC_3_cga_kernel_triangle_triangle_HPP
#error "include symbolic.hpp before the headers of predicates"
#endif

#include <meetc/support.hpp>

#include <vector>

namespace meetc::decisions_test {

using formula = int; // the number of a form

formula constant(bool value);
// Whether the product of these atoms is in the mask (1 negative, 2 zero, 4 positive).
formula test(std::vector<int> atoms, int mask);
formula all_of(std::vector<formula> parts);
formula any_of(std::vector<formula> parts);
formula negation(formula f);
// The parts of an any_of, or the formula itself if it is of another kind.
std::vector<formula> alternatives(formula f);
// The rest of f if none of these formulas is true.
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
