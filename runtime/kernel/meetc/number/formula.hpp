// The numbers of emitted formulas: any type with +, - and *, whose values may be expression templates of that type.
//
// A type of its own may say more by functions of its namespace or by a specialisation:
//   multiply_add(a, b, c)   a b + c, rounded once; without it, formulas take a product and a sum
//   meetc::holds_half<T>    whether 1/2 is a value of T, as formulas with fractions need, where the tests below cannot tell
#ifndef MEETC_NUMBER_FORMULA_HPP
#define MEETC_NUMBER_FORMULA_HPP

#include <meetc/environment/version.hpp>
#include <meetc/number/constant_fma.hpp>

#include <limits>
#include <type_traits>

MEETC_NAMESPACE(meetc) {

// ---- which types ----

// Vectors of the compiler (vector_size of gcc and clang).
template <class T>
inline constexpr bool is_vector = !std::is_class_v<T> && !std::is_pointer_v<T> && !std::is_array_v<T> && requires(T v) {
  v[0];
  v + v;
};
// The types of the language, on which formulas throw nothing.
template <class T> inline constexpr bool is_built_in = std::is_arithmetic_v<T> || is_vector<T>;

template <class V> using lane_of = std::remove_cvref_t<decltype((*static_cast<V *>(nullptr))[0])>;

template <class T> MEETC_HD constexpr bool tells_half() {
  if constexpr (is_vector<T>)
    return tells_half<lane_of<T>>();
  else if constexpr (std::numeric_limits<T>::is_specialized)
    return !std::numeric_limits<T>::is_integer;
  else if constexpr (requires { typename std::bool_constant<(T(1) / T(2) == T(0))>; })
    return !(T(1) / T(2) == T(0));
  else
    return true; // not evaluated by the compiler
}
template <class T> inline constexpr bool holds_half = tells_half<T>();

// ---- constants ----

template <class T, class Integer> MEETC_HD MEETC_INLINE constexpr T number(Integer k) {
  if constexpr (is_vector<T>)
    return T{} + static_cast<lane_of<T>>(k);
  else
    return T(k);
}
template <class T, class Integer> MEETC_HD MEETC_INLINE constexpr T ratio(Integer a, Integer b) {
  static_assert(holds_half<T>, "this formula divides; integers would round the quotient: use float or double");
  return number<T>(a) / number<T>(b);
}

// ---- a b + c ----

namespace of_its_namespace {
void multiply_add(); // hides all others, so that the type's own namespace is searched
template <class T>
concept multiplies_and_adds = requires(const T &x) {
  T(multiply_add(x, x, x));
};
template <class T> MEETC_HD MEETC_INLINE constexpr T call(const T &a, const T &b, const T &c) {
  return multiply_add(a, b, c);
}
} // namespace of_its_namespace

// Formulas promise a bound and not the same bits everywhere: of float and double, and of vectors of these, this is rounded
// once if the target has the instruction, else a product and a sum, since fma() is then a call that takes as long as twenty
// products. Compilers make one instruction of the loop.
#if defined(__FMA__) || defined(__FMA4__) || defined(__aarch64__) || defined(__CUDA_ARCH__)
inline constexpr bool has_instruction = true;
#else
inline constexpr bool has_instruction = false;
#endif
template <class T>
inline constexpr bool is_fused = has_instruction && (std::is_same_v<T, float> || std::is_same_v<T, double>);

template <class T>
MEETC_HD MEETC_INLINE constexpr T multiply_add(const std::type_identity_t<T> &a, const std::type_identity_t<T> &b,
                                               const std::type_identity_t<T> &c) {
  if constexpr (is_fused<T>) {
    if (__builtin_is_constant_evaluated())
      return constant_fma(a, b, c);
    if constexpr (std::is_same_v<T, float>)
      return __builtin_fmaf(a, b, c);
    else
      return __builtin_fma(a, b, c);
  } else if constexpr (is_vector<T>) {
    if constexpr (is_fused<lane_of<T>>) {
      T sum{};
      for (unsigned k = 0; k < sizeof(T) / sizeof(lane_of<T>); ++k)
        sum[k] = multiply_add<lane_of<T>>(a[k], b[k], c[k]);
      return sum;
    } else {
      return a * b + c;
    }
  } else if constexpr (of_its_namespace::multiplies_and_adds<T>) {
    return of_its_namespace::call<T>(a, b, c);
  } else {
    return static_cast<T>(a * b + c);
  }
}

} // MEETC_NAMESPACE(meetc)

#endif
