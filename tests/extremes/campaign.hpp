// Many cases of every family for every subject, judged and counted.
#ifndef MEETC_TESTS_EXTREMES_CAMPAIGN_HPP
#define MEETC_TESTS_EXTREMES_CAMPAIGN_HPP

#include "tests/extremes/families/families.hpp"
#include "tests/extremes/judges/lanes.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace meetc::extremes_test {

struct counts {
  std::uint64_t cases = 0, hits = 0, boxed = 0;
  std::array<std::uint64_t, bounded> unsure{};
  std::array<std::uint64_t, rungs> wrong{};
  counts_by_set sets;

  std::uint64_t all_wrong() const; // on any rung and any instruction set
  counts &operator+=(const counts &o);
};

// One family for one subject.
struct cell {
  const family *from;
  const subject *of;
  counts found;
  std::string first_wrong; // the case, to be pasted into a test
};
// The cells in which the family applies, family by family.
std::vector<cell> all_cells();

// The source of truth. By the signs: the predicate's own decision on integer signs, which finds any wrong sign but no
// wrong decision. By geometry: hulls and radii alone (geometry.hpp), which finds both, at about twice the cost.
enum class judge : std::uint8_t { signs, geometry };

// One case: the pair in the tightest box, or in one up to 4 times wider.
outcome check_case(const subject &s, const pair_of_rows &p, random_numbers &random, judge by = judge::signs);

struct plan {
  std::uint64_t cases, seed; // in all, as many of each cell as of any other
  unsigned threads = 1;
  judge by = judge::signs;
};
// Runs them, and reports progress and errors from time to time. The counts depend only on the cases, the seed and the
// judge.
using reporter = std::function<void(std::uint64_t done, std::uint64_t wrong)>;
void run(std::vector<cell> &cells, const plan &what, const reporter &report = {});

// Fewer cases than these say little about a cell.
inline constexpr std::uint64_t enough_cases = 10000;

// The counts of cases by judge, one line for each cell, then sums by family and by subject.
std::string table(const std::vector<cell> &cells, judge by);
std::uint64_t wrong_in(const std::vector<cell> &cells);

} // namespace meetc::extremes_test

#endif
