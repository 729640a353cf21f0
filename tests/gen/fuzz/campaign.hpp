// A run over many formulas, with what it found.
#ifndef MEETC_TESTS_FUZZ_CAMPAIGN_HPP
#define MEETC_TESTS_FUZZ_CAMPAIGN_HPP

#include "tests/gen/fuzz/batch.hpp"

#include <map>

namespace meetc::fuzz {

struct plan {
  std::uint64_t seed = 1;
  long first = 0, count = 30;
  bool machine_code = true;                    // false: programs only, without compilers of C and C++
  bool talk = false;                           // progress on standard error
  std::function<void()> before_each = nullptr; // of the formulas and the batches
  // Changes a kernel after meetc compiled it, to see that it is found.
  std::function<void(lower::kernel &)> change = nullptr;
};

struct finding {
  formula of, smallest; // as drawn, and after taking away what the fault does not need
  std::string what;     // of the smallest
};

struct tally {
  long formulas = 0, compiled = 0, refused = 0;
  std::map<std::string, long> refusals; // by message, without what is quoted
  std::map<std::string, long> by_space; // formulas that compiled
  std::map<way, long> chosen;
  long too_long = 0;                                 // to be expanded
  long cases = 0;                                    // of verify, in exact numbers
  long exact = 0, within_bound = 0, never_exact = 0; // values of machine code
  double slowest = 0, seconds = 0;                   // of a processor, that meetc took for one formula and for all
  std::string slowest_text;
  std::vector<finding> findings;
};

// The time that meetc may take for one formula before that is a finding, in seconds of a processor.
inline constexpr double most_seconds = 30;

tally run(const plan &p);
// The same for one formula, over the operands that its kinds say: for cases that were found once.
std::string fault_of(const formula &f);
std::string text_of(const finding &f);
std::string text_of(const tally &t);

// The formula that is being compiled, for whoever must tell of a crash.
extern std::string current;

} // namespace meetc::fuzz

#endif
