// Many cases of every family for every subject, counted.
#ifndef MEETC_TESTS_EXTREMES_CAMPAIGN_HPP
#define MEETC_TESTS_EXTREMES_CAMPAIGN_HPP

#include "tests/extremes/families.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace meetc::extremes_test {

struct counts {
  std::uint64_t cases = 0, hits = 0, boxed = 0;
  std::array<std::uint64_t, bounded> unsure{};
  std::array<std::uint64_t, rungs> wrong{};

  std::uint64_t all_wrong() const;
  counts &operator+=(const counts &o);
};

// One family for one subject.
struct cell {
  const family *from;
  const subject *of;
  counts found;
  std::string first_wrong; // the case, to be pasted into a test
};
// Those where the family applies, family by family.
std::vector<cell> all_cells();

// One case: the pair in a box as tight as can be, or up to 4 times wider.
outcome check_case(const subject &s, const pair_of_rows &p, random_numbers &random);

// Runs `cases` in all, as many of each cell as of any other, and reports what is done and wrong from time to
// time. The counts depend on the seed and on nothing else.
void run(std::vector<cell> &cells, std::uint64_t cases, std::uint64_t seed, unsigned threads,
         const std::function<void(std::uint64_t done, std::uint64_t wrong)> &report);

// A line a cell, then sums by family and by subject.
std::string table(const std::vector<cell> &cells);
std::uint64_t wrong_in(const std::vector<cell> &cells);

} // namespace meetc::extremes_test

#endif
