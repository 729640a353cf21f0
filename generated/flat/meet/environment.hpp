// What the arithmetic of generated code takes for granted of compiler and machine, and how it is checked.
//
// Bounds assume IEEE 754 binary32 and binary64, round to nearest, gradual underflow, and that a sum is not
// reassociated. They do not mind whether a product and a sum are contracted to a fused multiply-add. Error-free
// transforms do mind: they stand behind opaque(), which no compiler looks through.
#ifndef MEET_ENVIRONMENT_HPP
#define MEET_ENVIRONMENT_HPP

#include <cstdint>

#if defined(__FAST_MATH__)
#error "meet: -ffast-math breaks error bounds and comparisons with NaN; compile without it"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "meet: -ffinite-math-only breaks comparisons with NaN and infinities; compile without it"
#endif
#if defined(__ASSOCIATIVE_MATH__) && __ASSOCIATIVE_MATH__
#error "meet: -fassociative-math breaks error bounds; compile without it"
#endif

#if defined(__CUDACC__)
#define MEET_HD __host__ __device__
#else
#define MEET_HD
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16 && !defined(__CUDA_ARCH__)
#error "meet: intermediate results are wider than their type; compile with -msse2 -mfpmath=sse"
#endif

// The rare paths are kept out of line, and rolled up on the device: they cost little time and save much code. On the
// device nothing is called out of line (see integers.hpp).
#if defined(__CUDA_ARCH__)
#define MEET_NOINLINE
#define MEET_ROLLED _Pragma("unroll 1")
#else
#define MEET_NOINLINE __attribute__((noinline))
#define MEET_ROLLED
#endif

namespace meet {

// The value x, of which the compiler knows nothing: what is computed from it is neither contracted nor reassociated
// with what it came from.
template <class T> MEET_HD inline T opaque(T x) {
#if defined(__CUDA_ARCH__)
  return x; // device code uses the intrinsics that are never contracted instead
#elif (defined(__GNUC__) || defined(__clang__)) && defined(__SSE2__)
  __asm__("" : "+x"(x));
  return x;
#elif (defined(__GNUC__) || defined(__clang__)) && defined(__aarch64__)
  __asm__("" : "+w"(x));
  return x;
#else
  volatile T y = x;
  return y;
#endif
}

// Whether sums stay in their order here. clang's -fassociative-math defines no macro that says so.
MEET_HD inline bool keeps_order() {
#if defined(__clang__) && !defined(__CUDA_ARCH__)
  const float x = opaque(1.0F), big = opaque(0x1p30F);
  return (x + big) - big == 0;
#else
  return true;
#endif
}

#if defined(__CUDA_ARCH__)
// The float with these bits, of which the front end knows nothing: it folds as if subnormals were always kept.
__device__ inline float float_of(std::uint32_t bits) {
  asm("" : "+r"(bits));
  return __uint_as_float(bits);
}
#endif

// Whether this thread rounds to nearest and keeps subnormals. A library linked with -ffast-math can have set
// flush-to-zero for the whole process; certified answers are then taken from the integers alone. On the device the
// flags of the compilation decide: -ftz=true and --use_fast_math define no macro, but they mark each operation. ptxas
// knows the marks and folds the difference to what the device would compute, so it costs nothing.
MEET_HD inline bool standard_environment() {
  if (!keeps_order())
    return false;
#if defined(__CUDA_ARCH__)
  return float_of(2) - float_of(1) > 0; // subnormals
#elif defined(__SSE2__)
  return (__builtin_ia32_stmxcsr() & 0xe040) == 0; // rounding control, flush-to-zero, denormals-are-zero
#elif defined(__aarch64__)
  std::uint64_t word;
  __asm__ volatile("mrs %0, fpcr" : "=r"(word));
  return (word & 0x3c00000) == 0; // RMode, FZ, DN
#else
  return true;
#endif
}

} // namespace meet

#endif
