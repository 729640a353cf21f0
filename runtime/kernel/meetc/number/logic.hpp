// Signs, sets of signs and three-valued truth. Host and device, branch-free.
#ifndef MEETC_NUMBER_LOGIC_HPP
#define MEETC_NUMBER_LOGIC_HPP

#include <meetc/environment/environment.hpp>

#include <cstdint>
#include <type_traits>

namespace meetc {

enum class sign : signed char { negative = -1, zero = 0, positive = 1 };

// The answer of a decision under one rung. `unsure` goes to the next rung.
enum class answer : std::uint8_t { no = 0, yes = 1, unsure = 2 };

} // namespace meetc

MEETC_NAMESPACE(meetc) {

MEETC_HD MEETC_INLINED constexpr sign operator-(sign s) {
  return static_cast<sign>(-static_cast<int>(s));
}
MEETC_HD MEETC_INLINED constexpr sign operator*(sign a, sign b) {
  return static_cast<sign>(static_cast<int>(a) * static_cast<int>(b));
}
MEETC_HD MEETC_INLINED constexpr sign square(sign s) {
  return s * s;
}

// The signs that a value can have, as a rung with an error bound knows it. Bit 0: negative, bit 1: zero, bit 2:
// positive.
struct sign_set {
  std::uint8_t bits;
  MEETC_HD static constexpr sign_set all() { return {7}; }
  MEETC_HD static constexpr sign_set of(sign s) { return {static_cast<std::uint8_t>(1 << (static_cast<int>(s) + 1))}; }
};
MEETC_HD MEETC_INLINED constexpr sign_set operator-(sign_set s) {
  return {static_cast<std::uint8_t>((s.bits & 2) | (s.bits & 1) << 2 | s.bits >> 2)};
}
MEETC_HD MEETC_INLINED constexpr sign_set operator*(sign_set a, sign_set b) {
  const unsigned x = a.bits, y = b.bits;
  const unsigned n = ((x & y >> 2) | (x >> 2 & y)) & 1, z = (x | y) >> 1 & 1, p = ((x & y) | (x & y) >> 2) & 1;
  return {static_cast<std::uint8_t>(n | z << 1 | p << 2)};
}

MEETC_HD MEETC_INLINED constexpr sign_set square(sign_set s) {
  return {static_cast<std::uint8_t>((s.bits & 2) | ((s.bits & 5) != 0) << 2)};
}

MEETC_HD MEETC_INLINED constexpr bool is_known(sign_set s) {
  return s.bits == 1 || s.bits == 2 || s.bits == 4;
}
// The sign in a set of one.
MEETC_HD MEETC_INLINED constexpr sign known_sign(sign_set s) {
  return static_cast<sign>((s.bits >> 2) - (s.bits & 1));
}

template <class S> MEETC_HD MEETC_INLINED constexpr S constant_sign(sign s) {
  if constexpr (std::is_same_v<S, sign>)
    return s;
  else
    return S::of(s);
}

// A three-valued truth. Bit 0: it can be false; bit 1: it can be true.
struct truth {
  std::uint8_t bits;
  MEETC_HD constexpr bool can_be_true() const { return (bits & 2) != 0; }
  MEETC_HD constexpr bool can_be_false() const { return (bits & 1) != 0; }
};

// A truth of which nothing is known.
MEETC_HD MEETC_INLINED constexpr truth unknown() {
  return {3};
}

// Branch-free connectives for bool and truth alike (strong Kleene logic).
MEETC_HD MEETC_INLINED constexpr bool both(bool a, bool b) {
  return static_cast<bool>(a & b);
}
MEETC_HD MEETC_INLINED constexpr bool either(bool a, bool b) {
  return static_cast<bool>(a | b);
}
MEETC_HD MEETC_INLINED constexpr bool negate(bool a) {
  return !a;
}
MEETC_HD MEETC_INLINED constexpr truth both(truth a, truth b) {
  return {static_cast<std::uint8_t>(((a.bits | b.bits) & 1) | (a.bits & b.bits & 2))};
}
MEETC_HD MEETC_INLINED constexpr truth either(truth a, truth b) {
  return {static_cast<std::uint8_t>((a.bits & b.bits & 1) | ((a.bits | b.bits) & 2))};
}
MEETC_HD MEETC_INLINED constexpr truth negate(truth a) {
  return {static_cast<std::uint8_t>((a.bits & 1) << 1 | a.bits >> 1)};
}
// Makes a plain bool, the truth of a branch that is always taken, one that combines with truths.
MEETC_HD MEETC_INLINED constexpr truth to_truth(truth a) {
  return a;
}
MEETC_HD MEETC_INLINED constexpr truth to_truth(bool a) {
  return {static_cast<std::uint8_t>(a ? 2 : 1)};
}
MEETC_HD MEETC_INLINED constexpr truth both(truth a, bool b) {
  return both(a, to_truth(b));
}
MEETC_HD MEETC_INLINED constexpr truth both(bool a, truth b) {
  return both(to_truth(a), b);
}
MEETC_HD MEETC_INLINED constexpr truth either(truth a, bool b) {
  return either(a, to_truth(b));
}
MEETC_HD MEETC_INLINED constexpr truth either(bool a, truth b) {
  return either(to_truth(a), b);
}
// For three and more operands, from the left.
template <class A, class B, class C, class... More>
MEETC_HD MEETC_INLINED constexpr auto both(A a, B b, C c, More... more) {
  return both(both(a, b), c, more...);
}
template <class A, class B, class C, class... More>
MEETC_HD MEETC_INLINED constexpr auto either(A a, B b, C c, More... more) {
  return either(either(a, b), c, more...);
}
template <class C, class A, class B> MEETC_HD MEETC_INLINED constexpr auto choose(C condition, A then, B otherwise) {
  return either(both(condition, then), both(negate(condition), otherwise));
}
MEETC_HD MEETC_INLINED constexpr bool can_be_true(bool a) {
  return a;
}
MEETC_HD MEETC_INLINED constexpr bool can_be_true(truth a) {
  return a.can_be_true();
}
MEETC_HD MEETC_INLINED constexpr bool can_be_false(bool a) {
  return !a;
}
MEETC_HD MEETC_INLINED constexpr bool can_be_false(truth a) {
  return a.can_be_false();
}
MEETC_HD MEETC_INLINED constexpr answer to_answer(bool a) {
  return a ? answer::yes : answer::no;
}
MEETC_HD MEETC_INLINED constexpr answer to_answer(truth a) {
  return a.bits == 3 ? answer::unsure : a.can_be_true() ? answer::yes : answer::no;
}

// Whether a sign lies in the mask (1 negative, 2 zero, 4 positive). This is the comparison < 0, <= 0, == 0 and so on.
template <int Mask> MEETC_HD MEETC_INLINED constexpr bool in(sign s) {
  return (Mask >> (static_cast<int>(s) + 1) & 1) != 0;
}
template <int Mask> MEETC_HD MEETC_INLINED constexpr truth in(sign_set s) {
  return {static_cast<std::uint8_t>(((s.bits & ~Mask & 7) != 0) | ((s.bits & Mask) != 0) << 1)};
}

// The same by name, as emitted decisions write it.
template <class S> MEETC_HD MEETC_INLINED constexpr auto below_zero(S s) {
  return in<1>(s);
}
template <class S> MEETC_HD MEETC_INLINED constexpr auto is_zero(S s) {
  return in<2>(s);
}
template <class S> MEETC_HD MEETC_INLINED constexpr auto at_most_zero(S s) {
  return in<3>(s);
}
template <class S> MEETC_HD MEETC_INLINED constexpr auto above_zero(S s) {
  return in<4>(s);
}
template <class S> MEETC_HD MEETC_INLINED constexpr auto not_zero(S s) {
  return in<5>(s);
}
template <class S> MEETC_HD MEETC_INLINED constexpr auto at_least_zero(S s) {
  return in<6>(s);
}

} // MEETC_NAMESPACE(meetc)

#endif
