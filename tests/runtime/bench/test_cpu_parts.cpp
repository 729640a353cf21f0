// The parts of `meet bench cpu`: bars and the families of pairs.
#include "tests/catch.hpp"

#include "meet/bench/scenes/pair_families.hpp"
#include "meet/bench/tables/cpu/cpu.hpp"

#include <cga/cga_runtime.hpp>

#include <algorithm>
#include <array>

using namespace meetc::bench;
using meetc::answer;
using meetc::index_pair;

TEST_CASE("a bar is met at its limit, and not where nothing was measured") {
  using side = bar::side;
  CHECK(bar{"w", "f", side::at_least, 2, "x", 2.0}.met());
  CHECK_FALSE(bar{"w", "f", side::at_least, 2, "x", 1.99}.met());
  CHECK(bar{"w", "f", side::at_most, 1.15, "x", 1.15}.met());
  CHECK_FALSE(bar{"w", "f", side::at_most, 1.15, "x", 1.16}.met());
  CHECK_FALSE(bar{"w", "f", side::at_most, 1, "x", {}, "no such library"}.met());
  const table t = table_of_bars(
      {{"work", "figure", side::at_most, 1.15, "x", 1.5}, {"w", "f", side::at_least, 2, "ms", {}, "why"}});
  CHECK(as_markdown(t).find("| work | figure | ≤ 1.15 x | 1.50 x | **no** |") != std::string::npos);
  CHECK(as_markdown(t).find("| w | f | ≥ 2 ms | why | - |") != std::string::npos);
  CHECK(as_json(t)["rows"][0]["met"] == false);
  CHECK(as_json(t)["rows"][1]["met"].is_null());
}

TEST_CASE("the families of pairs deserve their names") {
  const std::vector<pair_family> families = pair_families(50);
  REQUIRE(families.size() == 6);
  const meetc::catalogue &all = cga::catalogue();
  const auto *const found = std::find_if(all.predicates, all.predicates + all.predicate_count,
                                         [](const auto &p) { return p.name == std::string_view("triangle_triangle"); });
  std::vector<index_pair> pairs(50);
  for (std::uint32_t i = 0; i < 50; ++i)
    pairs[i] = {i, i};
  const auto volume = [](const float *a, const float *p) { // 6 times that of a and p, on the lattice exactly
    std::array<double, 9> d{};
    for (std::size_t k = 0; k < 3; ++k) {
      d[k] = static_cast<double>(a[3 + k]) - static_cast<double>(a[k]);
      d[3 + k] = static_cast<double>(a[6 + k]) - static_cast<double>(a[k]);
      d[6 + k] = static_cast<double>(p[k]) - static_cast<double>(a[k]);
    }
    return d[0] * (d[4] * d[8] - d[5] * d[7]) - d[1] * (d[3] * d[8] - d[5] * d[6]) + d[2] * (d[3] * d[7] - d[4] * d[6]);
  };
  for (const pair_family &f : families) {
    INFO(f.name);
    REQUIRE(f.pairs() == 50);
    std::vector<answer> out(50);
    found->decide[static_cast<int>(meetc::rung::exact)](f.a.data(), f.b.data(), pairs.data(), 50, out.data());
    const auto hits = std::count(out.begin(), out.end(), answer::yes);
    const bool shares = f.name.find("shared") != std::string::npos;
    CHECK((shares ? hits == 50 : hits > 5 && hits < 50));
    for (std::size_t i = 0; i < 9 * f.pairs(); i += 9) {
      CHECK((f.name != "a shared edge" || std::equal(&f.a[i], &f.a[i] + 6, &f.b[i])));
      CHECK((!shares || std::equal(&f.a[i], &f.a[i] + 3, &f.b[i])));
      const double v[] = {volume(&f.a[i], &f.b[i]), volume(&f.a[i], &f.b[i + 3]), volume(&f.a[i], &f.b[i + 6])};
      if (f.name == "oblique coplanar")
        CHECK((v[0] == 0 && v[1] == 0 && v[2] == 0));
      else if (f.name == "three corners rounded onto a plane")
        CHECK(std::all_of(v, v + 3, [](double x) { return std::abs(x) < 1e-5; }));
      else if (f.name == "one corner rounded onto a plane")
        CHECK((std::abs(v[0]) < 1e-5 && std::abs(v[1]) > 1e-5));
    }
  }
}
