// bench/harness/scaling.hpp: tests whether counts grow as a power of a size.
//
// Problem: a table of counts whose pose is unknown cannot be checked row by row, but the growth of its counts can. A
// curve on a surface of n triangles of one size crosses as many of them as its length has edges, c sqrt(n).
// Method: least squares of log count over log size. The tolerance is derived, not chosen: where every count is within a
// share s of c n^e, the slope is within log(1+s) sum|x - mean| / sum (x - mean)^2 of e, x being log n, whatever the
// counts are. A slope outside therefore refutes the scaling exponent e with that scatter.
#ifndef MEETC_BENCH_HARNESS_SCALING_HPP
#define MEETC_BENCH_HARNESS_SCALING_HPP

#include "meet/app/text/json.hpp"

#include <string>
#include <vector>

namespace meetc::bench {

struct power_fit {
  double expected = 0, scatter = 0; // as given: the scaling exponent, and a share of each count
  double exponent = 0;              // fitted to the counts; NaN with fewer than two sizes
  double tolerance = 0;             // for the exponent
  double worst = 0; // at the count farthest from c n^expected: count / (c n^expected) - 1, c by the median row
  double worst_size = 0;
  bool holds = false; // |exponent - expected| <= tolerance
};

// Rows of size 0 or count 0 are left out.
power_fit fit_power(const std::vector<double> &sizes, const std::vector<double> &counts, double expected,
                    double scatter);

// "exponent 0.497, expected 0.5 ± 0.027: the scaling holds; farthest from it is the row of 20,000, 3 % above"
std::string in_words(const power_fit &fit);
app::json as_json(const power_fit &fit);

} // namespace meetc::bench

#endif
