// The separable filter on a CPU: no pair of touching boxes is lost, on any instruction set, and the margins are what
// keeps it.
#include "tests/catch.hpp"
#include "tests/generated/effort.hpp"
#include "tests/generated/numbers.hpp"

#include <cga/cga_runtime.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace meetc::generated_test;

namespace {

using numbers = std::vector<float>;

// An element of the kind whose box is that of the cube from `lo` to `lo + size`, as far as the kind has such elements.
void add_in_cube(const meetc::kind_info &kind, const float lo[3], float size, numbers &to) {
  float hi[3];
  for (int k = 0; k < 3; ++k)
    hi[k] = lo[k] + size;
  if (kind.pad >= 0) {
    for (int k = 0; k < 3; ++k)
      to.push_back(lo[k] + size / 2);
    to.push_back(size / 2);
    return;
  }
  if (kind.points == 0) { // a box
    to.insert(to.end(), lo, lo + 3), to.insert(to.end(), hi, hi + 3);
    return;
  }
  for (int p = 0; p < kind.points; ++p) // one point; two ends of a diagonal; another corner as well
    for (int k = 0; k < 3; ++k)
      to.push_back(p == 0 ? lo[k] : p == 1 || k == 0 ? hi[k] : lo[k]);
}

struct box {
  float lo[3], hi[3];
};
box box_of(const meetc::kind_info &kind, const float *row) {
  box b;
  kind.box(row, b.lo, b.hi);
  return b;
}
bool touch(const box &x, const box &y) {
  bool all = true;
  for (int k = 0; k < 3; ++k)
    all = all && x.lo[k] <= y.hi[k] && y.lo[k] <= x.hi[k];
  return all;
}

const meetc::kind_info &kind_named(const meetc::catalogue &c, const std::string &name) {
  for (int i = 0; i < c.kind_count; ++i)
    if (c.kinds[i].name == name)
      return c.kinds[i];
  throw std::logic_error("no kind " + name);
}

struct outcome {
  long touching = 0, lost = 0, lost_without_margins = 0, apart = 0, kept = 0;
};

// The number with the additive term is the last one. Its margin is at most this part of the terms.
constexpr float margin = 0x1p-20F, least_margin = 0x1p-10F;
float without_margin(const float *n, int floats) {
  float squares = 0;
  for (int k = 0; k + 1 < floats; ++k)
    squares += n[k] * n[k];
  return n[floats - 1] + margin * (squares / 2 + std::fabs(n[floats - 1])) + least_margin;
}

// Cubes in rows along the diagonal of space, each of which touches the next in one corner, so that the balls around
// their boxes touch in that corner, as far as rounding allows.
void check(const meetc::kind_info &a, const meetc::kind_info &b, random_numbers &random, outcome &sum) {
  constexpr std::size_t n = 80; // of each set: five tiles
  numbers rows_a, rows_b;
  const int scale = random.integer(-120, 100);
  const float unit = std::ldexp(1.0F, scale);
  for (std::size_t i = 0; i < n; ++i) {
    float at[3];
    for (float &v : at)
      v = static_cast<float>(random.integer(-200, 200)) * unit * (random.one_in(3) ? 1 : random.unit());
    const float size = unit * random.unit() * (random.one_in(2) ? 0.01F : 1.0F);
    add_in_cube(a, at, size, rows_a);
    for (float &v : at)
      v += size;
    add_in_cube(b, at, random.one_in(5) ? 0 : unit * random.unit(), rows_b);
  }
  const meetc::kind_filter &of_a = *a.filter, &of_b = *b.filter;
  const auto floats = static_cast<std::size_t>(of_a.floats);
  meetc::filter_extent frame;
  if (random.one_in(2))
    of_a.widen(rows_a.data(), n, frame);
  else
    of_b.widen(rows_b.data(), n, frame);
  numbers singles(n * floats), tiles(n * floats);
  of_a.singles(frame, rows_a.data(), n, singles.data());
  of_b.tiles(frame, rows_b.data(), n, tiles.data());
  // One element of b in a tile of its own, so that near() speaks of it alone.
  numbers one(meetc::filter_tile * floats), bare_single(floats), bare_tile;
  for (std::size_t j = 0; j < n; ++j) {
    const float *row_b = rows_b.data() + j * static_cast<std::size_t>(b.fields);
    const box of_row_b = box_of(b, row_b);
    of_b.tiles(frame, row_b, 1, one.data());
    bare_tile = one;
    numbers own(floats);
    for (std::size_t k = 0; k < floats; ++k)
      own[k] = one[k * meetc::filter_tile];
    bare_tile[(floats - 1) * meetc::filter_tile] = without_margin(own.data(), of_b.floats);
    for (std::size_t i = 0; i < n; ++i) {
      const float *single = singles.data() + i * floats;
      const bool touching = touch(box_of(a, rows_a.data() + i * static_cast<std::size_t>(a.fields)), of_row_b);
      meetc::near_tile out[1];
      const bool near = of_a.near(single, nullptr, one.data(), 1, out) != out;
      CHECK((!near || out[0].elements == 1)); // the rest of the tile is empty
      sum.touching += touching, sum.apart += !touching;
      sum.lost += touching && !near;
      sum.kept += !touching && near;
      std::copy_n(single, floats, bare_single.begin());
      bare_single[floats - 1] = without_margin(single, of_a.floats);
      sum.lost_without_margins += touching && of_a.near(bare_single.data(), nullptr, bare_tile.data(), 1, out) == out;
    }
  }
  // All tiles at once: the elements that are near one by one.
  for (std::size_t i = 0; i < n; ++i) {
    meetc::near_tile out[n / meetc::filter_tile];
    const meetc::near_tile *const end =
        of_a.near(singles.data() + i * floats, nullptr, tiles.data(), n / meetc::filter_tile, out);
    const meetc::near_tile *at = out;
    for (std::uint32_t t = 0; t < n / meetc::filter_tile; ++t) {
      std::uint32_t alone = 0; // element by element
      for (std::uint32_t k = 0; k < meetc::filter_tile; ++k) {
        const std::size_t j = std::size_t{t} * meetc::filter_tile + k;
        of_b.tiles(frame, rows_b.data() + j * static_cast<std::size_t>(b.fields), 1, one.data());
        meetc::near_tile found[1];
        alone |= (of_a.near(singles.data() + i * floats, nullptr, one.data(), 1, found) != found ? 1U : 0U) << k;
      }
      const bool listed = at < end && at->index == t;
      if ((listed ? at->elements : 0) != alone)
        FAIL("tile " << t << " is said to have other elements than those that are near one by one");
      at += listed;
    }
    CHECK(at == end);
  }
}

} // namespace

