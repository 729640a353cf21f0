// Hierarchies on a device: the order of their elements, where their levels lie, and what their boxes hold.
#include "tests/catch.hpp"

#include <meetc/volume/tree_order.hpp>

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace meetc;
using namespace meetc::cuda;

TEST_CASE("tree: Hilbert's curve goes through every cell once, from neighbour to neighbour") {
  for (int bits = 1; bits <= 5; ++bits) {
    const std::uint32_t side = 1U << bits, cells = side * side * side;
    std::vector<std::uint32_t> at(cells, cells); // the cell at each place
    for (std::uint32_t cell = 0; cell < cells; ++cell) {
      const std::uint32_t place = hilbert_place(cell / side / side, cell / side % side, cell % side, bits);
      REQUIRE(place < cells);
      REQUIRE(at[place] == cells);
      at[place] = cell;
    }
    for (std::uint32_t place = 1; place < cells; ++place) {
      std::uint32_t steps = 0;
      for (const std::uint32_t unit : {1U, side, side * side}) {
        const auto coordinate = [&](std::uint32_t cell) { return static_cast<int>(cell / unit % side); };
        steps += static_cast<std::uint32_t>(std::abs(coordinate(at[place]) - coordinate(at[place - 1])));
      }
      REQUIRE(steps == 1);
    }
  }
}

TEST_CASE("tree: a sample has at most 1024 of all elements, and one if there is one") {
  for (const std::uint32_t n : {0U, 1U, 2U, 1023U, 1024U, 1025U, 2048U, 2049U, 4097U, 1000000U, 0xffffffffU}) {
    const sample some(n);
    INFO(n);
    CHECK(some.of(n) <= 1024);
    CHECK(some.of(n) >= std::min(n, 512U));
    CHECK((n == 0 || some.first + std::uint64_t{some.step} * (some.of(n) - 1) < n));
    CHECK(some.first + std::uint64_t{some.step} * some.of(n) >= n);
  }
}

TEST_CASE("tree: the table of steps along Hilbert's curve gives the same places") {
  static constexpr hilbert_steps steps;
  for (int bits = 1; bits <= 10; ++bits) {
    const std::uint32_t side = 1U << bits, many = bits <= 5 ? side * side * side : 40000;
    std::uint32_t random = 1;
    for (std::uint32_t i = 0; i < many; ++i) {
      random = random * 1664525U + 1013904223U;
      const std::uint32_t cell = bits <= 5 ? i : random >> 2;
      const std::uint32_t x = cell >> 2 * bits & (side - 1), y = cell >> bits & (side - 1), z = cell & (side - 1);
      REQUIRE(steps.place(x, y, z, bits) == hilbert_place(x, y, z, bits));
    }
  }
}

TEST_CASE("tree: any centre has a place, and distant ones keep their sides") {
  const tree_box around{{-1, -1, -1}, {1, 1, 1}};
  const auto place = [&](float x, float y, float z) {
    return hilbert_cells(around, 1).place_of({{x, y, z}, {x, y, z}});
  };
  std::vector<bool> seen(8);
  for (int i = 0; i < 8; ++i)
    seen[place(i & 1 ? 0.5F : -0.5F, i & 2 ? 0.5F : -0.5F, i & 4 ? 0.5F : -0.5F)] = true;
  CHECK(seen == std::vector<bool>(8, true));
  CHECK(place(-FLT_MAX, -FLT_MAX, -FLT_MAX) == place(-0.5F, -0.5F, -0.5F));
  CHECK(place(FLT_MAX, FLT_MAX, FLT_MAX) == place(0.5F, 0.5F, 0.5F));
  // Cells of one place, and of none.
  CHECK(hilbert_cells({{3, 3, 3}, {3, 3, 3}}, 10).place_of({{3, 3, 3}, {3, 3, 3}}) == 0);
  CHECK(hilbert_cells(tree_box(), 10).place_of({{3, 3, 3}, {3, 3, 3}}) == 0);
  // Boxes of any size: the middle of each octant is in a cell of its own.
  for (const float size : {0x1p-148F, 0x1p-126F, 0x1p-61F, 0x1p-59F, 1.0F, 0x1p59F, 0x1p62F, FLT_MAX}) {
    const hilbert_cells cells({{-size, -size, -size}, {size, size, size}}, 1);
    std::vector<bool> of_size(8);
    for (int i = 0; i < 8; ++i) {
      const float x = i & 1 ? size / 2 : -size / 2, y = i & 2 ? size / 2 : -size / 2, z = i & 4 ? size / 2 : -size / 2;
      of_size[cells.place_of({{x, y, z}, {x, y, z}})] = true;
    }
    INFO(size);
    CHECK(of_size == std::vector<bool>(8, true));
  }
}

TEST_CASE("tree: every element has a lane, every node a lane above it, and there is one root") {
  CHECK(tree_shape(0).depth == 0);
  CHECK(tree_shape(0).nodes() == 0);
  for (const std::uint32_t n : {1U, 2U, 31U, 32U, 33U, 1023U, 1024U, 1025U, 32768U, 32769U, 1U << 25, 0xffffffffU}) {
    const tree_shape s(n);
    INFO(n);
    REQUIRE(s.depth >= 2);
    REQUIRE(s.depth <= tree_levels);
    std::uint64_t below = n, nodes = 0;
    for (int level = 0; level < s.depth; ++level) {
      CHECK(s.first[level] == nodes);
      CHECK(s.count[level] == (below + tree_width - 1) / tree_width);
      nodes += below = s.count[level];
    }
    CHECK(s.count[s.depth - 1] == 1);
    CHECK((s.depth == 2 || s.count[s.depth - 2] > 1));
    CHECK(s.nodes() == nodes);
  }
}

namespace {

struct ball {
  static constexpr int fields = 4;
  static void box(const float *row, float *low, float *high) {
    for (int k = 0; k < 3; ++k)
      low[k] = row[k] - row[3], high[k] = row[k] + row[3];
  }
};

} // namespace

TEST_CASE("tree: boxes are finite, and touch where those of the rows do") {
  const float inf = HUGE_VALF, rows[][4] = {{0, 0, 0, 1},
                                            {2, 0, 0, 1},
                                            {2.5F, 0, 0, 1},
                                            {3e38F, 0, 0, 3e38F},
                                            {-3e38F, 1, 1, 0},
                                            {0, 0, 0, FLT_MAX},
                                            {FLT_MAX, FLT_MAX, FLT_MAX, 1}};
  for (const auto &x : rows)
    for (const auto &y : rows) {
      const tree_box a = box_of_row<ball>(x), b = box_of_row<ball>(y);
      bool touch = true;
      float low[2][3], high[2][3];
      ball::box(x, low[0], high[0]), ball::box(y, low[1], high[1]);
      for (int k = 0; k < 3; ++k) {
        CHECK(a.low[k] > -inf);
        CHECK(a.high[k] < inf);
        touch = touch && low[0][k] <= high[1][k] && low[1][k] <= high[0][k];
      }
      CHECK((a.touches(b) || !touch));
      CHECK(a.touches(b) == b.touches(a));
      tree_box all;
      CHECK_FALSE(all.touches(a));
      CHECK_FALSE(all.touches(tree_box()));
      all.widen(a), all.widen(b);
      CHECK(all.touches(a));
      CHECK(all.touches(b));
      tree_node n{};
      put_box(n, 31, all);
      CHECK(box_of(n, 31).touches(a));
    }
  const float unknown[4] = {NAN, 0, 0, 1}; // meets every box along the axis that is not known
  CHECK(box_of_row<ball>(unknown).touches(box_of_row<ball>(rows[3])));
}
