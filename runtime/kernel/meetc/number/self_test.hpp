// Tests whether compiler and machine compute as the bounds assume, on the thread and in the unit that compute the
// answers.
//
// Most flags that break the arithmetic define a macro, and environment.hpp refuses them. Some define none
// (-fassociative-math with clang, -ftz=true with nvcc, pragmas), and a library linked with -ffast-math flushes
// subnormals for the whole process. self_test() detects their effects and names those that it finds. It allocates
// nothing, takes well below a microsecond, and tests only the calling thread and this translation unit's flags: code
// with other flags needs a test of its own.
#ifndef MEETC_NUMBER_SELF_TEST_HPP
#define MEETC_NUMBER_SELF_TEST_HPP

#include <meetc/number/double_double.hpp>

MEETC_NAMESPACE(meetc) {

// Bits of self_test().
enum class arithmetic_fault : unsigned {
  none = 0,
  excess_precision = 1,
  flushes_subnormals = 2,
  rounding = 4,
  reassociation = 8,
  fused_multiply_add = 16,
  comparisons = 32,
  two_sum = 64,
  two_product = 128,
  unmasked_exceptions = 256,
  division = 512,
};
inline constexpr unsigned fault_bits = 1023;

MEETC_HD constexpr const char *text_of(arithmetic_fault f) {
  switch (f) {
  case arithmetic_fault::none:
    return "the arithmetic is as the error bounds assume";
  case arithmetic_fault::flushes_subnormals:
    return "subnormal numbers are flushed to zero; a library linked with -ffast-math or nvcc's -ftz=true does that";
  case arithmetic_fault::rounding:
    return "results are not rounded to nearest";
  case arithmetic_fault::excess_precision:
    return "intermediate results are wider than their type; compile with -msse2 -mfpmath=sse";
  case arithmetic_fault::fused_multiply_add:
    return "fma() is not rounded once";
  case arithmetic_fault::reassociation:
    return "sums are reassociated; compile without -fassociative-math and -funsafe-math-optimizations";
  case arithmetic_fault::comparisons:
    return "comparisons with NaN or infinities are wrong; compile without -ffinite-math-only";
  case arithmetic_fault::division:
    return "divisions are products with reciprocals; compile without -freciprocal-math";
  case arithmetic_fault::two_sum:
    return "two_sum() is not exact";
  case arithmetic_fault::two_product:
    return "two_product() is not exact";
  case arithmetic_fault::unmasked_exceptions:
    return "floating-point exceptions are unmasked, and the rest was not tested; feenableexcept() does that";
  }
  return "an unknown fault";
}
// The text for the first fault in a set. The first is the likeliest cause of the others.
MEETC_HD constexpr const char *text_of_faults(unsigned faults) {
  for (unsigned bit = 1; bit & fault_bits; bit <<= 1)
    if (faults & bit)
      return text_of(static_cast<arithmetic_fault>(bit));
  return text_of(arithmetic_fault::none);
}

namespace self_test_parts {

// The value x, hidden from every compiler on host and device.
template <class T> MEETC_HD inline T hidden(T x) {
  volatile T y = x;
  return y;
}

// The constants of a format: the least normal and the least subnormal number, u = 2^-p, and a number 1 + h whose square
// needs two words.
template <class T> struct format { T least_normal, least, u, wide; };
MEETC_HD constexpr format<float> of(float) {
  return {0x1p-126F, 0x1p-149F, 0x1p-24F, 1 + 0x1p-12F};
}
MEETC_HD constexpr format<double> of(double) {
  return {0x1p-1022, 0x1p-1074, 0x1p-53, 1 + 0x1p-27};
}

template <class T> MEETC_HD inline bool keeps_subnormals() {
  constexpr format<T> f = of(T());
  const T normal = hidden(f.least_normal), least = hidden(f.least), zero = hidden(T(0));
  const T half = normal * hidden(T(0.5));
  return half > zero && half + half == normal && least > zero && least + least > least && normal - least < normal &&
         ::meetc::fma(normal, hidden(T(0.5)), zero) == half;
}

// 1 + u and 1 + 3u are ties, and each of the other rounding modes rounds some of these differently. For products, (1 +
// 2u)(1 - 2u) < 1.
template <class T> MEETC_HD inline bool rounds_to_nearest() {
  constexpr format<T> f = of(T());
  const T one = hidden(T(1)), u = hidden(f.u), two_u = hidden(2 * f.u);
  const T next = one + two_u;
  return one + u == one && -one - u == -one && next + u == one + hidden(4 * f.u) &&
         -next - u == -one - hidden(4 * f.u) && one + hidden(T(1.5) * f.u) == next && next * (one - two_u) == one &&
         next * (one + hidden(4 * f.u)) > next;
}

template <class T> MEETC_HD inline bool fuses() {
  constexpr format<T> f = of(T());
  const T a = hidden(f.wide), square = hidden(a * a), rest = ::meetc::fma(a, a, -square);
  // (1 + h)^2 = 1 + 2h + h^2, and rounding to nearest drops h^2 = u (float) or u/2 (double).
  return square == 1 + 2 * (a - 1) && rest == (f.wide - 1) * (f.wide - 1) && rest > 0;
}

// These expressions are not behind opaque(), so that a compiler simplifies them if it is allowed to.
template <class T> MEETC_HD inline bool keeps_order() {
  constexpr format<T> f = of(T());
  const T x = hidden(T(1)), big = hidden(1 / f.u * 4), small = hidden(f.u);
  const T first = (x + big) - big, second = (x + small) - x, third = (small - x) + x;
  // A sum in a loop, which reassociation would split into lanes; 1 absorbs every u.
  const T step = hidden(f.u);
  T sum = x;
  for (int i = 0; i < 16; ++i)
    sum += step;
  return first == 0 && second == 0 && third <= 2 * small && sum == x;
}

// x / y and (x + 1) / y, and x / y where y is a constant: a compiler that may multiply by reciprocals does so in both, and
// 10 times the rounded reciprocal of 49 is not their quotient.
template <class T> MEETC_HD inline bool divides() {
  constexpr T divisor = 49;
  const T x = hidden(T(10)), y = hidden(divisor), first = x / y, second = (x + 1) / y;
  return first == hidden(x) / hidden(y) && second == hidden(x + 1) / hidden(y) && x / divisor == first &&
         (x + 1) / divisor == second;
}

template <class T> MEETC_HD inline bool compares() {
  const T zero = hidden(T(0)), inf = hidden(T(1)) / zero, nan = inf - inf;
  return !(nan > zero) && !(nan < zero) && !(nan == nan) && nan != nan && !(inf <= zero) && inf > hidden(T(1)) &&
         !(zero * inf == zero) && !(nan <= inf);
}

MEETC_HD inline bool two_sum_is_exact() {
  constexpr double cases[][4] = {
      // a, b, and their sum in two words
      {1, 0x1p-60, 1, 0x1p-60},
      {0x1p-60, 1, 1, 0x1p-60},
      {1, 0x1p-53, 1, 0x1p-53},
      {1 + 0x1p-52, 0x1p-53, 1 + 0x1p-51, -0x1p-53},
      {0x1.fffffffffffffp0, 0x1.fffffffffffffp-1, 3 - 0x1p-51, 0x1p-53},
      {1, -1 + 0x1p-53, 0x1p-53, 0},
      {-0x1p100, 3, -0x1p100, 3},
      {0x1p-1074, 1, 1, 0x1p-1074},
  };
  bool exact = true;
  for (const auto &c : cases) {
    const double_double s = ::meetc::two_sum(hidden(c[0]), hidden(c[1]));
    exact = exact && s.hi == c[2] && s.lo == c[3];
  }
  // An incoming product must not be fused with the sum, because a a + b differs from fl(a a) + b.
  const double a = hidden(1 + 0x1p-30), b = hidden(-1.0);
  const double_double fused = ::meetc::two_sum(a * a, b);
  return exact && fused.hi == 0x1p-29 && fused.lo == 0;
}

MEETC_HD inline bool two_product_is_exact() {
  constexpr double cases[][4] = {
      {1 + 0x1p-52, 1 + 0x1p-52, 1 + 0x1p-51, 0x1p-104},
      {1 + 0x1p-30, 1 - 0x1p-30, 1, -0x1p-60},
      {0x1.fffffffffffffp0, 0x1.fffffffffffffp0, 0x1.ffffffffffffep1, 0x1p-104},
      {-3, 0x1p-300, -0x1.8p-299, 0},
      {0x1p500 + 0x1p448, 0x1p-500 + 0x1p-552, 1 + 0x1p-51, 0x1p-104},
  };
  bool exact = true;
  for (const auto &c : cases) {
    const double_double p = ::meetc::two_product(hidden(c[0]), hidden(c[1]));
    exact = exact && p.hi == c[2] && p.lo == c[3];
  }
  return exact;
}

} // namespace self_test_parts

// The faults of this thread's arithmetic, as bits; 0 if there are none.
MEETC_HD inline unsigned self_test() {
  namespace parts = self_test_parts;
#if !defined(__CUDA_ARCH__)
  if (!exceptions_are_masked()) // the tests below divide by zero
    return static_cast<unsigned>(arithmetic_fault::unmasked_exceptions);
#endif
  unsigned faults = 0;
  const auto require = [&faults](bool holds, arithmetic_fault f) { faults |= holds ? 0U : static_cast<unsigned>(f); };
  require(parts::keeps_subnormals<float>() && parts::keeps_subnormals<double>(), arithmetic_fault::flushes_subnormals);
  require(parts::rounds_to_nearest<float>() && parts::rounds_to_nearest<double>(), arithmetic_fault::rounding);
#if defined(__FLT_EVAL_METHOD__) && !defined(__CUDA_ARCH__)
  require(__FLT_EVAL_METHOD__ == 0 || __FLT_EVAL_METHOD__ == 16,
          arithmetic_fault::excess_precision); // 16 concerns only _Float16
#endif
  require(parts::fuses<float>() && parts::fuses<double>() && fma_rounds_once(), arithmetic_fault::fused_multiply_add);
  require(parts::keeps_order<float>() && parts::keeps_order<double>() && keeps_order_of_sums(),
          arithmetic_fault::reassociation);
  require(parts::divides<float>() && parts::divides<double>(), arithmetic_fault::division);
  require(parts::compares<float>() && parts::compares<double>() && keeps_nan_and_infinity(),
          arithmetic_fault::comparisons);
  require(parts::two_sum_is_exact(), arithmetic_fault::two_sum);
  require(parts::two_product_is_exact(), arithmetic_fault::two_product);
  return faults;
}

#if defined(__CUDACC__)
// The same on a device: one thread writes the faults to *faults, device memory. It is a template, so that it can stand
// in a header.
template <int = 0> __global__ void self_test_kernel(unsigned *faults) {
  *faults = self_test();
}
inline cudaError_t launch_self_test(unsigned *faults, cudaStream_t stream) {
  self_test_kernel<><<<1, 1, 0, stream>>>(faults);
  return cudaGetLastError();
}
#endif

} // MEETC_NAMESPACE(meetc)

#endif
