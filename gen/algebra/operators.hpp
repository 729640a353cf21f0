// Operators that map basis blades to multiples of basis blades, and the symmetric inner product.
#pragma once
#include "gen/algebra/multivector.hpp"

namespace meetc::algebra {

// f(b): the blade that becomes of b, with its weight.
template <class C, class F> multivector<C> mapped(const multivector<C> &a, F &&f) {
  multivector<C> out;
  for (const auto &[at, c] : a.terms()) {
    const blade_term to = f(at);
    out.add(to.at, c.scaled(to.weight));
  }
  return out;
}

template <class C> multivector<C> reverse(const multivector<C> &a) {
  return mapped(a, [](blade b) { return blade_term{b, grade(b) % 4 < 2 ? 1 : -1}; });
}
template <class C> multivector<C> involute(const multivector<C> &a) {
  return mapped(a, [](blade b) { return blade_term{b, grade(b) % 2 == 0 ? 1 : -1}; });
}
template <class C> multivector<C> conjugate(const multivector<C> &a) {
  return involute(reverse(a));
}
template <class C> multivector<C> grade_part(const multivector<C> &a, int k) {
  multivector<C> out;
  for (const auto &[at, c] : a.terms())
    if (grade(at) == k)
      out.add(at, c);
  return out;
}

// b ^ right_complement(b) = i for each basis blade b of the basis m of `a`; i is a multiple of the pseudoscalar.
template <class C> multivector<C> right_complement(const metric &m, const multivector<C> &a, const blade_term &i) {
  return mapped(a, [&](blade b) -> blade_term { return {i.at & ~b, i.weight * m.outer_sign(b, i.at & ~b)}; });
}
// left_complement(b) ^ b = i.
template <class C> multivector<C> left_complement(const metric &m, const multivector<C> &a, const blade_term &i) {
  return mapped(a, [&](blade b) -> blade_term { return {i.at & ~b, i.weight * m.outer_sign(i.at & ~b, b)}; });
}

// The part of grade |r - s| of the product of grades r and s.
template <class C> multivector<C> dot(const metric &m, const multivector<C> &a, const multivector<C> &b) {
  return product(m, a, b, [](blade x, blade y, blade z) {
    return grade(z) == grade(y) - grade(x) || grade(z) == grade(x) - grade(y);
  });
}

// Whether all grades of the terms, a map from blades, are even or all are odd; mixed else. Zero is even.
enum class parity { even, odd, mixed };
template <class Terms> parity parity_of(const Terms &terms) {
  bool even = false, odd = false;
  for (const auto &[at, c] : terms)
    (grade(at) % 2 == 0 ? even : odd) = true;
  return even && odd ? parity::mixed : odd ? parity::odd : parity::even;
}

} // namespace meetc::algebra
