// The marks by which two sets are culled: no element that may touch one of the other set is ruled out.
#include "meetc/cuda/cull_grid.hpp"
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace meetc;
using namespace meetc::cuda;
using meetc::generated_test::effort;

namespace {

using engine = std::mt19937_64;

joined_box around(const std::vector<tree_box> &boxes) {
  joined_box all{};
  for (const tree_box &b : boxes)
    for (int k = 0; k < 3; ++k) {
      all.below[k] = std::max(all.below[k], below_of(b.low[k]));
      all.above[k] = std::max(all.above[k], above_of(b.high[k]));
    }
  return all;
}
void set(std::uint32_t *word, std::uint32_t mask) {
  *word |= mask;
}

// Boxes about points of a cube, of sizes from 2^-20 to 2^3 of it or of none, times a factor.
std::vector<tree_box> boxes(std::size_t n, float factor, float offset, engine &random) {
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<tree_box> out(n);
  for (tree_box &b : out) {
    const float size = random() % 5 == 0 ? 0 : std::ldexp(1.0F, static_cast<int>(random() % 24) - 20);
    for (int k = 0; k < 3; ++k) {
      const float x = unit(random) + offset;
      b.low[k] = std::max(-FLT_MAX, x * factor), b.high[k] = std::min(FLT_MAX, (x + size * unit(random)) * factor);
    }
  }
  return out;
}

} // namespace

TEST_CASE("cull: a box is put together from numbers in their order, and none is empty") {
  CHECK(box_of(joined_box{}).low[0] > box_of(joined_box{}).high[0]);
  const tree_box a{{-1, 2, -FLT_MAX}, {1e-45F, 3, FLT_MAX}}, b{{-0.5F, 1, 0}, {5, 2.5F, 1}};
  const tree_box all = box_of(around({a, b}));
  for (int k = 0; k < 3; ++k) {
    CHECK(all.low[k] == std::min(a.low[k], b.low[k]));
    CHECK(all.high[k] == std::max(a.high[k], b.high[k]));
  }
}

TEST_CASE("cull: whatever touches a box that has marked its cells is kept") {
  engine random(1);
  std::size_t kept = 0, touching = 0, all = 0;
  for (int bits = least_cull_bits; bits <= most_cull_bits; ++bits)
    for (const auto &[factor, offset] :
         {std::pair(1.0F, 0.0F), std::pair(0x1p-148F, 0.0F), std::pair(0x1p127F, -0.5F), std::pair(1.0F, 1e6F)}) {
      std::vector<tree_box> x = boxes(40, factor, offset, random), y = boxes(300, factor, offset, random);
      if (bits % 2 == 0) // one that has all others in one cell
        x.push_back({{-1e30F, -1e30F, -1e30F}, {1e30F, 1e30F, 1e30F}});
      const cull_grid grid(around(x), around(y), bits);
      std::vector<std::uint32_t> words(cull_marks::words_for(bits));
      const cull_marks marks{words.data(), bits};
      for (const tree_box &b : x) {
        cell_range cells;
        if (grid.range(b, cells))
          marks.mark(cells, cells.level(), set);
      }
      bool lost = false;
      for (const tree_box &b : y) {
        cell_range cells;
        const bool keep = grid.range(b, cells) && (cells.level() > 0 || marks.meets(cells, *marks.levels())),
                   touch = std::any_of(x.begin(), x.end(), [&](const tree_box &a) { return a.touches(b); });
        lost = lost || (touch && !keep);
        kept += keep, touching += touch, ++all;
        std::uint32_t low[3], high[3]; // the same by the cells of its corners
        const packed_cells first = grid.cells_of(b.low), last = grid.cells_of(b.high);
        for (int k = 0; k < 3; ++k)
          low[k] = first.at(k), high[k] = last.at(k);
        cell_range again;
        lost = lost ||
               (touch && (!grid.range(low, high, again) || !std::equal(again.first, again.first + 3, cells.first) ||
                          !std::equal(again.last, again.last + 3, cells.last)));
      }
      INFO(bits << " bits, numbers times " << factor << " at " << offset);
      CHECK(!lost);
    }
  CHECK(touching > 1000);
  CHECK(kept < all);
}

TEST_CASE("cull: sets in boxes that do not touch keep nothing") {
  engine random(2);
  const std::vector<tree_box> x = boxes(20, 1, 0, random), y = boxes(20, 1, 20, random);
  const cull_grid grid(around(x), around(y), 6);
  for (const std::vector<tree_box> *const of : {&x, &y})
    for (const tree_box &b : *of) {
      cell_range cells;
      CHECK(!grid.range(b, cells));
    }
}

// The marks of the cells along a line.
static cull_marks along(const cull_line &line, const cull_grid &grid, std::vector<std::uint32_t> &words) {
  const cull_marks marks{words.data(), grid.bits};
  for (std::uint32_t s = line.first_slab(grid); s <= line.last_slab(grid); ++s)
    marks.mark(line.in_slab(grid, s), 0, set);
  return marks;
}

