// The rungs that are never wrong, by the hierarchy, find what deciding every pair finds: many small balls, and needles, whose
// boxes hold much that they do not touch.
#include "tests/catch.hpp"

#include "meet/core/query/collide.hpp"
#include "meet/core/query/find.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <random>
#include <vector>

using namespace meetc;

namespace {

using rows = std::vector<float>;

double number(std::mt19937 &g) {
  return static_cast<double>(g() >> 8) * 0x1p-23 - 1;
}
rows balls(std::size_t n, float radius, std::mt19937 &g) {
  rows out;
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k)
      out.push_back(static_cast<float>(number(g)));
    out.push_back(radius);
  }
  return out;
}
// Long, thin triangles.
rows needles(std::size_t n, std::mt19937 &g) {
  rows out;
  for (std::size_t i = 0; i < n; ++i) {
    double middle[3], along[3];
    for (int k = 0; k < 3; ++k)
      middle[k] = number(g), along[k] = number(g);
    for (const double end : {-1.0, 1.0, 0.0})
      for (int k = 0; k < 3; ++k)
        out.push_back(static_cast<float>(middle[k] + end * along[k] + 0.02 * number(g)));
  }
  return out;
}

// Returns how many pairs touch.
std::size_t agree(const predicate_info &p, const rows &a, const rows &b) {
  const auto elements = [](const rows &r, const kind_info &kind) {
    return r.size() / static_cast<std::size_t>(kind.fields);
  };
  const auto ready = [&](const rows &r, const kind_info &kind) {
    return prepare({.data = r.data(), .elements = elements(r, kind)}, kind);
  };
  const std::size_t n = elements(b, *p.b);
  std::vector<index_pair> pairs(n), want;
  std::vector<answer> said(n);
  for (std::uint32_t i = 0; i < elements(a, *p.a); ++i) {
    for (std::uint32_t k = 0; k < n; ++k)
      pairs[k] = {i, k};
    p.decide[static_cast<int>(rung::exact)](a.data(), b.data(), pairs.data(), n, said.data());
    for (std::size_t k = 0; k < n; ++k)
      if (said[k] == answer::yes)
        want.push_back(pairs[k]);
  }
  const prepared x = ready(a, *p.a), y = ready(b, *p.b);
  for (const rung precision : {rung::certified, rung::exact}) {
    CAPTURE(precision);
    const std::vector<index_pair> have = collide(x, y, p, precision).pairs;
    CHECK(std::equal(have.begin(), have.end(), want.begin(), want.end(),
                     [](index_pair s, index_pair t) { return s.a == t.a && s.b == t.b; }));
  }
  return want.size();
}

} // namespace

TEST_CASE("brute force: balls, few against few to many") {
  const predicate_info &p = find_predicate(cga::catalogue(), "ball_ball");
  std::mt19937 g(3);
  for (const std::size_t n : {300U, 1024U, 1040U, 5000U, 9001U}) {
    const rows few = balls(200, 0.1F, g), many = balls(n, 0.1F, g);
    CAPTURE(n);
    CHECK(agree(p, few, many) > n / 8);
    CHECK(agree(p, many, few) > n / 8);
  }
}

TEST_CASE("brute force: long, thin triangles") {
  const predicate_info &p = find_predicate(cga::catalogue(), "triangle_triangle");
  std::mt19937 g(9);
  for (const std::size_t n : {1024U, 2005U}) {
    CAPTURE(n);
    CHECK(agree(p, needles(1100, g), needles(n, g)) > n / 8);
  }
}
