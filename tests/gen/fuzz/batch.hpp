// Emitted formulas as machine code: one unit of C++ and one of C, compiled with and without FMA, and compared with the
// oracle.
#ifndef MEETC_TESTS_FUZZ_BATCH_HPP
#define MEETC_TESTS_FUZZ_BATCH_HPP

#include "tests/gen/fuzz/compiler.hpp"

namespace meetc::fuzz {

// The flags of one build. Compilers fuse by themselves where they optimise.
struct build {
  const char *name;
  std::vector<std::string> flags;
};
// Those that this machine can run.
const std::vector<build> &builds();

struct batch_result {
  struct fault {
    const compiled *of; // null: of the whole batch
    std::string what;
  };
  std::vector<fault> faults;
  // Values that were compared, and the entry points where no operands were found for which doubles are exact.
  long exact = 0, within_bound = 0, never_exact = 0;
};

// Changes what is compiled, to see that the first build finds it.
using text_change = std::function<void(std::vector<target::file> &)>;

batch_result run_batch(compiler &with, const std::vector<const compiled *> &all, std::uint64_t seed,
                       const text_change &change = nullptr);

// The fault of the emitted text of a formula, or "": each coefficient is to be assigned once, and each number returned.
std::string check_text(const compiler &with, const compiled &c, const std::vector<target::file> &files);

} // namespace meetc::fuzz

#endif
