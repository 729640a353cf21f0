// The baseline's hierarchy, made and asked on the host, against all pairs.
#include "tests/catch.hpp"

#include "meet/bench/baselines/lbvh.hpp"
#include "meet/bench/truth/numbers.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace {

using namespace meetc::baselines;

struct hierarchy {
  std::vector<lbvh_box> boxes; // of the leaves
  std::vector<lbvh_node> nodes;

  // Leaves arrive in an order that depends on `seed`.
  hierarchy(std::vector<lbvh_box> unsorted, std::uint64_t seed) {
    const std::size_t n = unsorted.size();
    lbvh_box within = unsorted[0];
    for (const lbvh_box &b : unsorted)
      within = around(within, b);
    std::vector<std::pair<std::uint32_t, std::size_t>> keys;
    for (std::size_t i = 0; i < n; ++i)
      keys.emplace_back(morton_code(unsorted[i], within.lo, within.hi), i);
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> codes, of_nodes(n), of_leaves(n), arrived(n);
    for (const auto &[code, i] : keys)
      codes.push_back(code), boxes.push_back(unsorted[i]);
    nodes.resize(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i)
      link(codes.data(), static_cast<std::int64_t>(n), static_cast<std::int64_t>(i), nodes.data(), of_nodes.data(),
           of_leaves.data());
    std::vector<std::size_t> leaves(n);
    std::iota(leaves.begin(), leaves.end(), std::size_t{0});
    meetc::bench::numbers random(seed);
    for (std::size_t i = n; i > 1; --i)
      std::swap(leaves[i - 1], leaves[random.next() % i]);
    for (const std::size_t leaf : leaves)
      fit(
          boxes[leaf], of_leaves[leaf], nodes.data(), of_nodes.data(),
          [&](std::uint32_t node) { return arrived[node]++ != 0; }, [](const lbvh_box &b) { return b; });
    for (std::size_t i = 0; i + 1 < n; ++i)
      CHECK(arrived[i] == 2);
  }

  std::vector<std::uint32_t> asked(const lbvh_box &q, std::int64_t after) const {
    std::vector<std::uint32_t> out;
    walk(nodes.data(), walking_box{q}, after, [&out](std::uint32_t leaf) { out.push_back(leaf); });
    std::sort(out.begin(), out.end());
    return out;
  }
  std::vector<std::uint32_t> expected(const lbvh_box &q, std::int64_t after) const {
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (static_cast<std::int64_t>(i) > after && overlap(q, boxes[i]))
        out.push_back(static_cast<std::uint32_t>(i));
    return out;
  }
};

std::vector<lbvh_box> balls(std::size_t n, std::uint64_t seed, int places, float radius) {
  meetc::bench::numbers random(seed);
  std::vector<lbvh_box> out;
  for (std::size_t i = 0; i < n; ++i) {
    float row[4] = {0, 0, 0, radius};
    for (int d = 0; d < 3; ++d)
      row[d] = places > 0 ? static_cast<float>(random.below(places)) : random.place();
    out.push_back(box_of<4>(row));
  }
  return out;
}

} // namespace

TEST_CASE("lbvh: a walk visits each leaf whose box overlaps once, with equal codes too") {
  for (const std::size_t n : {2, 3, 4, 5, 31, 64, 65, 1000})
    for (const int places : {0, 1, 2, 5}) { // 0: spread; else few places, and so many equal codes
      INFO(n << " leaves, " << places << " places");
      const hierarchy h(balls(n, n, places, places > 0 ? 0.25F : 0.2F), 7 * n);
      for (const lbvh_box &q : balls(20, n + 1, places, 0.3F))
        CHECK(h.asked(q, -1) == h.expected(q, -1));
      for (std::size_t i = 0; i < n; i += 1 + n / 50) {
        const auto after = static_cast<std::int64_t>(i);
        CHECK(h.asked(h.boxes[i], after) == h.expected(h.boxes[i], after));
      }
    }
}

TEST_CASE("lbvh: a walk to the first finds the least entry, and leaves out what lies behind it") {
  std::size_t visited = 0;
  const hierarchy h(balls(2000, 3, 0, 0.1F), 4);
  meetc::bench::numbers random(5);
  for (int i = 0; i < 200; ++i) {
    float row[6];
    for (float &x : row)
      x = 3 * random.place() - 1;
    const walking_segment q(row);
    float want = 2, have = 2;
    for (const lbvh_box &b : h.boxes)
      want = std::min(want, q.entry(b, 1));
    walk_to_first(h.nodes.data(), q, [&](std::uint32_t leaf, float &most) {
      ++visited;
      have = most = std::min(most, q.entry(h.boxes[leaf], most));
    });
    CHECK(have == want);
  }
  CHECK(visited < 200 * 20);
}

TEST_CASE("lbvh: codes put a box's centre into one of 1024 cells of each axis") {
  const float lo[3] = {0, 0, 5}, hi[3] = {1024, 1024, 5}; // the third side has no length
  const auto code = [&](float x, float y) {
    const float row[4] = {x, y, 5, 0};
    return morton_code(box_of<4>(row), lo, hi);
  };
  CHECK(code(0, 0) == 0);
  CHECK(code(1.5F, 0) == 1);
  CHECK(code(0, 1.5F) == 2);
  CHECK(code(1023, 0) == 0x09249249U);
  CHECK(code(1024, 1024) == (0x09249249U | 0x09249249U << 1));
  CHECK(code(512, 0) == 1U << 27);
}

TEST_CASE("lbvh: boxes of rows") {
  const float triangle[9] = {1, 5, 0, 3, 4, -2, 2, 6, 1};
  const lbvh_box b = box_of<9>(triangle);
  CHECK((b.lo[0] == 1 && b.lo[1] == 4 && b.lo[2] == -2 && b.hi[0] == 3 && b.hi[1] == 6 && b.hi[2] == 1));
  const float segment[6] = {1, 5, 0, 3, 4, -2};
  CHECK((box_of<6>(segment).lo[1] == 4 && box_of<6>(segment).hi[1] == 5));
}

TEST_CASE("lbvh: a segment reaches the boxes that it goes through, and ends where it ends") {
  const auto reaches = [](const float(&segment)[6], const float(&box)[6]) {
    return walking_segment(segment).reaches({{box[0], box[1], box[2]}, {box[3], box[4], box[5]}});
  };
  const float along_x[6] = {0, 0.5F, 0.5F, 4, 0.5F, 0.5F}, oblique[6] = {4, 4, 4, 0, 0, 0};
  CHECK(reaches(along_x, {1, 0, 0, 2, 1, 1}));
  CHECK(reaches(along_x, {-1, 0, 0, 9, 1, 1}));
  CHECK(reaches(along_x, {3, 0, 0, 9, 1, 1}));
  CHECK(!reaches(along_x, {5, 0, 0, 9, 1, 1}));
  CHECK(!reaches(along_x, {-2, 0, 0, -1, 1, 1}));
  CHECK(!reaches(along_x, {1, 1, 0, 2, 2, 1}));
  CHECK(reaches(oblique, {1, 1, 1, 2, 2, 2}));
  CHECK(!reaches(oblique, {1, 1, 3, 2, 2, 4}));
}
