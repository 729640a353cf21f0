// The scene's box changes no answer of the shipped kernels, at every size of box that their bounds cover.
#include "tests/catch.hpp"

#include "meet/core/query/collide.hpp"
#include "meet/core/views/pose.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace meetc;

namespace {

// Rows with coordinates in [-box, box] and lengths in [0, 2 box]. Half of them are on a coarse lattice, so that many
// are degenerate, and some are at the corners of the box.
std::vector<float> some_rows(float box, const kind_info &kind, std::size_t n, std::mt19937 &g) {
  std::vector<float> rows;
  for (std::size_t i = 0; i < n; ++i) {
    const bool lattice = g() % 2;
    const int steps = 1 << g() % 4;
    for (int f = 0; f < kind.fields; ++f) {
      const double unit = static_cast<double>(g() >> 8) * 0x1p-23 - 1; // [-1, 1)
      const double v = lattice ? std::round(unit * steps) / steps : unit;
      rows.push_back(static_cast<float>((kind.roles[f] == role::length ? std::abs(v) * (g() % 8 ? 0.25 : 2) : v) *
                                        static_cast<double>(box)));
    }
  }
  return rows;
}

// The least and the greatest of a box's corners.
std::vector<float> in_order(std::vector<float> rows, const kind_info &kind) {
  for (std::size_t i = 0; lies_along_axes(kind) && i < rows.size(); i += static_cast<std::size_t>(kind.fields))
    for (std::size_t k = i; k < i + 3; ++k)
      if (rows[k + 3] < rows[k])
        std::swap(rows[k], rows[k + 3]);
  return rows;
}

prepared ready(const std::vector<float> &any, const kind_info &kind) {
  const auto fields = static_cast<std::size_t>(kind.fields);
  const std::vector<float> rows = in_order(any, kind);
  return prepare({rows.data(), 0, fields * sizeof(float), nullptr, rows.size() / fields}, kind);
}

bool same(const result &x, const result &y) {
  return std::equal(x.pairs.begin(), x.pairs.end(), y.pairs.begin(), y.pairs.end(),
                    [](index_pair s, index_pair t) { return s.a == t.a && s.b == t.b; });
}

} // namespace

TEST_CASE("the same pairs in any box as without one") {
  const catalogue &all = cga::catalogue();
  std::mt19937 g(1);
  int covered = 0;
  for (int i = 0; i < all.predicate_count; ++i) {
    const predicate_info &p = all.predicates[i];
    for (const float box : {0x1p-140f, 0x1p-53f, 0x1p-30f, 0x1p-10f, 0.3f, 1.0f, 100.0f, 0x1p20f, 0x1p50f, 0x1p100f}) {
      INFO(p.name << " in a box of " << box);
      std::vector<float> a = some_rows(box, *p.a, 250, g);
      const std::vector<float> b = some_rows(box, *p.b, 250, g);
      const prepared y = ready(b, *p.b);
      {
        const prepared x = ready(a, *p.a);
        const result exact = collide(x, y, p, rung::exact), none = collide(x, y, p, rung::certified),
                     boxed = collide(x, y, p, rung::certified, {.box = box});
        CHECK(same(none, exact));
        CHECK(same(boxed, exact));
        CHECK_FALSE(boxed.rungs.left_box_a);
        CHECK_FALSE(boxed.rungs.left_box_b);
        CHECK(exact.count > 100);
        const float side = power_above(2 * box);
        covered += side >= p.box_least && side <= p.box_most;
      }
      // One number is a step outside: this is reported, and nothing is decided by a box that does not hold.
      a[static_cast<std::size_t>(p.a->fields) * 100] = std::nextafter(box, 2 * box);
      const prepared x = ready(a, *p.a);
      const result exact = collide(x, y, p, rung::exact), none = collide(x, y, p, rung::certified),
                   boxed = collide(x, y, p, rung::certified, {.box = box});
      CHECK(same(boxed, exact));
      CHECK(boxed.rungs.left_box_a);
      CHECK_FALSE(boxed.rungs.left_box_b);
      CHECK(std::equal(boxed.rungs.unsure, boxed.rungs.unsure + 3, none.rungs.unsure));
    }
  }
  CHECK(covered >= 5 * all.predicate_count);
}
