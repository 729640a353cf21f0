// bench/tables/paper/brute_force.hpp: every pair of two sets decided on one core, as in the paper.
//
// Method: each test is called for blocks of pairs of one row of a with many rows of b, and all tests take the same
// blocks in turn. If there are more pairs than the budget allows, rows are left out evenly on both sides, and the time
// is scaled by the number of pairs: the work of brute force is proportional to it.
#ifndef MEETC_BENCH_TABLES_PAPER_BRUTE_FORCE_HPP
#define MEETC_BENCH_TABLES_PAPER_BRUTE_FORCE_HPP

#include "bench/harness/measure.hpp"
#include "io/element_set.hpp"
#include "meetc/support.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace meetc::bench {

struct brute_force_time {
  double time = 0;                           // for all pairs, scaled from the sample; in yardsticks
  std::uint64_t yes = 0;                     // in the sample
  std::uint64_t wrong_yes = 0, wrong_no = 0; // compared with the first test, in the sample
};
struct brute_force_times {
  std::vector<brute_force_time> of; // one for each test
  std::uint64_t pairs = 0;          // in the sample
  bool sample = false;              // true where not all pairs are in it
};

// a and b are the predicate's first and second set; what they store for it is computed before the clock starts.
brute_force_times time_brute_force(yardstick &by, std::span<const decide_function> tests,
                                   const predicate_info &predicate, const io::element_set &a, const io::element_set &b,
                                   std::uint64_t budget, int runs);

// The classic tests as functions of rows, for time_brute_force().
namespace classic {
extern const decide_function balls, moller, moller_0, guigue_devillers, moller_trumbore;
}

} // namespace meetc::bench

#endif
