// Errors of computed values: running ones, and those that are counted by degree.
#include "tests/catch.hpp"

#include <meetc/simd/table_functions.hpp>

#include <cga/triangle_triangle.hpp>

#include <cga/detail/triangle_triangle_later.hpp>

#include <algorithm>
#include <cstring>
#include <random>

using namespace meetc;

using tracked = tracked_number<double>;

TEST_CASE("errors of tracked numbers hold the true ones") {
  std::mt19937 g(5);
  double largest = 0;
  int too_little = 0;
  for (int n = 0; n < 20'000; ++n) {
    // Integers for which 2^53 is far too little, so that products round.
    std::int64_t x[6];
    for (std::int64_t &v : x)
      v = (static_cast<std::int64_t>(g()) << 20 | static_cast<std::int64_t>(g() >> 12)) - (std::int64_t{1} << 51);
    tracked t[6];
    for (int k = 0; k < 6; ++k)
      t[k] = tracked(static_cast<double>(x[k]));
    const auto volume = [](const auto *y) { return (y[0] - y[1]) * (y[2] - y[3]) - (y[4] + y[5]) * y[0]; };
    const tracked found = volume(t);
    tracked_number<double, -57> less[6]; // a 64th of the roundings
    for (int k = 0; k < 6; ++k)
      less[k] = tracked_number<double, -57>(static_cast<double>(x[k]));
    const int128 exact = static_cast<int128>(x[0] - x[1]) * (x[2] - x[3]) - static_cast<int128>(x[4] + x[5]) * x[0];
    const int128 off = exact - static_cast<int128>(found.v);
    const auto error = static_cast<double>(off < 0 ? -off : off);
    REQUIRE(error <= found.e);
    too_little += error > volume(less).e;
    largest = std::max(largest, error / found.e);
  }
  CHECK(largest > 0.05); // and are of their size
  CHECK(too_little > 0);
  CHECK(tracked(5'000'000'029).v == 5'000'000'029.0);
  const lane_mask same = tracked_number<wide_lanes>(5'000'000'029).v == wide_lanes(5'000'000'029.0);
  CHECK((same & 1) != 0);
}

// Triangles of whole numbers, so large that doubles round, of which the second's corners lie near the first's plane.
TEST_CASE("errors of counted roundings hold the true ones, and a 1024th of them does not") {
  using P = cga::triangle_triangle;
  using stage = P::reject_stage;
  std::mt19937_64 g(6);
  double largest = 0;
  int too_little = 0;
  for (int n = 0; n < 20'000; ++n) {
    std::int64_t x[18];
    for (std::int64_t &v : x)
      v = static_cast<std::int64_t>(g() >> 25) - (std::int64_t{1} << 38);
    for (std::size_t k = 9; k < 18; ++k) { // a point of the plane, rounded to whole numbers
      const std::int64_t i = static_cast<std::int64_t>(g() % 8), j = static_cast<std::int64_t>(g() % 8);
      x[k] = x[k % 3] + (x[3 + k % 3] - x[k % 3]) * i / 8 + (x[6 + k % 3] - x[k % 3]) * j / 8;
    }
    int128 whole_a[9], whole_b[9], truth[stage::atoms];
    wide_lanes a[9], b[9], v[stage::atoms], error[stage::atoms], less[stage::atoms];
    for (std::size_t k = 0; k < 9; ++k) {
      whole_a[k] = x[k], whole_b[k] = x[9 + k];
      a[k] = wide_lanes(static_cast<double>(x[k])), b[k] = wide_lanes(static_cast<double>(x[9 + k]));
    }
    stage_values<stage>(whole_a, whole_b, truth);
    stage_values<stage>(a, b, v);
    const wide_lanes extent = extent_of<P>(a, b);
    power_errors<P, stage, counted_roundings<P>>(extent, error);
    power_errors<P, stage, counted_roundings<P, -61>>(extent, less);
    for (int i = 0; i < stage::atoms; ++i) {
      double found = 0, bound = 0, small = 0;
      std::memcpy(&found, &v[i], sizeof found);
      std::memcpy(&bound, &error[i], sizeof bound);
      std::memcpy(&small, &less[i], sizeof small);
      const int128 off = truth[i] - static_cast<int128>(found);
      const auto is_off = static_cast<double>(off < 0 ? -off : off);
      REQUIRE(is_off <= bound);
      too_little += is_off > small;
      largest = std::max(largest, is_off / bound);
    }
  }
  INFO(largest);
  CHECK(too_little > 0);
  constexpr rounding_counts<P, stage> counts; // a product of three differences, and two sums of such
  CHECK(counts.of[0] >= 5);
  CHECK(counts.of[0] < 20);
}
