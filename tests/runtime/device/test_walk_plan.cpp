// Boxes in whole numbers, and the plan by which a walk is cut into items.
#include "tests/runtime/device/host/host_warp.hpp"

#include "meet/core/device/walk/packet_cells.hpp"
#include "meet/core/device/walk/walk_plan.hpp"
#include "tests/catch.hpp"

#include <bit>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

using namespace meetc;
using namespace meetc::cuda;

namespace {

// One of the ends of float32, of numbers around 0, or of any bits.
float extreme(std::mt19937_64 &random) {
  constexpr float some[] = {0, 0x1p-149F, 0x1p-148F, FLT_MIN, 0x1p-40F, 1, 0x1.000002p0F, 0x1p23F, 0x1p126F, FLT_MAX};
  const auto bits = static_cast<std::uint32_t>(random());
  const float any = std::bit_cast<float>(bits), x = some[random() % std::size(some)];
  return random() % 3 == 0 && std::isfinite(any) ? any : random() % 2 ? x : -x;
}
tree_box extreme_box(std::mt19937_64 &random) {
  tree_box b;
  for (int k = 0; k < 3; ++k) {
    const float x = extreme(random), y = random() % 4 == 0 ? x : extreme(random);
    b.low[k] = y < x ? y : x, b.high[k] = y < x ? x : y;
  }
  return b;
}

} // namespace

TEST_CASE("walk: boxes that touch have cells that do, at the ends of float32 too") {
  std::mt19937_64 random(4);
  int touching = 0, told_apart = 0, lost = 0;
  for (int round = 0; round < 100000; ++round) {
    tree_box own[4], around;
    const auto n = static_cast<int>(1 + random() % 4);
    for (int i = 0; i < n; ++i) {
      own[i] = i > 0 && random() % 16 == 0 ? tree_box() : extreme_box(random);
      around.widen(own[i]);
    }
    const packet_cells in_packet(around);
    for (int other = 0; other < 4; ++other) {
      const tree_box b = random() % 32 == 0 ? tree_box() : extreme_box(random);
      for (int i = 0; i < n; ++i) {
        std::uint32_t bits = 0;
        packet_cells::push(bits, in_packet.of(b), in_packet.of(own[i]));
        touching += own[i].touches(b), told_apart += bits == 0;
        lost += own[i].touches(b) && bits == 0;
      }
    }
  }
  CHECK(lost == 0);
  CHECK(touching > 100000);
  CHECK(told_apart > 100000);
}

// The number of items is a product of three numbers of 32 bits.
TEST_CASE("walk: no plan has more items than 32 bits count, whatever the sizes of the sets") {
  std::vector<std::uint32_t> sizes;
  for (int bit = 0; bit < 32; ++bit)
    for (const int off : {-1, 0, 1})
      if (const auto n = (std::int64_t{1} << bit) + off; n > 0)
        sizes.push_back(static_cast<std::uint32_t>(n));
  sizes.push_back(0xffffffff);
  constexpr int fields = 7;
  constexpr point_fields points{{0, 1, 2, 3, 4, 5}, 6};
  const float row[fields] = {};
  for (const std::uint32_t walker : sizes)
    for (const std::uint32_t tree : sizes)
      for (const unsigned enough : {1U, 31U, 1U << 10, 18'432U, 1U << 17})
        for (const float *const rows : {static_cast<const float *>(nullptr), row}) {
          const tree_view x{nullptr, walker, tree_shape(walker)}, y{nullptr, tree, tree_shape(tree)};
          const tree_walk w{x,  y,      {0, x.shape.count[0], 0, y.shape.count[0]}, false, false, rows, fields, points,
                            {}, nullptr};
          const walk_plan plan = plan_of(w, enough);
          const std::uint64_t all =
              std::uint64_t{x.shape.count[0]} * (rows ? plan.long_groups : 1) * plan.chunks * plan.child_groups;
          REQUIRE(plan.items == all);
        }
}