TEST_CASE("filter: no pair of touching boxes is lost, and only its margins see to that") {
  for (int s = 0; s < meetc::instruction_set_count; ++s) {
    const meetc::catalogue *const c = cga::catalogue_for(static_cast<meetc::instruction_set>(s));
    if (!c)
      continue;
    INFO(meetc::name_of(c->compiled_for));
    random_numbers random(7);
    outcome sum;
    for (int i = 0; i < c->kind_count; ++i)
      for (int j = 0; j < c->kind_count; ++j)
        for (int again = 0; again < effort(20); ++again)
          check(c->kinds[i], c->kinds[j], random, sum);
    CHECK(sum.touching > effort(20) * 500);
    CHECK(sum.lost == 0);
    CHECK(sum.lost_without_margins > 0); // the test can fail
    CHECK(sum.kept * 10 < sum.apart);    // it rules out most of what is apart
  }
}

TEST_CASE("filter: the balls of tiles lose no pair of touching boxes, and leave out tiles") {
  constexpr std::size_t tile = meetc::filter_tile, n = 700, tiles = (n + tile - 1) / tile; // the last ones are not full
  for (int s = 0; s < meetc::instruction_set_count; ++s) {
    const meetc::catalogue *const c = cga::catalogue_for(static_cast<meetc::instruction_set>(s));
    if (!c)
      continue;
    INFO(meetc::name_of(c->compiled_for));
    random_numbers random(11);
    long touching = 0, looked_at = 0, tiles_there = 0;
    for (int i = 0; i < c->kind_count; ++i)
      for (int j = 0; j < c->kind_count; ++j) {
        const meetc::kind_info &a = c->kinds[i], &b = c->kinds[j];
        const auto floats = static_cast<std::size_t>(a.filter->floats);
        numbers rows_a, rows_b, huge; // those of b near the middle of their tile, and such as no ball rules out
        float middle[3] = {0, 0, 0};
        for (std::size_t k = 0; k < n; ++k) {
          float at[3];
          for (int d = 0; d < 3; ++d) {
            middle[d] = k % tile == 0 ? 50 * random.unit() : middle[d];
            at[d] = middle[d] + 2 * random.unit();
          }
          add_in_cube(b, at, std::fabs(random.unit()), rows_b);
          add_in_cube(b, at, 0x1p127F, huge);
          if (k % 10 == 0) // the first one is too large for a ball
            add_in_cube(a, at, k == 0 ? 0x1p127F : std::fabs(random.unit()), rows_a);
        }
        meetc::filter_extent frame;
        b.filter->widen(rows_b.data(), n, frame);
        const std::size_t count_a = rows_a.size() / static_cast<std::size_t>(a.fields);
        numbers singles(count_a * floats), of_tiles(tiles * tile * floats), near_all(of_tiles.size()),
            of_groups((tiles / tile + 1) * tile * floats);
        a.filter->singles(frame, rows_a.data(), count_a, singles.data());
        b.filter->tiles(frame, rows_b.data(), n, of_tiles.data());
        b.filter->tiles(frame, huge.data(), n, near_all.data());
        b.filter->groups(frame, rows_b.data(), n, of_groups.data());
        for (std::size_t x = 0; x < count_a; ++x)
          for (const std::size_t count : {std::size_t{1}, tile - 1, tile, tile + 1, tiles}) {
            meetc::near_tile all[tiles], left[tiles];
            const float *const single = singles.data() + x * floats;
            const auto *const end = a.filter->near(single, nullptr, of_tiles.data(), count, all);
            const auto *const end_left = a.filter->near(single, of_groups.data(), of_tiles.data(), count, left);
            const meetc::near_tile *at = left;
            for (const meetc::near_tile *t = all; t < end; ++t) { // what is left is as without groups
              const bool listed = at < end_left && at->index == t->index;
              if (listed)
                CHECK(at->elements == t->elements);
              at += listed;
              for (std::size_t k = 0; k < tile; ++k)
                if (const std::size_t y = t->index * tile + k; (t->elements >> k & 1) != 0 && y < n) {
                  const bool touch_here = touch(box_of(a, rows_a.data() + x * static_cast<std::size_t>(a.fields)),
                                                box_of(b, rows_b.data() + y * static_cast<std::size_t>(b.fields)));
                  touching += touch_here;
                  if (touch_here && !listed)
                    FAIL("a tile with an element that touches is left out");
                }
            }
            CHECK(at == end_left);
            looked_at += a.filter->near(single, of_groups.data(), near_all.data(), count, left) - left;
            tiles_there += static_cast<long>(count);
          }
      }
    CHECK(touching > 1000);
    CHECK(looked_at * 5 < tiles_there);
  }
}

