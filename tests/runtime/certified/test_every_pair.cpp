// A query that looks at all pairs, behind the filter and the filter's groups, finds what the hierarchy finds.
#include "tests/catch.hpp"

#include "core/affine_pairs.hpp"
#include "core/collide.hpp"
#include "core/find.hpp"
#include "core/pair_filter.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <random>
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

} // namespace

// Sixteen blocks share a tile of groups, and 64 blocks a unit of work: the larger sets have several of both, and ends that
// fill neither.
TEST_CASE("every pair: the filter's groups lose no pair of large sets") {
  const predicate_info &p = find_predicate(cga::catalogue(), "ball_ball");
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

// Long, thin triangles: the balls rule out little, so that the filter by signs is asked.
TEST_CASE("every pair: the filter by signs loses no pair of long elements") {
  const predicate_info &p = find_predicate(cga::catalogue(), "triangle_triangle");
  std::mt19937 g(9);
  const auto needles = [&g, &p](std::size_t n) {
    std::vector<float> rows;
    const auto number = [&g](double size) { return (static_cast<double>(g() >> 8) * 0x1p-23 - 1) * size; };
    for (std::size_t i = 0; i < n; ++i) {
      double middle[3], along[3];
      for (int k = 0; k < 3; ++k)
        middle[k] = number(1), along[k] = number(1);
      for (const double end : {-1.0, 1.0, 0.0})
        for (int k = 0; k < 3; ++k)
          rows.push_back(static_cast<float>(middle[k] + end * along[k] + number(0.02)));
    }
    return prepare({rows.data(), 0, 9 * sizeof(float), nullptr, n}, *p.a);
  };
  for (const std::size_t n : {1024U, 2005U}) {
    const prepared a = needles(1100), b = needles(n);
    REQUIRE(affine_pairs::pays(p, a.elements(), b.elements()));
    for (const rung precision : {rung::certified, rung::exact, rung::fp32}) {
      CAPTURE(n, precision);
      collide_options o;
      const result want = collide(a, b, p, precision, o);
      o.all_pairs = true;
      const result have = collide(a, b, p, precision, o);
      CHECK(want.count > n / 8);
      if (precision == rung::fp32) // a plain rung is asked of every pair whose boxes touch
        CHECK(have.candidates == want.candidates);
      else
        CHECK(have.candidates < want.candidates / 2);
      CHECK(std::equal(have.pairs.begin(), have.pairs.end(), want.pairs.begin(), want.pairs.end(),
                       [](index_pair s, index_pair t) { return s.a == t.a && s.b == t.b; }));
    }
  }
}
