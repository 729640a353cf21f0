// Exact numbers that the emitted stages run on, as they run on float and on integers: polynomials in the
// stored numbers, which shows what a stage computes, and rationals, which gives exact signs.
#ifndef MEETC_TESTS_DECISIONS_ROUND_EXACT_HPP
#define MEETC_TESTS_DECISIONS_ROUND_EXACT_HPP

#include "gen/poly/poly.hpp"

#include <type_traits>
#include <utility>

namespace meetc::decisions_round {

using poly::rational;
using polynomial = poly::poly;

// V is a polynomial or a rational. Emitted code only needs a number that can be made from 0, added and
// multiplied. A wrapper is needed because operators of GMP return expressions and a polynomial needs its ring.
template <class V> class exact {
public:
  V value;

  exact() : exact(0) {}
  explicit exact(int k) : value(make(k)) {}
  explicit exact(V v) : value(std::move(v)) {}

  // The ring of polynomials that are made from integers.
  inline static const poly::ring *ring = nullptr;

  friend exact operator+(const exact &a, const exact &b) { return exact(V(a.value + b.value)); }
  friend exact operator-(const exact &a, const exact &b) { return exact(V(a.value - b.value)); }
  friend exact operator*(const exact &a, const exact &b) { return exact(V(a.value * b.value)); }
  friend exact operator-(const exact &a) { return exact(0) - a; }
  friend bool operator<(const exact &a, const exact &b) { return a.value < b.value; }
  friend bool operator>(const exact &a, const exact &b) { return a.value > b.value; }

private:
  static V make(int k) {
    if constexpr (std::is_same_v<V, polynomial>)
      return polynomial(*ring, k);
    else
      return V(k);
  }
};

} // namespace meetc::decisions_round

#endif