TEST_CASE("filter: sets that reach infinity, single points and empty frames lose nothing") {
  const meetc::catalogue &c = cga::catalogue();
  const meetc::kind_info &sphere = kind_named(c, "sphere");
  const float huge = std::numeric_limits<float>::max();
  const numbers rows{huge, 0, 0, huge, 0, 0, 0, 0, 1, 1, 1, 0x1p-149F, -huge, 3, 2, 1, 5, 5, 5, 1e30F};
  const std::size_t n = rows.size() / 4, floats = static_cast<std::size_t>(sphere.filter->floats);
  for (std::size_t framed = 0; framed <= n; ++framed) {
    meetc::filter_extent frame;
    sphere.filter->widen(rows.data(), framed, frame);
    numbers singles(n * floats), tile(meetc::filter_tile * floats);
    sphere.filter->singles(frame, rows.data(), n, singles.data());
    for (std::size_t j = 0; j < framed; ++j) { // the frame is that of these
      sphere.filter->tiles(frame, rows.data() + 4 * j, 1, tile.data());
      for (std::size_t i = 0; i < n; ++i) {
        meetc::near_tile out[1];
        CAPTURE(framed, i, j);
        CHECK((!touch(box_of(sphere, rows.data() + 4 * i), box_of(sphere, rows.data() + 4 * j)) ||
               sphere.filter->near(singles.data() + i * floats, nullptr, tile.data(), 1, out) != out));
      }
    }
  }
}
