// The functions of the runtime's table on many cases at a time, for every instruction set that runs here. check()
// sees the code for one pair, as a header compiles it.
#ifndef MEETC_TESTS_EXTREMES_LANES_HPP
#define MEETC_TESTS_EXTREMES_LANES_HPP

#include "tests/extremes/families/subjects.hpp"

#include <meetc/table/table.hpp>

#include <array>
#include <cstdint>
#include <string>

namespace meetc::extremes_test {

struct lane_counts {
  std::uint64_t cases = 0, unsure[2] = {0, 0}, wrong = 0; // unsure: by the bounded rungs in fp32 and fp64

  lane_counts &operator+=(const lane_counts &o);
};
using counts_by_set = std::array<lane_counts, instruction_set_count>;

// Cases of one subject with their true answers.
class many_cases {
public:
  explicit many_cases(const subject &of) : of_(of) {}
  void add(const pair_of_rows &p, bool hit);

  // The bounded rungs in lanes, `certified` and `exact`, compared with the true answers. Nothing for a lone sign, which no
  // table holds. Each is asked under another control word, which changes nothing: `word` says with which they begin.
  // `first_wrong` receives the first wrong answer, if it is empty.
  counts_by_set run(std::uint64_t word, std::string &first_wrong) const;

private:
  pair_of_rows rows(std::size_t k) const;

  const subject &of_;
  row a_, b_;
  std::vector<index_pair> pairs_;
  std::vector<answer> truth_;
};

} // namespace meetc::extremes_test

#endif
