// CUDA's functions for device code, on the host: included by host_warp.hpp, whose threads call them.
#ifndef MEETC_TESTS_HOST_FUNCTIONS_HPP
#define MEETC_TESTS_HOST_FUNCTIONS_HPP

template <class T> T __shfl_sync(unsigned mask, T value, unsigned lane) {
  return host_warp::of_lane(mask, "shfl", value, lane);
}
template <class T> T __shfl_xor_sync(unsigned mask, T value, int with) {
  return host_warp::of_lane(mask, "shfl_xor", value, host_warp::lane() ^ static_cast<unsigned>(with));
}
template <class T> T __shfl_up_sync(unsigned mask, T value, unsigned by) {
  const unsigned lane = host_warp::lane();
  return host_warp::of_lane(mask, "shfl_up", value, lane < by ? lane : lane - by);
}
inline unsigned __ballot_sync(unsigned mask, bool holds) {
  return host_warp::joined(mask, "ballot", static_cast<unsigned>(holds) << host_warp::lane(), std::bit_or<>());
}
inline int __any_sync(unsigned mask, bool holds) {
  return __ballot_sync(mask, holds) != 0;
}
inline int __reduce_min_sync(unsigned mask, int value) {
  return host_warp::joined(mask, "reduce_min", value, [](int x, int y) { return std::min(x, y); });
}
inline int __reduce_max_sync(unsigned mask, int value) {
  return host_warp::joined(mask, "reduce_max", value, [](int x, int y) { return std::max(x, y); });
}
template <class T> unsigned __match_any_sync(unsigned mask, T value) {
  const std::uint64_t *const all =
      host_warp::the_blocks.meet(host_warp::scope::warp, "match_any", host_warp::bits_of(value), mask);
  unsigned alike = 0;
  for (unsigned i = 0; i < host_warp::width; ++i)
    alike |= (mask >> i & 1) != 0 && all[i] == host_warp::bits_of(value) ? 1U << i : 0;
  return alike;
}
inline void __syncwarp() {
  host_warp::the_blocks.meet(host_warp::scope::warp, "syncwarp", 0);
}
inline void __syncthreads() {
  host_warp::the_blocks.meet(host_warp::scope::block, "syncthreads", 0);
}
inline int __syncthreads_or(int holds) {
  host_warp::the_blocks.meet(host_warp::scope::block, "syncthreads_or", holds != 0);
  const std::uint64_t *const all = host_warp::the_blocks.of_block();
  return std::any_of(all, all + host_warp::the_blocks.threads(), [](std::uint64_t v) { return v != 0; });
}
inline void __threadfence() {}
inline void __threadfence_system() {}
#undef __shared__
#define __shared__ static
template <class T> T __ldcg(const T *from) {
  return *from;
}
template <class T> T __ldg(const T *from) {
  return *from;
}
inline int __clz(int x) {
  return std::countl_zero(static_cast<unsigned>(x));
}
inline unsigned __umulhi(unsigned x, unsigned y) {
  return static_cast<unsigned>(static_cast<std::uint64_t>(x) * y >> 32);
}
inline unsigned __popc(unsigned x) {
  return static_cast<unsigned>(std::popcount(x));
}
inline unsigned __ffs(unsigned x) {
  return x == 0 ? 0 : static_cast<unsigned>(std::countr_zero(x)) + 1;
}
inline float __fdividef(float x, float y) {
  return x / y;
}
inline float __fmaf_rn(float x, float y, float z) {
  return std::fma(x, y, z);
}
inline float __saturatef(float x) { // NaN becomes 0
  return std::fmin(std::fmax(x, 0.0F), 1.0F);
}
inline int __float_as_int(float x) {
  return std::bit_cast<int>(x);
}
inline float __int_as_float(int x) {
  return std::bit_cast<float>(x);
}
inline unsigned __float_as_uint(float x) {
  return std::bit_cast<unsigned>(x);
}
inline float __uint_as_float(unsigned x) {
  return std::bit_cast<float>(x);
}
template <class T, class Change> T host_atomic(T *at, Change change) {
  const T before = *at;
  *at = static_cast<T>(change(before));
  return before;
}
template <class T> T atomicAdd(T *at, std::type_identity_t<T> n) {
  return host_atomic(at, [n](T before) { return before + n; });
}
template <class T> T atomicMax(T *at, std::type_identity_t<T> n) {
  return host_atomic(at, [n](T before) { return std::max(before, n); });
}
template <class T> T atomicMin(T *at, std::type_identity_t<T> n) {
  return host_atomic(at, [n](T before) { return std::min(before, n); });
}
template <class T> T atomicOr(T *at, std::type_identity_t<T> n) {
  return host_atomic(at, [n](T before) { return before | n; });
}
template <class T> T atomicCAS(T *at, std::type_identity_t<T> expected, std::type_identity_t<T> n) {
  return host_atomic(at, [expected, n](T before) { return before == expected ? n : before; });
}
inline unsigned atomicInc(unsigned *at, unsigned most) {
  return host_atomic(at, [most](unsigned before) { return before >= most ? 0 : before + 1; });
}
inline double __dadd_rn(double x, double y) {
  return x + y;
}
inline double __dmul_rn(double x, double y) {
  return x * y;
}
inline float __double2float_rn(double x) {
  return static_cast<float>(x);
}
using std::max;
using std::min;

#endif
