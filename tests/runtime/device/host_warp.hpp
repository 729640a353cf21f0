// A stand-in for one warp, on the host: each of its 32 lanes is a context with a stack of its own, and a function of the
// whole warp is a rendezvous. A lane that misses a rendezvous, or is at another than its neighbours, is a failure. Between
// two of them lanes run to their end one after another, now from the first to the last, now from the last to the first:
// what one lane writes and another reads without a rendezvous between them is therefore read too early in one of the two.
//
// Included before the headers of device code, whose names for CUDA's functions it gives.
#ifndef MEETC_TESTS_HOST_WARP_HPP
#define MEETC_TESTS_HOST_WARP_HPP

#include <cuda_runtime_api.h>
#include <ucontext.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/common_interface_defs.h>
#endif

struct thread_index { // named, so that all files have one variable
  unsigned x;
};
inline thread_index threadIdx, blockIdx, blockDim{32}, gridDim{1};

namespace host_warp {

inline constexpr unsigned width = 32;

class warp {
public:
  // Runs `lane` in every lane until all have returned.
  void run(const std::function<void()> &lane) {
    lane_ = &lane;
    for (one &l : lanes_)
      start(l);
    for (bool forward = true; step(forward); forward = !forward) {
    }
  }

  // Where the lanes meet: each brings a value and sees those of all.
  const std::array<std::uint64_t, width> &meet(const char *where, std::uint64_t value) {
    one &l = lanes_[threadIdx.x];
    l.where = where, l.value = value;
    leave(l, false);
    return values_;
  }

private:
  struct one {
    ucontext_t context;
    std::vector<char> stack;
    const char *where;
    std::uint64_t value;
    bool done;
    void *shadow; // what AddressSanitizer keeps of a context
  };

  // getcontext() may return twice, so that nothing else is in this function.
  static void start(one &l) {
    l.stack.resize(std::size_t{1} << 18);
    l.done = false;
    getcontext(&l.context);
    l.context.uc_stack.ss_sp = l.stack.data();
    l.context.uc_stack.ss_size = l.stack.size();
    l.context.uc_link = nullptr;
    makecontext(&l.context, &warp::enter, 0);
  }

  // Runs every lane to its next rendezvous. Returns false when all have returned.
  bool step(bool forward) {
    for (unsigned i = 0; i < width; ++i) {
      threadIdx.x = forward ? i : width - 1 - i;
      one &l = lanes_[threadIdx.x];
#if defined(__SANITIZE_ADDRESS__)
      void *shadow = nullptr;
      __sanitizer_start_switch_fiber(&shadow, l.stack.data(), l.stack.size());
#endif
      swapcontext(&caller_, &l.context);
#if defined(__SANITIZE_ADDRESS__)
      __sanitizer_finish_switch_fiber(shadow, nullptr, nullptr);
#endif
    }
    for (unsigned i = 0; i < width; ++i) {
      if (lanes_[i].done != lanes_[0].done || (!lanes_[i].done && std::strcmp(lanes_[i].where, lanes_[0].where) != 0))
        throw std::logic_error("lanes of a warp do not meet");
      values_[i] = lanes_[i].value;
    }
    return !lanes_[0].done;
  }

  void leave(one &l, bool for_good) {
    l.done = for_good;
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_start_switch_fiber(for_good ? nullptr : &l.shadow, caller_stack_, caller_size_);
#endif
    swapcontext(&l.context, &caller_);
    arrive(l.shadow);
  }
  void arrive([[maybe_unused]] void *shadow) {
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_finish_switch_fiber(shadow, &caller_stack_, &caller_size_);
#endif
  }

  static void enter();

  const std::function<void()> *lane_ = nullptr;
  std::array<one, width> lanes_;
  std::array<std::uint64_t, width> values_{};
  ucontext_t caller_;
  const void *caller_stack_ = nullptr;
  std::size_t caller_size_ = 0;
};

inline warp the_warp;

inline void warp::enter() {
  the_warp.arrive(nullptr);
  (*the_warp.lane_)();
  the_warp.leave(the_warp.lanes_[threadIdx.x], true);
}

template <class T> std::uint64_t bits_of(T value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof value);
  return bits;
}
template <class T> T from_bits(std::uint64_t bits) {
  T value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}
inline void require_all(unsigned mask) {
  if (mask != ~0U)
    throw std::logic_error("only whole warps are stood in for");
}

// Of all lanes' values the one that comes first.
template <class Before> int least(unsigned mask, int value, Before before) {
  require_all(mask);
  for (const std::uint64_t bits : the_warp.meet("reduce", bits_of(value)))
    value = std::min(value, from_bits<int>(bits), before);
  return value;
}

} // namespace host_warp

// ---- CUDA's functions ----

template <class T> T __shfl_sync(unsigned mask, T value, unsigned lane) {
  host_warp::require_all(mask);
  return host_warp::from_bits<T>(host_warp::the_warp.meet("shfl", host_warp::bits_of(value))[lane % host_warp::width]);
}
template <class T> T __shfl_xor_sync(unsigned mask, T value, int with) {
  host_warp::require_all(mask);
  const unsigned lane = threadIdx.x ^ static_cast<unsigned>(with);
  return host_warp::from_bits<T>(host_warp::the_warp.meet("shfl_xor", host_warp::bits_of(value))[lane]);
}
template <class T> T __shfl_up_sync(unsigned mask, T value, unsigned by) {
  host_warp::require_all(mask);
  const unsigned lane = threadIdx.x < by ? threadIdx.x : threadIdx.x - by;
  return host_warp::from_bits<T>(host_warp::the_warp.meet("shfl_up", host_warp::bits_of(value))[lane]);
}
inline unsigned __ballot_sync(unsigned mask, bool holds) {
  host_warp::require_all(mask);
  const auto &all = host_warp::the_warp.meet("ballot", holds);
  unsigned bits = 0;
  for (unsigned i = 0; i < host_warp::width; ++i)
    bits |= static_cast<unsigned>(all[i]) << i;
  return bits;
}
inline int __reduce_min_sync(unsigned mask, int value) {
  return host_warp::least(mask, value, std::less<>());
}
inline int __reduce_max_sync(unsigned mask, int value) {
  return host_warp::least(mask, value, std::greater<>());
}
inline int __any_sync(unsigned mask, bool holds) {
  host_warp::require_all(mask);
  const auto &all = host_warp::the_warp.meet("any", holds);
  return std::any_of(all.begin(), all.end(), [](std::uint64_t v) { return v != 0; });
}
inline void __syncwarp() {
  host_warp::the_warp.meet("syncwarp", 0);
}
// A block is one warp, and its shared memory that of the program.
inline void __syncthreads() {
  host_warp::the_warp.meet("syncthreads", 0);
}
inline int __syncthreads_or(int holds) {
  const auto &all = host_warp::the_warp.meet("syncthreads_or", holds != 0);
  return std::any_of(all.begin(), all.end(), [](std::uint64_t v) { return v != 0; });
}
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
inline unsigned long long atomicAdd(unsigned long long *to, unsigned long long n) {
  const unsigned long long before = *to;
  *to += n;
  return before;
}
inline std::uint32_t atomicAdd(std::uint32_t *to, std::uint32_t n) {
  const std::uint32_t before = *to;
  *to += n;
  return before;
}
inline std::uint32_t atomicMax(std::uint32_t *to, std::uint32_t n) {
  const std::uint32_t before = *to;
  *to = std::max(before, n);
  return before;
}
using std::max;
using std::min;

#endif
