// The assumptions of generated code about the compiler and the machine, and their checks.
//
// Bounds assume IEEE 754 binary32 and binary64, rounding to nearest, gradual underflow, an fma() that rounds once where
// it is used, NaN and infinities that are kept, and sums that are not reassociated. They hold whether or not a product
// and a sum are contracted to a fused multiply-add. Error-free transforms need it not to be: they stand behind opaque(),
// which no compiler sees through. docs/numerics.md lists each assumption with the place that checks it.
#ifndef MEETC_ENVIRONMENT_ENVIRONMENT_HPP
#define MEETC_ENVIRONMENT_ENVIRONMENT_HPP

#include <meetc/environment/control_word.hpp>

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

#if defined(__RECIPROCAL_MATH__) && __RECIPROCAL_MATH__
#error "meet: -freciprocal-math divides inexactly; compile without it"
#endif

static_assert(0x1.0000000000001p0 != 1, "meet: -fsingle-precision-constant shortens constants; compile without it");

#if defined(__CUDACC__)
#define MEETC_HD __host__ __device__
#else
#define MEETC_HD
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16 && !defined(__CUDA_ARCH__)
#error "meet: intermediate results are wider than their type; compile with -msse2 -mfpmath=sse"
#endif

// The rare paths are kept out of line, and rolled up on the device: they take little time, and inlining them costs much
// code. On the device nothing is called out of line (see bytecode.hpp).
//
// MEETC_INLINE marks the arithmetic for which a bound is claimed, and the checks of the compiler. Both must be compiled
// within the calling function, with its flags: a linker that finds two copies of an inline function keeps either, and
// the other may have been compiled under `#pragma GCC optimize("Ofast")`.
//
// MEETC_INLINED marks decisions over signs, which are a few instructions when inlined. MEETC_LARGE marks those of the
// rare case, which a host may call.
//
// With MEETC_PLAIN_INLINE the compiler chooses the functions that it inlines: units compile about five times faster and
// run slower. It is for programs all of whose units have the same flags for arithmetic, such as our own tests.
#if defined(__CUDA_ARCH__)
#define MEETC_NOINLINE
#define MEETC_INLINE inline
#define MEETC_INLINED __forceinline__
#define MEETC_LARGE __forceinline__
#define MEETC_ROLLED _Pragma("unroll 1")
#else
#define MEETC_NOINLINE __attribute__((noinline))
#if defined(MEETC_PLAIN_INLINE)
#define MEETC_INLINE inline
#define MEETC_INLINED inline
#else
#define MEETC_INLINE __attribute__((always_inline)) inline
#define MEETC_INLINED __attribute__((always_inline)) inline
#endif
#define MEETC_LARGE
#define MEETC_ROLLED
#endif

// Whether certified rungs use the fused multiply-add. If the processor's instruction is not compiled in, it is a call
// of the C library and takes as long as twenty products, so these rungs then run a schedule without it, under bounds of
// its own. Plain rungs always use it, since they give the same answers everywhere. Both compilations of a CUDA source
// must name the same device kernels, so its host code uses it as well.
#if defined(__FMA__) || defined(__FMA4__) || defined(__aarch64__) || defined(__CUDACC__)
#define MEETC_FUSES 1
#else
#define MEETC_FUSES 0
#endif

