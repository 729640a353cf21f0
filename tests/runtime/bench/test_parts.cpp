// Brute force, and the rows of the paper's tables with and without a device.
#include "tests/catch.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/made_sets.hpp"
#include "meet/bench/tables/paper/paper.hpp"

#include <cga/cga_runtime.hpp>

#include <fmt/format.h>

#include <algorithm>

using namespace meetc::app;
using namespace meetc::bench;
using namespace meetc::bodies;

TEST_CASE("brute force finds what the search finds, and its sample is a part of it") {
  const meetc::catalogue &all = cga::catalogue();
  const meetc::io::element_set a = of_mesh(all, torus(25, 20)), b = of_mesh(all, knot(100, 25));
  const meetc::choice by = choose(all, *a.kind, *b.kind, {}, {});
  query h;
  h.by = by;
  const std::uint64_t pairs = collide_sets(a, b, h).pairs;
  REQUIRE(pairs > 0);
  const meetc::predicate_info &p = *by.predicate;
  const pair_test certified{decider_of(p, meetc::rung::certified)},
      never{[](meetc::row_array, meetc::row_array, const meetc::index_pair *, std::size_t n, meetc::answer *out) {
        std::fill_n(out, n, meetc::answer::no);
      }};
  const brute_force whole(p, a, b, 5'000'000);
  CHECK_FALSE(whole.is_sample());
  CHECK(whole.pairs() == 5'000'000);
  for (const meetc::rung r : {meetc::rung::certified, meetc::rung::exact}) {
    const difference d = whole.compared({decider_of(p, r)}, certified);
    CHECK(d.found == pairs);
    CHECK(d.wrong() == 0);
  }
  CHECK(whole.compared(never, certified).missed == pairs);
  CHECK(whole.compared(never, certified).extra == 0);
  CHECK(whole.compared(certified, never).extra == pairs);
  const brute_force part(p, a, b, 200'000);
  CHECK(part.is_sample());
  CHECK(part.pairs() <= 200'000);
  CHECK(part.pairs() > 100'000);
  CHECK(part.share() == static_cast<double>(part.pairs()) / 5e6);
  const std::uint64_t in_part = part.compared(certified, certified).found;
  CHECK(in_part < pairs);
  // Rows are left out evenly, so their hits are about as many as their share.
  CHECK(static_cast<double>(in_part) > part.share() * static_cast<double>(pairs) / 3);
  CHECK(static_cast<double>(in_part) < 3 * part.share() * static_cast<double>(pairs));
}

namespace {

class pretended final : public bench_device {
public:
  explicit pretended(std::uint64_t pairs) : pairs_(pairs) {}
  std::string name() const override { return "a device of the tests"; }
  device_time time_every_pair(const device_job &job, int runs) override {
    CHECK(job.by.predicate->name == std::string_view("ball_ball"));
    CHECK(runs == 3);
    return {0.001, 0.004, pairs_};
  }

  std::vector<trade_point> measure(const element_pairs &, int) override { return {}; }
  meetc::result query(const meetc::prepared &, const meetc::prepared &, const meetc::predicate_info &, meetc::rung,
                      int) override {
    return {};
  }

private:
  std::uint64_t pairs_;
};

} // namespace

TEST_CASE("a device's row: milliseconds and a ratio, another count than the CPU's is a failed check") {
  const meetc::catalogue &all = cga::catalogue();
  const meetc::io::element_set balls = of_rows(all, "sphere", sphere_cloud(10, 1, 0.1, 0.2));
  const paper_bodies bodies(all, {}, true);
  answers found;
  paper_context c{all, bodies, nullptr, true, 1, 3, 1000, [] {}};
  const std::vector<pair_test> tests = conformal_and(c, balls, balls, {classic::balls});
  const paper_row without = measure_row(c, balls, balls, tests, found);
  CHECK(without.pairs >= 10);
  CHECK(without.pairs == found.list.size());
  CHECK(without.wrong.size() == 3);
  CHECK(without.search > 0);
  const table none = table_of<paper_row>("t", "t", with_device({}), {without});
  REQUIRE(none.rows[0].size() == 3);
  CHECK(none.rows[0][0].text == "no device");
  CHECK(claim_of(c, {without}).empty());
  pretended right(without.pairs), wrong(without.pairs - 1);
  c.device = &right;
  paper_row with = measure_row(c, balls, balls, tests, found);
  CHECK(with.core_over_device == Approx(with.core() / with.device_search));
  with.core_over_device = 50;
  const table t = table_of<paper_row>("t", "t", with_device({}), {with});
  CHECK(t.rows[0][0].text == "1");
  CHECK(t.rows[0][1].text == "4");
  CHECK(t.rows[0][2].text == "50.0");
  paper_row other = with;
  other.core_over_device = 2000;
  REQUIRE(claim_of(c, {with, other}).size() == 1);
  CHECK(claim_of(c, {with, other})[0].find("50.0 to 2,000.") != std::string::npos);
  c.device = &wrong;
  try {
    measure_row(c, balls, balls, tests, found);
    FAIL("no failure");
  } catch (const failure &e) {
    CHECK(e.code() == check_failed);
    CHECK(std::string(e.what()) ==
          fmt::format("10 spheres and 10 spheres: a device of the tests found {} hits, of which "
                      "0 are false, and missed 1",
                      without.pairs - 1));
  }
  CHECK(bench_device_named("cpu") == nullptr);
  CHECK_THROWS_AS(bench_device_named("tpu"), failure);
}
