// The emitted decisions against exact geometry on one member of every class. docs/decisions.md says why that is
// enough, and has the counts.
#include "tests/catch.hpp"
#include "tests/decisions/flat/witness.hpp"
#include "tests/generated/judge/effort.hpp"

#include <cstdio>
#include <span>

using namespace meetc::decisions_test;
namespace generated_test = meetc::generated_test;

namespace {

// Counts of classes, by the dimension that the points span.
struct counts {
  int meet, miss;
};

template <class P> void check_all(const std::array<counts, 4> &want) {
  constexpr int m = written<P>::of_a, n = m + written<P>::of_b;
  int situations = 0;
  for (int d = 0; d <= 3; ++d) {
    CAPTURE(written<P>::name, d);
    judge oracle;
    findings f;
    // Every class in every build; slow builds use only one placement.
    const std::size_t each = generated_test::effort(2) == 2 ? placements(d).size() : 1;
    for (const auto &[k, x] : classes_of(n, d)) {
      const bool meets = hulls_meet(k, n, d, m);
      for (const placement &p : std::span(placements(d)).first(each)) {
        const points y = placed(x, p);
        examine<P>(y, meets, oracle.touching(y, m), f);
      }
    }
    const int times = static_cast<int>(each), hits = f.hits / times, misses = f.misses / times;
    situations += d == 3 ? hits + misses : f.hits + f.misses; // d = 3: no direction is chosen
    std::printf("%-18s %d points spanning dimension %d: %6d classes meet, %6d do not, in %2d placements; "
                "the oracle judged %zu\n",
                written<P>::name, n, d, hits, misses, times, oracle.asked());
    CHECK(f.clean());
    CHECK(f.hits == want[static_cast<std::size_t>(d)].meet * times);
    CHECK(f.misses == want[static_cast<std::size_t>(d)].miss * times);
  }
  std::printf("%-18s %d sign vectors of classes and directions\n", written<P>::name, situations);
}

} // namespace

// Many of these are known in advance. With a and b points: on a line the misses are 2 w(a) w(b), where w counts
// weak orders, 1, 3, 13 of 1, 2, 3 labels; if a + b = d + 2 there is one dependence, and the hits are
// 2 (2^a - 1) (2^b - 1).
TEST_CASE("geometry: segment_segment") {
  check_all<cga::segment_segment>({counts{1, 0}, {56, 18}, {18, 32}, {0, 2}});
}
TEST_CASE("geometry: point_triangle") {
  check_all<cga::point_triangle>({counts{1, 0}, {48, 26}, {14, 36}, {0, 2}});
}
TEST_CASE("geometry: segment_triangle") {
  check_all<cga::segment_triangle>({counts{1, 0}, {462, 78}, {878, 806}, {42, 138}});
}
TEST_CASE("geometry: triangle_triangle") {
  check_all<cga::triangle_triangle>({counts{1, 0}, {4344, 338}, {81100, 40824}, {11976, 22348}});
}
