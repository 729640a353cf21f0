// app/bench/blind.hpp: every pair of two sets, decided blindly on one core, as the paper does it.
//
// Method: each test is called for blocks of pairs of one row of a with many rows of b; all tests take the
// same blocks in turn. Where there are more pairs than the budget, rows are left out evenly on both sides,
// and the time is scaled by the pairs that are left out: blind work is proportional to them.
#ifndef MEETC_APP_BENCH_BLIND_HPP
#define MEETC_APP_BENCH_BLIND_HPP

#include "bench/measure.hpp"
#include "io/element_set.hpp"
#include "meetc/support.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace meetc::app {

struct blind_time {
  double time = 0;                           // for all pairs, the sample's scaled; in yardsticks
  std::uint64_t yes = 0;                     // of the sample
  std::uint64_t wrong_yes = 0, wrong_no = 0; // against the first test, of the sample
};
struct blind_times {
  std::vector<blind_time> of; // a test each
  std::uint64_t pairs = 0;    // of the sample
  bool sample = false;        // not all pairs
};

// a and b are the predicate's first and second set.
blind_times time_blind(yardstick &by, std::span<const decide_function> tests, const io::element_set &a,
                       const io::element_set &b, std::uint64_t budget, int runs);

// The classic tests as functions of rows, for time_blind().
namespace classic {
extern const decide_function balls, moller, moller_0, guigue_devillers, moller_trumbore;
}

} // namespace meetc::app

#endif