// Points of a thick segment, and boxes that hold one each: all of them meet the cells along the line.
TEST_CASE("cull: the cells along a line have all of its points") {
  engine random(3);
  std::uniform_real_distribution<float> unit(-0.3F, 1.3F);
  std::size_t marked = 0, cells_of_all = 0, tried = 0;
  for (int i = 0; i < 3000; ++i) {
    const int bits = 3 + static_cast<int>(random() % 5);
    const float factor = std::ldexp(1.0F, static_cast<int>(random() % 240) - 120),
                offset = random() % 4 == 0 ? 1000.0F : 0.0F;
    const joined_box box = around({{{offset * factor, offset * factor, offset * factor},
                                    {(offset + 1) * factor, (offset + 1) * factor, (offset + 1) * factor}}});
    const cull_grid grid(box, box, bits);
    line_ends ends{};
    for (int k = 0; k < 3; ++k) {
      const float from = unit(random), far = random() % 6 == 0 ? 50.0F : 1.0F;
      ends.from[k] = (from + offset) * factor;
      ends.to[k] = random() % 5 == 0 ? ends.from[k] : (unit(random) * far + offset) * factor;
    }
    ends.radius = random() % 2 == 0 ? 0 : std::ldexp(factor, -bits) * unit(random) * unit(random);
    ends.radius = std::fabs(ends.radius);
    const cull_line line(grid, ends);
    if (!line.is_thin())
      continue;
    std::vector<std::uint32_t> words(cull_marks::words_for(bits));
    const cull_marks marks = along(line, grid, words);
    for (std::size_t w = 0; w < cull_marks::words_at(bits, 0); ++w)
      marked += static_cast<std::size_t>(__builtin_popcount(words[w]));
    cells_of_all += std::size_t{1} << 3 * bits;
    bool lost = false;
    for (int p = 0; p <= 200; ++p) {
      std::array<double, 3> point{};
      double away[3] = {0, 0, 0}, length = 0; // a way that is as long as the radius
      for (double &a : away)
        a = unit(random) - 0.5, length += a * a;
      bool inside = true;
      for (int k = 0; k < 3; ++k) {
        const double t = p / 200.0;
        point[static_cast<std::size_t>(k)] = ends.from[k] + t * (static_cast<double>(ends.to[k]) - ends.from[k]) +
                                             0.999 * ends.radius * away[k] / std::sqrt(length);
        inside = inside && point[static_cast<std::size_t>(k)] >= grid.from[k] &&
                 point[static_cast<std::size_t>(k)] <= grid.to[k];
      }
      if (!inside)
        continue;
      tree_box around_point; // of the nearest numbers
      for (int k = 0; k < 3; ++k) {
        const auto x = static_cast<float>(point[static_cast<std::size_t>(k)]);
        around_point.low[k] = std::nextafter(x, -FLT_MAX), around_point.high[k] = std::nextafter(x, FLT_MAX);
      }
      cell_range cells;
      ++tried;
      lost = lost || !grid.range(around_point, cells) || !marks.meets(cells, *marks.levels());
    }
    CHECK(!lost);
  }
  CHECK(tried > 50000);
  CHECK(marked < cells_of_all / 4);
}

TEST_CASE("cull: a box meets what touches one of its corners, however many cells long it is") {
  engine random(4);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  const joined_box box = around({{{0, 0, 0}, {1, 1, 1}}});
  for (int i = 0; i < 4000; ++i) {
    const int bits = 3 + static_cast<int>(random() % 5);
    const cull_grid grid(box, box, bits);
    tree_box one;
    for (int k = 0; k < 3; ++k) {
      one.low[k] = unit(random);
      one.high[k] = std::fmin(1.0F, one.low[k] + std::ldexp(static_cast<float>(random() % 9), -bits) * unit(random));
    }
    std::vector<std::uint32_t> words(cull_marks::words_for(bits));
    const cull_marks marks{words.data(), bits};
    cell_range cells;
    REQUIRE(grid.range(one, cells));
    marks.mark(cells, cells.level(), set);
    for (int corner = 0; corner < 8; ++corner) {
      tree_box at;
      for (int k = 0; k < 3; ++k)
        at.low[k] = at.high[k] = corner >> k & 1 ? one.high[k] : one.low[k];
      cell_range of_corner;
      REQUIRE(grid.range(at, of_corner));
      CHECK(marks.meets(of_corner, *marks.levels()));
    }
  }
}

// The origin is where eight cells meet, and the line passes through it exactly.
TEST_CASE("cull: a line from far away meets the point that it passes through") {
  engine random(5);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  const joined_box box = around({{{-1, -1, -1}, {1, 1, 1}}});
  const tree_box origin = [] {
    tree_box b;
    for (int k = 0; k < 3; ++k)
      b.low[k] = b.high[k] = 0;
    return b;
  }();
  int tried = 0, lost = 0;
  for (int i = 0; i < effort(40000); ++i) {
    const int bits = 3 + static_cast<int>(random() % 6), far = static_cast<int>(random() % 37);
    const cull_grid grid(box, box, bits);
    line_ends ends{};
    for (int k = 0; k < 3; ++k)
      ends.to[k] = std::ldexp(unit(random), far), ends.from[k] = -ends.to[k];
    const cull_line line(grid, ends);
    if (!line.is_thin())
      continue;
    std::vector<std::uint32_t> words(cull_marks::words_for(bits));
    const cull_marks marks = along(line, grid, words);
    cell_range cells;
    ++tried;
    lost += !grid.range(origin, cells) || !marks.meets(cells, *marks.levels());
  }
  CHECK(lost == 0);
  CHECK(tried > effort(20000));
}

TEST_CASE("cull: a line is thin only if it is so along every axis") {
  for (int thick = 0; thick < 3; ++thick) {
    float side[3] = {64, 64, 64};
    side[thick] = 1; // its cells are a 64th as wide
    const joined_box box = around({{{0, 0, 0}, {side[0], side[1], side[2]}}});
    const cull_grid grid(box, box, 6);
    line_ends ends{};
    ends.to[(thick + 1) % 3] = 64;
    ends.radius = 1;
    CHECK(!cull_line(grid, ends).is_thin());
    ends.radius = 0x1p-6F;
    CHECK(cull_line(grid, ends).is_thin());
  }
}
