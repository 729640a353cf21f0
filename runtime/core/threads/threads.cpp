#include "meet/core/threads/threads.hpp"

#include <exception>
#include <mutex>
#include <thread>

namespace meetc {

int thread_count(int wanted) {
  if (wanted <= 0)
    wanted = static_cast<int>(std::min(std::thread::hardware_concurrency(), 4096u));
  return std::clamp(wanted, 1, max_threads);
}

void run_workers(int threads, chunk_counter &counter, void (*body)(void *, int), void *context) {
  std::exception_ptr first;
  std::mutex first_lock;
  const auto work = [&](int worker) {
    try {
      body(context, worker);
    } catch (...) {
      counter.close();
      const std::scoped_lock hold(first_lock);
      if (!first)
        first = std::current_exception();
    }
  };
  {
    std::jthread started[max_threads - 1]; // joined at the end of this scope
    try {
      for (int w = 1; w < std::min(threads, max_threads); ++w)
        started[w - 1] = std::jthread(work, w);
    } catch (...) { // the system started fewer threads than wanted
    }
    work(0);
  }
  if (first)
    std::rethrow_exception(first);
}

} // namespace meetc