MEETC_NAMESPACE(meetc) {

// The value x, hidden from the compiler: arithmetic on the result is neither contracted nor reassociated with the
// arithmetic that computed x.
template <class T> MEETC_HD MEETC_INLINE T opaque(T x) {
#if defined(__CUDA_ARCH__)
  return x; // device code uses intrinsics, which are never contracted
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

// ---- the compiler ----

// Whether this function is compiled as the bounds assume. Flags that define a macro are refused above. Pragmas and
// attributes define none, nor do clang's -fno-honor-nans and -fassociative-math. An optimiser that is allowed such
// changes reduces the expressions below to constants, and one that is not cannot, so the checks leave no code if all is
// well. Without an optimiser (-O0) they prove nothing; the compiler is then assumed to compute the program as written.
// On the device standard_environment() tests the effect of the flags.
//
// No bool here is const, because the initialiser of a constant is evaluated before the optimiser runs.
MEETC_HD MEETC_INLINE bool keeps_nan_and_infinity() {
#if defined(__CUDA_ARCH__)
  return true;
#else
  float x = opaque(1.0F);
  bool nan_is_lost = __builtin_constant_p(x == x) || __builtin_constant_p(x - x);
  bool infinity_is_lost = __builtin_constant_p(x == __builtin_inff()) || __builtin_constant_p(x < __builtin_inff());
  return !nan_is_lost && !infinity_is_lost;
#endif
}
MEETC_HD MEETC_INLINE bool keeps_order_of_sums() {
#if defined(__CUDA_ARCH__)
  return true;
#else
  constexpr float big = 0x1p30F;
  float x = opaque(1.0F);
  bool reassociated = __builtin_constant_p((x + big) - x) || __builtin_constant_p((x + big) - big == x) ||
                      __builtin_constant_p(x * 3 * 5 == x * 15) || __builtin_constant_p(x + big + big == x + 2 * big);
#if defined(__clang__)
  // `#pragma clang fp reassociate(on)` folds none of these, since zeros keep their signs, but changes products.
  float y = opaque(1 + 0x1p-12F);
  reassociated = reassociated || y * 3 * 0.1F != opaque(y * 3) * 0.1F;
#endif
  return !reassociated;
#endif
}
MEETC_HD MEETC_INLINE bool compiled_as_written() {
  return keeps_nan_and_infinity() && keeps_order_of_sums();
}

#if !defined(__FMA__) && !defined(__FMA4__) && !defined(__aarch64__) && !defined(__CUDA_ARCH__)
// Whether the C library's fma() and fmaf() round once, on samples, in a standard environment. They are calls where the
// processor's own instruction is not compiled in. Each case fails under one way of rounding twice: through the type
// itself, through double, or through the 64 bits of the x87. A way that works near 1 may fail far from it.
MEETC_NOINLINE inline bool library_fma_rounds_once() {
  const float a = opaque(1 + 0x1p-12F); // a a = 1 + 2^-11 + 2^-24, half way between two floats
  bool single = __builtin_fmaf(a, a, opaque(0x1p-100F)) == 1 + 0x1p-11F + 0x1p-23F &&
                __builtin_fmaf(a, a, opaque(-0x1p-100F)) == 1 + 0x1p-11F;
  constexpr float scales[] = {0x1p-50F, 1, 0x1p50F};
  for (const float s : scales)
    single = single && __builtin_fmaf(a * s, a * s, opaque(-1 - 0x1p-11F) * s * s) == 0x1p-24F * s * s;
  const double b = opaque(1 + 0x1p-52), c = opaque(1 + 0x1p-27); // c c = 1 + 2^-26 + 2^-54, a quarter of a unit beyond
  constexpr double far_scales[] = {0x1p-420, 0x1p-150, 1, 0x1p150, 0x1p420};
  for (const double s : far_scales)
    single = single && __builtin_fma(b * s, b * s, opaque(-1 - 0x1p-51) * s * s) == 0x1p-104 * s * s;
  return single && __builtin_fma(c, c, opaque(-1 - 0x1p-26)) == 0x1p-54 &&
         __builtin_fma(c, opaque(1 - 0x1p-27), opaque(-1.0)) == -0x1p-54 &&
         __builtin_fma(opaque(1 + 0x1p-30), opaque(1 + 0x1p-23), opaque(0x1p-120)) == 1 + 0x1p-23 + 0x1p-30 + 0x1p-52;
}
inline int library_fma = 0; // 0: not tested, 1: it rounds once, 2: it does not
MEETC_NOINLINE inline bool look_at_library_fma() {
  const bool once = library_fma_rounds_once();
  __atomic_store_n(&library_fma, once ? 1 : 2, __ATOMIC_RELAXED);
  return once;
}
#endif

// Whether fma() rounds once. Plain rungs need that, and so do the certified ones of CUDA's host code. If it is a call,
// it is tested once in a process, or a few times if threads start together.
MEETC_HD MEETC_INLINE bool fma_rounds_once() {
#if defined(__FMA__) || defined(__FMA4__) || defined(__aarch64__) || defined(__CUDA_ARCH__)
  return true; // an instruction
#else
  const int known = __atomic_load_n(&library_fma, __ATOMIC_RELAXED);
  return known == 1 || (known == 0 && look_at_library_fma());
#endif
}

// The checks for each function that computes a value with a claimed bound.
MEETC_HD MEETC_INLINE bool computes_as_bounded() {
#if MEETC_FUSES
  return compiled_as_written() && fma_rounds_once();
#else
  return compiled_as_written();
#endif
}

// ---- the thread ----

#if defined(__CUDA_ARCH__)
// The float with these bits, hidden from the front end, which folds constants as if subnormals were always kept.
__device__ inline float float_of(std::uint32_t bits) {
  asm("" : "+r"(bits));
  return __uint_as_float(bits);
}
#endif

// Whether arithmetic here and now does what the bounds assume. A library linked with -ffast-math can have set
// flush-to-zero for the whole process; certified answers then come from the integers alone. On the device the flags of
// the compilation decide: -ftz=true and --use_fast_math define no macro, but they mark each operation. ptxas knows the
// marks and folds the difference to the device's result, so this costs nothing.
//
// The control word is tested first: until it is known, not even a probe may compute.
MEETC_HD MEETC_INLINE bool standard_environment() {
#if defined(__CUDA_ARCH__)
  return float_of(2) - float_of(1) > 0; // subnormals
#else
  return standard_control_word() && computes_as_bounded();
#endif
}

// p again, for use after a check of the environment: everything read through the result is read after the check.
// Otherwise compilers may move arithmetic across changes of the control word, since they do not know of its effect.
template <class T> MEETC_HD MEETC_INLINE const T *after_check(const T *p) {
#if !defined(__CUDA_ARCH__)
  __asm__ volatile("" : "+r"(p) : : "memory");
#endif
  return p;
}
// The answer, computed before anything that follows the call.
template <class T> MEETC_HD MEETC_INLINE T before_return(T answer) {
#if !defined(__CUDA_ARCH__)
  int word = static_cast<int>(answer);
  __asm__ volatile("" : "+r"(word));
  answer = static_cast<T>(word);
#endif
  return answer;
}

} // MEETC_NAMESPACE(meetc)

#endif
