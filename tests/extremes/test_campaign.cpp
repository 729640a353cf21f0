// A short run of the long mode: every family for every predicate on every rung. Nothing certified is wrong, by the
// signs or by geometry.
#include "tests/catch.hpp"
#include "tests/extremes/campaign.hpp"
#include "tests/generated/judge/effort.hpp"

#include <cga/cga_runtime.hpp>
#include <fmt/format.h>

using namespace meetc::extremes_test;
using meetc::generated_test::effort;

TEST_CASE("extremes: no rung certifies anything wrong") {
  std::vector<cell> cells = all_cells();
  CHECK(cells.size() == 227);
  run(cells, {static_cast<std::uint64_t>(effort(500000)), 1});
  for (const cell &c : cells) {
    INFO(c.first_wrong);
    CHECK(c.found.all_wrong() == 0);
  }
  // Every instruction set that runs here saw every case of a decision.
  for (int set = 0; set < meetc::instruction_set_count; ++set) {
    const bool runs = cga::catalogue_for(static_cast<meetc::instruction_set>(set)) != nullptr;
    for (const cell &c : cells)
      CHECK(c.found.sets[static_cast<std::size_t>(set)].cases == (runs && !c.of->sign ? c.found.cases : 0));
  }
  // Families are useful only where answers differ and rungs are challenged.
  for (const family &f : families()) {
    counts sum;
    for (const cell &c : cells)
      if (c.from == &f)
        sum += c.found;
    INFO(f.name);
    CHECK(sum.hits > sum.cases / 20);
    CHECK(sum.hits < sum.cases - sum.cases / 20);
    CHECK((sum.boxed > sum.cases / 8 || f.make == near_overflow)); // whose boxes float32 has not
    for (int r = 0; r < bounded;
         ++r) // doubles, and more so double-doubles, are all but exact at the limit of the former
      CHECK((sum.unsure[static_cast<std::size_t>(r)] > 0 || (r == fp64x2 && f.make == at_exact_steps)));
    CHECK(sum.unsure[fp32] > sum.unsure[fp64]);
    CHECK(sum.unsure[fp64] >= sum.unsure[fp64x2]);
  }
}

TEST_CASE("extremes: the counts depend on the seed and not on the threads") {
  for (const judge by : {judge::signs, judge::geometry}) {
    std::vector<cell> one = all_cells(), two = all_cells();
    run(one, {20000, 7, 1, by});
    run(two, {20000, 7, 2, by});
    CHECK(table(one, by) == table(two, by));
  }
}

TEST_CASE("extremes: the table says what was judged, by whom, and where cases are few") {
  std::vector<cell> cells = all_cells();
  run(cells, {20000, 8, 2, judge::geometry});
  for (std::size_t i = 0; i < 3; ++i)
    cells[i].found.cases = enough_cases - 1 + i;
  const std::string text = table(cells, judge::geometry);
  INFO(text.substr(0, 300));
  CHECK(text.find("judge: geometry") == 0);
  CHECK(text.find(fmt::format("{} families, {} predicates, {} cells that apply, at least {} cases a cell; cells with "
                              "fewer than 10000 cases: {}\n",
                              families().size(), subjects().size(), cells.size(), cells[3].found.cases,
                              cells.size() - 2)) != std::string::npos);
  CHECK(table(cells, judge::signs).find("judge: signs") == 0);
}

TEST_CASE("extremes: geometry agrees with every rung and with the decision on signs") {
  std::vector<cell> cells = all_cells();
  run(cells, {static_cast<std::uint64_t>(effort(500)) * cells.size(), 2, 2, judge::geometry});
  for (const cell &c : cells) {
    INFO(c.first_wrong);
    CHECK(c.found.all_wrong() == 0);
    CHECK(c.found.cases >= static_cast<std::uint64_t>(effort(500)));
  }
}

TEST_CASE("extremes: contradictions to the geometry are counted, and only by that judge") {
  // Spheres that are declared solid: their predicate takes them for surfaces, so nested ones are wrong.
  subject solid = subject_named("sphere_sphere");
  solid.surface = false;
  for (const judge by : {judge::signs, judge::geometry}) {
    std::vector<cell> cells = {{&family_named("tangent"), &solid, {}, {}}};
    run(cells, {2000, 9, 2, by});
    const bool geometric = by == judge::geometry;
    const counts &found = cells.front().found;
    CHECK((found.sets.front().wrong > 0) == geometric);
    CHECK((wrong_in(cells) > 0) == geometric);
    for (const rung r : {fp32, fp64, fp64x2, exact_rung, certified, on_signs})
      CHECK((found.wrong[r] > 0) == geometric);
    CHECK((table(cells, by).find("wrong: sphere_sphere on tangent") != std::string::npos) == geometric);
  }
}
