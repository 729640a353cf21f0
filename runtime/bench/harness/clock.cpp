#include "meet/bench/harness/clock.hpp"

#include <ctime>

namespace meetc::bench {

double host_clock::now() const {
  timespec t{};
  ::clock_gettime(of_process_ ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

} // namespace meetc::bench
