// A query that looks at all pairs, behind the filter and the filter's groups, finds what the hierarchy finds.
#include "tests/catch.hpp"

#include "core/collide.hpp"
#include "core/pair_filter.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <random>
#include <stdexcept>
#include <string_view>
#include <vector>

using namespace meetc;

namespace {

prepared spread(const kind_info &kind, std::size_t n, double radius, std::mt19937 &g) {
  std::vector<float> rows;
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k)
      rows.push_back(static_cast<float>(static_cast<double>(g() >> 8) * 0x1p-23 - 1));
    rows.push_back(static_cast<float>(radius));
  }
  return prepare({rows.data(), 0, 4 * sizeof(float), nullptr, n}, kind);
}

const predicate_info &balls() {
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i)
    if (std::string_view(all.predicates[i].name) == "ball_ball")
      return all.predicates[i];
  throw std::logic_error("no predicate ball_ball");
}

} // namespace

// Sixteen blocks share a tile of groups, and 64 blocks a unit of work: the larger sets have several of both, and ends that
// fill neither.
TEST_CASE("every pair: the filter's groups lose no pair of large sets") {
  const predicate_info &p = balls();
  std::mt19937 g(3);
  for (const std::size_t n : {300U, 1024U, 1040U, 5000U, 9001U}) {
    const prepared few = spread(*p.a, 200, 0.1, g), many = spread(*p.a, n, 0.1, g);
    REQUIRE(pair_filter::pays(p, few.set(), many.set()));
    for (const bool exchanged : {false, true}) {
      CAPTURE(n, exchanged);
      const prepared &a = exchanged ? many : few, &b = exchanged ? few : many;
      collide_options o;
      const result want = collide(a, b, p, rung::certified, o);
      o.all_pairs = true;
      const result have = collide(a, b, p, rung::certified, o);
      CHECK(want.count > n / 8);
      CHECK(have.candidates == want.candidates);
      CHECK(std::equal(have.pairs.begin(), have.pairs.end(), want.pairs.begin(), want.pairs.end(),
                       [](index_pair s, index_pair t) { return s.a == t.a && s.b == t.b; }));
    }
  }
}
