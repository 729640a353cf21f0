// fuzz_formulas SEED COUNT [FIRST] [--programs]: draws formulas, compiles them, and compares what meetc makes of them with
// the oracle. --programs leaves out the compilers of C and C++. Exit code 1: something was found, or one of the ways to
// compute a formula was never met.
#include "tests/gen/fuzz/campaign.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

// Tells the formula of a crash or a hang. Only calls that a signal handler may make.
void last_words(int signal) {
  const char *what = signal == SIGPROF ? "FINDING: no end in a minute of a processor\n  " : "FINDING: a crash\n  ";
  [[maybe_unused]] ssize_t n = ::write(STDERR_FILENO, what, std::strlen(what));
  n = ::write(STDERR_FILENO, meetc::fuzz::current.data(), meetc::fuzz::current.size());
  n = ::write(STDERR_FILENO, "\n", 1);
  ::_exit(1);
}

} // namespace

int main(int argc, char **argv) {
  meetc::fuzz::plan p;
  p.talk = true;
  p.before_each = [] {
    itimerval limit{};
    limit.it_value.tv_sec = 60;
    ::setitimer(ITIMER_PROF, &limit, nullptr);
  };
  std::vector<long> numbers;
  bool understood = true;
  for (int i = 1; i < argc; ++i) {
    char *end = argv[i];
    if (std::string(argv[i]) == "--programs")
      p.machine_code = false;
    else
      numbers.push_back(std::strtol(argv[i], &end, 10)), understood = understood && end != argv[i] && *end == 0;
  }
  if (!understood || numbers.size() < 2 || numbers.size() > 3 ||
      *std::min_element(numbers.begin(), numbers.end()) < 0) {
    fmt::print(stderr, "usage: fuzz_formulas SEED COUNT [FIRST] [--programs]\n");
    return 2;
  }
  p.seed = static_cast<std::uint64_t>(numbers[0]);
  p.count = numbers[1];
  p.first = numbers.size() > 2 ? numbers[2] : 0;
  for (const int s : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGPROF})
    std::signal(s, last_words);
  const meetc::fuzz::tally t = meetc::fuzz::run(p);
  fmt::print("{}", meetc::fuzz::text_of(t));
  const bool all_ways = t.chosen.size() == 3 && t.too_long > 0;
  if (!all_ways)
    fmt::print("one of the ways to compute a formula was never met\n");
  return t.findings.empty() && (all_ways || p.count < 30) ? 0 : 1;
}
