// The long mode in short: every family for every predicate on every rung, and nothing certified is wrong.
#include "tests/extremes/campaign.hpp"
#include "tests/generated/catch.hpp"
#include "tests/generated/effort.hpp"

using namespace meetc::extremes_test;
using meetc::generated_test::effort;

TEST_CASE("extremes: no rung certifies anything wrong") {
  std::vector<cell> cells = all_cells();
  CHECK(cells.size() == 100);
  run(cells, {static_cast<std::uint64_t>(effort(500000)), 1});
  for (const cell &c : cells) {
    INFO(c.first_wrong);
    CHECK(c.found.all_wrong() == 0);
  }
  // Families are worth something only where answers differ and rungs are pressed.
  for (const family &f : families()) {
    counts sum;
    for (const cell &c : cells)
      if (c.from == &f)
        sum += c.found;
    INFO(f.name);
    CHECK(sum.hits > sum.cases / 20);
    CHECK(sum.hits < sum.cases - sum.cases / 20);
    CHECK(sum.boxed > sum.cases / 8);
    for (const std::uint64_t unsure : sum.unsure)
      CHECK(unsure > 0);
    CHECK(sum.unsure[fp32] > sum.unsure[fp64]);
    CHECK(sum.unsure[fp64] >= sum.unsure[fp64x2]);
  }
}

TEST_CASE("extremes: the counts depend on the seed and not on the threads") {
  std::vector<cell> one = all_cells(), two = all_cells();
  run(one, 10000, 7, 1, [](std::uint64_t, std::uint64_t) {});
  run(two, 10000, 7, 2, [](std::uint64_t, std::uint64_t) {});
  CHECK(table(one) == table(two));
}
