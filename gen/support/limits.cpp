#include "gen/support/limits.hpp"

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <unistd.h>

namespace meetc {
namespace {

constexpr std::chrono::milliseconds between_looks{10};

std::mutex ending; // whoever holds it decides whether the process goes on
bool stopped = false;

long resident_megabytes() {
  std::ifstream in("/proc/self/statm");
  long all = 0, resident = 0;
  in >> all >> resident;
  return resident * ::sysconf(_SC_PAGESIZE) / (1 << 20);
}

// Leaves at once: the other threads are in the middle of something.
void end_process(const std::string &message, int code) {
  const std::string line = "error: " + message + '\n';
  [[maybe_unused]] const ssize_t n = ::write(STDERR_FILENO, line.data(), line.size());
  ::_exit(code);
}

void watch(const limits &l, int code) {
  const auto start = std::chrono::steady_clock::now();
  for (;; std::this_thread::sleep_for(between_looks)) {
    const std::scoped_lock lock(ending);
    if (stopped)
      return;
    if (l.megabytes > 0 && resident_megabytes() > l.megabytes)
      end_process(fmt::format("this takes more memory than {} megabytes, the --limit-megabytes", l.megabytes), code);
    if (l.seconds > 0 && std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > l.seconds)
      end_process(fmt::format("this takes longer than {} seconds, the --limit-seconds", l.seconds), code);
  }
}

} // namespace

void watch_limits(const limits &l, int code) {
  if (l.seconds > 0 || l.megabytes > 0)
    std::thread(watch, l, code).detach(); // it ends with the process
}

void stop_watching_limits() {
  const std::scoped_lock lock(ending);
  stopped = true;
}

} // namespace meetc
