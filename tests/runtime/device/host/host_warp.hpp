// Blocks of threads on the host, which run device code as it is: each thread is a fiber with a stack of its own, and a function
// of a whole warp or block is a rendezvous. A thread that misses a rendezvous, or is at another than its neighbours, is a
// failure. Between two of them threads run to their end one after another, now from the first to the last, now from the last to
// the first: a number that one thread writes and another reads without a rendezvous between them is therefore read too early in
// one of the two. Blocks that run at once take turns where all threads of all of them meet.
//
// Included before the headers of device code, whose names for CUDA's functions it gives.
#ifndef MEETC_TESTS_HOST_WARP_HPP
#define MEETC_TESTS_HOST_WARP_HPP

#include <boost/context/fiber.hpp>
#include <cuda_runtime_api.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
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
enum class scope { warp, block, grid };

// The threads of some blocks that run at once.
class blocks {
public:
  // Runs `thread` in every thread of every block until all have returned.
  void run(const std::function<void()> &thread, unsigned threads = width, unsigned count = 1, unsigned first = 0) {
    const unsigned n = threads * count;
    thread_ = &thread, threads_ = threads, first_ = first;
    while (all_.size() < n)
      all_.push_back(std::make_unique<one>());
    values_.assign(n, 0);
    for (unsigned i = 0; i < n; ++i)
      start(*all_[i]);
    for (;;) {
      for (unsigned block = 0; block < count; ++block)
        run_block(block);
      const auto waits =
          std::find_if(all_.begin(), all_.begin() + n, [](const auto &t) { return t->now != state::done; });
      if (waits == all_.begin() + n)
        return;
      if (!release(0, n, static_cast<unsigned>(waits - all_.begin()), scope::grid))
        throw std::logic_error("blocks do not meet");
    }
  }

  // Where threads meet: each brings a value and sees those of all that are named in the mask. `where` is compared.
  const std::uint64_t *meet(scope of, const char *where, std::uint64_t value, unsigned mask = ~0U) {
    one &t = *all_[current_];
    t.of = of, t.where = where, t.value = value, t.mask = mask, t.now = state::waiting;
    leave(t);
    return values_.data() + current_ / width * width; // of its warp
  }
  // The values that the threads of this block brought.
  const std::uint64_t *of_block() const { return values_.data() + current_ / threads_ * threads_; }
  unsigned threads() const { return threads_; }
  std::vector<char> &shared() { return shared_[current_ / threads_]; }
  void give_shared(unsigned count, std::size_t bytes) { shared_.assign(count, std::vector<char>(bytes, '\xa5')); }

private:
  enum class state { ready, waiting, done };
  struct one {
    static constexpr std::size_t stack_bytes = std::size_t{1} << 17;
    std::unique_ptr<char[]> stack{new char[stack_bytes]};
    boost::context::fiber code, caller;
    scope of;
    const char *where;
    std::uint64_t value;
    unsigned mask;
    state now = state::done;
    void *shadow; // what AddressSanitizer keeps of a fiber
  };
  struct no_allocation { // the stack outlives its fiber
    void deallocate(boost::context::stack_context &) {}
  };

  void start(one &t) {
    t.code = {}; // of a run that failed
    t.now = state::ready;
    boost::context::stack_context where;
    where.sp = t.stack.get() + one::stack_bytes, where.size = one::stack_bytes;
    t.code = boost::context::fiber(std::allocator_arg, boost::context::preallocated(where.sp, where.size, where),
                                   no_allocation(), [this, &t](boost::context::fiber &&caller) {
                                     t.caller = std::move(caller);
                                     arrive(nullptr);
                                     (*thread_)();
                                     t.now = state::done;
#if defined(__SANITIZE_ADDRESS__)
                                     __sanitizer_start_switch_fiber(nullptr, caller_stack_, caller_size_);
#endif
                                     return std::move(t.caller);
                                   });
  }
  void resume(unsigned number) {
    one &t = *all_[number];
    current_ = number, threadIdx.x = number % threads_, blockIdx.x = first_ + number / threads_;
#if defined(__SANITIZE_ADDRESS__)
    void *shadow = nullptr;
    __sanitizer_start_switch_fiber(&shadow, t.stack.get(), one::stack_bytes);
#endif
    t.code = std::move(t.code).resume();
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_finish_switch_fiber(shadow, nullptr, nullptr);
#endif
  }
  void leave(one &t) {
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_start_switch_fiber(&t.shadow, caller_stack_, caller_size_);
#endif
    t.caller = std::move(t.caller).resume();
    arrive(t.shadow);
  }
  void arrive([[maybe_unused]] void *shadow) {
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_finish_switch_fiber(shadow, &caller_stack_, &caller_size_);
#endif
  }

