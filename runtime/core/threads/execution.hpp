// core/threads/execution.hpp: on how many threads a call works, and what may stop it.
#ifndef MEETC_CORE_THREADS_EXECUTION_HPP
#define MEETC_CORE_THREADS_EXECUTION_HPP

#include "meet/core/threads/cancelled.hpp"

#include <stop_token>
#include <utility>

namespace meetc {

inline constexpr int max_threads = 256;

// 0 or less: as many as the machine has. The result is never more than max_threads.
int thread_count(int wanted);

// Throws cancelled where a stop was requested.
inline void go_on(const std::stop_token &stop) {
  if (stop.stop_requested())
    throw cancelled();
}

// On how many threads work runs, and what may stop it. A number alone: nothing stops it.
struct execution {
  int threads;
  std::stop_token stop;

  execution(int n, std::stop_token s = {}) : threads(n), stop(std::move(s)) {} // NOLINT: a number is one
  void go_on() const { meetc::go_on(stop); }
};
// As many threads as wanted; see thread_count().
inline execution execution_on(int wanted, std::stop_token stop) {
  return {thread_count(wanted), std::move(stop)};
}

} // namespace meetc

#endif
