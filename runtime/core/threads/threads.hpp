// core/threads/threads.hpp: runs the same work on several threads, in pieces that a shared counter hands out.
//
// The calling thread is worker 0, so with one thread everything runs inline and no thread starts. Started threads are
// the only thing here that the system allocates; if it refuses some, the work is done by the others. The first
// exception of a worker is thrown again in the caller once all have stopped. Work that may be cancelled looks at its stop token
// between pieces that take about a millisecond at most, and throws.
#ifndef MEETC_CORE_THREADS_THREADS_HPP
#define MEETC_CORE_THREADS_THREADS_HPP

#include "meet/core/threads/execution.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace meetc {

// The range [0, end) in chunks, each handed out once.
class chunk_counter {
public:
  chunk_counter(std::size_t end, std::size_t chunk) : end_(end), chunk_(std::max<std::size_t>(chunk, 1)) {}

  bool take(std::size_t &begin, std::size_t &stop) {
    begin = next_.fetch_add(chunk_, std::memory_order_relaxed);
    if (begin >= end_)
      return false;
    stop = std::min(end_, begin + chunk_);
    return true;
  }
  void close() { next_.store(end_, std::memory_order_relaxed); }
  double fraction() const {
    const std::size_t next = std::min(next_.load(std::memory_order_relaxed), end_);
    return end_ ? static_cast<double>(next) / static_cast<double>(end_) : 1.0;
  }
  // At most as many workers as there are chunks.
  int workers(int wanted) const {
    const std::size_t chunks = end_ / chunk_ + (end_ % chunk_ != 0);
    return static_cast<int>(std::clamp<std::size_t>(chunks, 1, static_cast<std::size_t>(wanted)));
  }

private:
  std::atomic<std::size_t> next_{0};
  std::size_t end_, chunk_;
};

// Calls body(worker) once on each of `threads` workers; those that it starts inherit the caller's control word. `counter` is
// closed when one throws.
void run_workers(int threads, chunk_counter &counter, void (*body)(void *context, int worker), void *context);

template <class Body> void run_workers(int threads, chunk_counter &counter, Body &body) {
  run_workers(
      threads, counter, [](void *context, int w) { (*static_cast<Body *>(context))(w); }, &body);
}

// Calls body(worker, begin, end) for all chunks of [0, n).
template <class Body> void for_chunks(const execution &on, std::size_t n, std::size_t chunk, const Body &body) {
  chunk_counter counter(n, chunk);
  auto each = [&](int worker) {
    for (std::size_t begin, end; counter.take(begin, end);) {
      on.go_on();
      body(worker, begin, end);
    }
  };
  run_workers(counter.workers(on.threads), counter, each);
}

// Calls body(begin, end) for strips of [0, n) one after another, on this thread: a loop that may be cancelled.
template <class Body> void for_strips(const execution &on, std::size_t n, const Body &body) {
  constexpr std::size_t strip = std::size_t{1} << 14;
  for (std::size_t begin = 0; begin < n; begin += strip) {
    on.go_on();
    body(begin, std::min(n, begin + strip));
  }
}

} // namespace meetc

#endif