  // Whether some thread could go on.
  bool step(unsigned begin, bool forward) {
    bool went = false;
    for (unsigned i = 0; i < threads_; ++i)
      if (const unsigned at = begin + (forward ? i : threads_ - 1 - i); all_[at]->now == state::ready)
        resume(at), went = true;
    return went;
  }
  // Lets the threads from `begin` to `end` go on that wait where this one does, if all do that have to.
  bool release(unsigned begin, unsigned end, unsigned number, scope of) {
    const one &first = *all_[number];
    const unsigned mask = of == scope::warp ? first.mask : ~0U;
    const auto named = [&](unsigned i) {
      return of == scope::warp ? (mask >> (i - begin) & 1) != 0 : all_[i]->now != state::done;
    };
    for (unsigned i = begin; i < end; ++i)
      if (const one &t = *all_[i]; named(i) && (t.now != state::waiting || t.of != of || t.mask != first.mask ||
                                                (t.where != first.where && std::strcmp(t.where, first.where) != 0)))
        return false;
    for (unsigned i = begin; i < end; ++i)
      if (named(i))
        values_[i] = all_[i]->value, all_[i]->now = state::ready;
    return true;
  }
  bool release_warps(unsigned begin) {
    bool released = false;
    for (unsigned i = begin; i < begin + threads_; ++i)
      if (all_[i]->now == state::waiting && all_[i]->of == scope::warp) {
        const unsigned warp = begin + (i - begin) / width * width;
        released |= release(warp, std::min(warp + width, begin + threads_), i, scope::warp);
      }
    return released;
  }
  // Until all threads are done, or wait for the other blocks.
  void run_block(unsigned block) {
    const unsigned begin = block * threads_, end = begin + threads_;
    for (bool forward = true; step(begin, forward); forward = !forward) {
      if (release_warps(begin))
        continue;
      const auto waits = std::find_if(all_.begin() + begin, all_.begin() + end,
                                      [](const auto &t) { return t->now == state::waiting; });
      if (waits == all_.begin() + end)
        return;
      const auto number = static_cast<unsigned>(waits - all_.begin());
      if ((*waits)->of == scope::block && release(begin, end, number, scope::block))
        continue;
      if (std::any_of(all_.begin() + begin, all_.begin() + end,
                      [](const auto &t) { return t->now == state::waiting && t->of != scope::grid; }))
        throw std::logic_error("threads do not meet: " + std::string((*waits)->where));
      return;
    }
  }
  const std::function<void()> *thread_ = nullptr;
  unsigned threads_ = width, first_ = 0, current_ = 0; // first_: the number of the first of the blocks
  std::vector<std::unique_ptr<one>> all_;
  std::vector<std::uint64_t> values_;
  std::vector<std::vector<char>> shared_;
  const void *caller_stack_ = nullptr;
  std::size_t caller_size_ = 0;
};

inline blocks the_blocks;

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
inline unsigned lane() {
  return threadIdx.x % width;
}

// A value of all lanes that are named in the mask.
template <class T, class Join> T joined(unsigned mask, const char *what, T value, Join join) {
  const std::uint64_t *const all = the_blocks.meet(scope::warp, what, bits_of(value), mask);
  bool first = true;
  for (unsigned i = 0; i < width; ++i)
    if (mask >> i & 1) {
      value = first ? from_bits<T>(all[i]) : join(value, from_bits<T>(all[i]));
      first = false;
    }
  return value;
}
template <class T> T of_lane(unsigned mask, const char *what, T value, unsigned from) {
  return from_bits<T>(the_blocks.meet(scope::warp, what, bits_of(value), mask)[from % width]);
}

} // namespace host_warp

#include "tests/runtime/device/host/host_functions.hpp"

#endif
