// The parts under the hierarchy: the box test, sorting, the spatial order, enclosing levels.
#include "tests/catch.hpp"
#include "toy.hpp"

#include "meet/core/answers/pair_list.hpp"
#include "meet/core/hierarchy/spatial_order.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meet/core/threads/radix_sort.hpp"
#include "meetc/volume/hilbert.hpp"

#include <mutex>

using namespace meetc;
using namespace toy;

TEST_CASE("one box against sixteen is sixteen tests, not a number means candidate") {
  std::mt19937 g(60);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const float values[] = {0, -0.0f, 1, 2, 3, -1, 1e-45f, -1e-45f, 3e38f, inf, -inf, nan};
  for (int round = 0; round < 20000; ++round) {
    const auto any = [&] {
      box b;
      for (int k = 0; k < 3; ++k) {
        b.lo[k] = values[g() % std::size(values)];
        b.hi[k] = values[g() % std::size(values)];
      }
      return b;
    };
    box_block block;
    for (int i = 0; i < lanes; ++i)
      block.set(i, any());
    const box q = any();
    std::uint32_t want = 0;
    for (int i = 0; i < lanes; ++i) {
      bool apart = false;
      for (int k = 0; k < 3; ++k)
        apart |= q.hi[k] < block.lo[k][i] || block.hi[k][i] < q.lo[k];
      want |= apart ? 0u : 1u << i;
    }
    REQUIRE(touching(block, q) == want);
    const box s = sanitised(q);
    for (int k = 0; k < 3; ++k) {
      REQUIRE((std::isfinite(s.lo[k]) && std::isfinite(s.hi[k])));
      REQUIRE((!(s.lo[k] > q.lo[k]) || q.lo[k] == -inf));
      REQUIRE((!(s.hi[k] < q.hi[k]) || q.hi[k] == inf));
    }
    block.clear();
    REQUIRE(touching(block, s) == 0);
  }
}

