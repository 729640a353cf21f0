// The sources that call emitted formulas through arrays of numbers.
#ifndef MEETC_TESTS_FUZZ_HARNESS_HPP
#define MEETC_TESTS_FUZZ_HARNESS_HPP

#include "tests/gen/fuzz/compiler.hpp"

namespace meetc::fuzz {

// A function of a compiled batch: void symbol + "d"(const double *in, double *out), and symbol + "f" for float.
struct entry {
  enum class from { blades, stored, pairs };
  const compiled *of;
  from reads;
  std::string symbol;
  std::vector<lower::blade> outputs; // what out[i] is the coefficient of
};

struct harness {
  std::string cpp, c;
  std::vector<entry> entries;
};
harness harness_for(const lower::model &m, const std::string &space, const std::vector<const compiled *> &all);

// The blades of the struct that a formula returns.
std::vector<lower::blade> returned(const lower::model &m, const lower::formula &f);

} // namespace meetc::fuzz

#endif