TEST_CASE("the radix sort sorts, stably, any width") {
  std::mt19937_64 g(61);
  for (const int bits : {0, 1, 8, 11, 12, 30, 38, 63, 64})
    for (const std::size_t n : {0U, 1U, 32U, 33U, 3000U, 50'000U}) {
      const std::uint64_t mask = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
      std::vector<std::pair<std::uint64_t, std::size_t>> data(n), scratch(n);
      for (std::size_t i = 0; i < n; ++i)
        data[i] = {g() >> (g() % 64), i};
      const auto given = data;
      auto want = data;
      std::stable_sort(want.begin(), want.end(),
                       [&](const auto &x, const auto &y) { return (x.first & mask) < (y.first & mask); });
      const auto key = [](const auto &x) { return x.first; };
      radix_sort(data.data(), scratch.data(), n, bits, key);
      CHECK(data == want);
      for (const std::size_t parts : {std::size_t{1}, std::size_t{7}, most_sort_parts})
        for (const int threads : {1, 3}) {
          std::size_t finished = 0;
          std::mutex one;
          std::fill(data.begin(), data.end(), std::pair<std::uint64_t, std::size_t>{});
          radix_sort_parts(
              parts,
              [&](std::size_t p, const auto &visit) {
                const std::size_t begin = n * p / parts, end = n * (p + 1) / parts, middle = (begin + end) / 2;
                visit(given.data() + begin, middle - begin);
                visit(given.data() + middle, end - middle);
              },
              data.data(), bits, threads, key,
              [&](int, std::size_t begin, std::size_t) { return scratch.data() + begin; },
              [&](std::size_t begin, std::size_t some, auto *) {
                const std::scoped_lock lock(one);
                finished += some;
                CHECK(std::equal(want.begin() + static_cast<std::ptrdiff_t>(begin),
                                 want.begin() + static_cast<std::ptrdiff_t>(begin + some),
                                 data.begin() + static_cast<std::ptrdiff_t>(begin)));
              });
          CHECK(finished == n);
          CHECK(data == want);
        }
    }
}

TEST_CASE("lists of pairs become one sorted list") {
  std::mt19937 g(62);
  for (const std::uint32_t range : {1u, 3u, 300u, 70'000u, 0xffffffffu})
    for (const std::size_t n : {0u, 5u, 40'000u}) {
      std::vector<std::vector<index_pair>> lists(3);
      std::vector<index_pair> want;
      for (std::size_t i = 0; i < n; ++i) {
        const index_pair p{static_cast<std::uint32_t>(g()) % range, static_cast<std::uint32_t>(g()) % range};
        lists[g() % 3].push_back(p);
        want.push_back(p);
      }
      std::sort(want.begin(), want.end(),
                [](index_pair x, index_pair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
      const std::vector<pair_span> spans(lists.begin(), lists.end());
      CHECK(same(sorted(spans, 2), want));
      for (std::vector<index_pair> &l : lists)
        sort_pairs(l);
      CHECK(same(sorted(spans, 2), want));
    }
}

TEST_CASE(
    "the pairs of several workers become one sorted list, whoever found them and however close together they lie") {
  std::mt19937 g(64);
  struct found {
    std::size_t n;
    std::uint32_t most_a, most_b, popular; // one pair in this many has the first a; 0: none
  };
  // None, few, some; one a in each bucket, or very many pairs of one; numbers of 32 bits; and all pairs the same.
  for (const found f : {found{0, 9, 9, 0},
                        {100, 9, 9, 0},
                        {13'000, 1000, 1000, 0},
                        {200'000, 300'000, 1u << 30, 0},
                        {200'000, 300'000, 1u << 30, 9},
                        {200'000, 3000, 70'000, 0},
                        {50'000, 0xffffffff, 99, 0},
                        {50'000, 255, 0xffffffff, 0},
                        {20'000, 0, 0, 0}})
    for (const int threads : {1, 2, 8}) {
      std::vector<pair_list> workers(static_cast<std::size_t>(threads));
      std::vector<index_pair> want(f.n);
      for (index_pair &p : want) {
        p.a = static_cast<std::uint32_t>(g() % (std::uint64_t{f.most_a} + 1));
        p.b = static_cast<std::uint32_t>(g() % (std::uint64_t{f.most_b} + 1));
        if (f.popular != 0 && g() % f.popular == 0)
          p.a = 0;
      }
      for (std::size_t at = 0, some; at < f.n; at += some) {
        some = std::min<std::size_t>(g() % 3000, f.n - at);
        const std::size_t w = g() % 4 == 0 ? g() % workers.size() : 0; // most are the first one's
        workers[w].add(want.data() + at, some);
      }
      std::sort(want.begin(), want.end(),
                [](index_pair x, index_pair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
      CHECK(same(sorted(std::move(workers), threads), want));
    }
}

TEST_CASE("the spatial order is a permutation, the same on any number of threads, and keeps ties") {
  std::mt19937 g(63);
  for (const std::size_t n : {1u, 16u, 17u, 1000u, 9000u, 300'000u})
    for (const int spread : {0, 1, 277}) { // all equal; one scale; every scale
      std::vector<box> b(n);
      for (box &x : b)
        for (int k = 0; k < 3; ++k) {
          const float v = spread == 0   ? 1.0f
                          : spread == 1 ? uniform(g, -1, 1)
                                        : std::ldexp(1.0f, static_cast<int>(g() % 277) - 149);
          x.lo[k] = x.hi[k] = v;
        }
      std::vector<std::uint64_t> one(n), four(n), scratch(n);
      centre_extent all;
      std::vector<centre> centres;
      for (const box &x : b)
        all.add(centres.emplace_back(x));
      spatial_order(centres.data(), nullptr, all, n, one.data(), scratch.data(), 1);
      spatial_order(centres.data(), nullptr, all, n, four.data(), scratch.data(), 4);
      CHECK(one == four);
      std::vector<std::uint32_t> order(one.begin(), one.end());
      if (spread == 0)
        CHECK(std::is_sorted(order.begin(), order.end()));
      std::sort(order.begin(), order.end());
      for (std::size_t i = 0; i < n; ++i)
        REQUIRE(order[i] == i);
    }
}

TEST_CASE("the spatial order is that of Hilbert's curve") {
  std::mt19937 g(66);
  std::vector<centre> centres;
  std::vector<std::uint64_t> want;
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    std::uint32_t cell[3];
    box b;
    for (int k = 0; k < 3; ++k)
      cell[k] = static_cast<std::uint32_t>(g()) % 1024, b.lo[k] = b.hi[k] = static_cast<float>(cell[k]) + 0.5f;
    centres.emplace_back(b);
    want.push_back(std::uint64_t{hilbert_place(cell[0], cell[1], cell[2], 10)} << 32 | i);
  }
  std::sort(want.begin(), want.end());
  centre_extent all; // in which a cell has side 1
  std::fill_n(all.lo, 3, 0.0f);
  std::fill_n(all.hi, 3, 1024.0f);
  std::vector<std::uint64_t> keys(want.size()), scratch(want.size());
  spatial_order(centres.data(), nullptr, all, want.size(), keys.data(), scratch.data(), 2);
  for (std::size_t i = 0; i < want.size(); ++i)
    REQUIRE(static_cast<std::uint32_t>(keys[i]) == static_cast<std::uint32_t>(want[i]));
}

TEST_CASE("one far element does not spoil the order of the others") {
  rows r = some_boxes(4000, 1, 0.001f, 64);
  std::fill(r.begin(), r.begin() + 6, 3e38f);
  const prepared x = prepare(view_of(r, boxes), boxes);
  const level &blocks = x.set().boxes.levels[1];
  std::vector<float> widths;
  for (std::size_t i = 0; i < blocks.boxes; ++i)
    widths.push_back(blocks.get(i).hi[0] - blocks.get(i).lo[0]);
  std::sort(widths.begin(), widths.end());
  CHECK(widths[widths.size() / 2] < 0.5f); // of a cube two wide
}

TEST_CASE("every level encloses the one below") {
  for (const std::size_t n : {0u, 1u, 16u, 17u, 256u, 257u, 5000u}) {
    const prepared x = prepare(view_of(some_boxes(n, 1, 0.1f, 65), boxes), boxes);
    const hierarchy &h = x.set().boxes;
    if (n == 0) {
      CHECK(h.depth == 0);
      continue;
    }
    CHECK(h.depth >= 2);
    CHECK(h.top().count() == 1);
    for (int k = 1; k < h.depth; ++k)
      for (std::size_t i = 0; i < h.levels[k - 1].boxes; ++i) {
        const box in = h.levels[k - 1].get(i), out = h.levels[k].get(i / lanes);
        for (int c = 0; c < 3; ++c)
          REQUIRE((out.lo[c] <= in.lo[c] && in.hi[c] <= out.hi[c]));
      }
  }
}
