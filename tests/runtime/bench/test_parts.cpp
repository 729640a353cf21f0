// Tables, brute force, and the interface to a device.
#include "tests/catch.hpp"

#include "app/failure.hpp"
#include "app/made_sets.hpp"
#include "bench/tables/paper/parts.hpp"

#include <cga/cga_runtime.hpp>

#include <array>
#include <cmath>

using namespace meetc::app;
using namespace meetc::bench;
using namespace meetc::bodies;

TEST_CASE("a table as text, Markdown and JSON") {
  table t{"one", "A table", {{"n", "size|of it"}, {"r", "ratio"}}, {}, {"A note."}};
  t.rows.push_back({of_count(1234567), of_ratio(0.5)});
  t.rows.push_back({of_words("a \"b\""), missing("no device")});
  CHECK(as_text(t) == "A table\n\n"
                      "size\n"
                      "of it          ratio\n"
                      "1,234,567       0.50\n"
                      "a \"b\"      no device\n"
                      "\nA note.\n");
  CHECK(as_markdown(t) == "## A table\n\n| size of it | ratio |\n|---|---:|\n| 1,234,567 | 0.50 |\n"
                          "| a \"b\" | no device |\n\nA note.\n");
  CHECK(as_json(t).dump() == R"({"name":"one","rows":[{"n":1234567,"r":0.5},{"n":"a \"b\"","r":null}]})");
  CHECK(of_ratio(INFINITY).value.is_null());
  CHECK(of_ratio(41.96).text == "42.0");
  CHECK(of_ratio(12345.6).text == "12,346");
}

TEST_CASE("every measured cell is a number in JSON") {
  CHECK(of_count(12).value == 12);
  CHECK(of_ratio(41.96).value == 41.96);
  CHECK(of_milliseconds(0.0025).value == 2.5);
  CHECK(of_rate(2.5672e12).value == 2.5672);
  CHECK(of_rate(2.5672e12).text == "2.57");
  CHECK(of_share(0.4615).value == 0.4615);
  CHECK(of_share(0.4615).text == "46.2 %");
}

TEST_CASE("brute force finds what the search finds, and its sample is a part of it") {
  const meetc::catalogue &all = cga::catalogue();
  const meetc::io::element_set a = of_mesh(all, torus(25, 20)), b = of_mesh(all, knot(100, 25));
  const choice by = choose(all, *a.kind, *b.kind, {}, {});
  query h;
  h.by = by;
  const std::uint64_t pairs = collide_sets(a, b, h).pairs;
  REQUIRE(pairs > 0);
  yardstick clock;
  const std::vector<meetc::decide_function> tests{
      decide_by(by, meetc::rung::exact), decide_by(by, meetc::rung::fp32), classic::moller_0,
      [](meetc::row_array, meetc::row_array, const meetc::index_pair *, std::size_t n, meetc::answer *out) {
        std::fill_n(out, n, meetc::answer::no);
      }};
  const brute_force_times whole = time_brute_force(clock, tests, *by.predicate, a, b, 5'000'000, 1);
  CHECK_FALSE(whole.sample);
  CHECK(whole.pairs == 5'000'000);
  CHECK(whole.of[0].yes == pairs);
  CHECK(whole.of[0].wrong_yes + whole.of[0].wrong_no == 0);
  CHECK(whole.of[3].wrong_no == pairs); // never yes
  CHECK(whole.of[3].wrong_yes == 0);
  const brute_force_times part = time_brute_force(clock, tests, *by.predicate, a, b, 200'000, 3);
  CHECK(part.sample);
  CHECK(part.pairs <= 200'000);
  CHECK(part.pairs > 100'000);
  CHECK(part.of[0].yes < pairs);
  // Scaled to all pairs, so about the same. Rows differ by far less than a factor of 3.
  CHECK(part.of[1].time < 3 * whole.of[1].time);
  CHECK(part.of[1].time > whole.of[1].time / 3);
}

namespace {

class pretended final : public bench_device {
public:
  explicit pretended(std::uint64_t pairs) : pairs_(pairs) {}
  std::string name() const override { return "a device of the tests"; }
  device_time time(const device_job &job, int runs) override {
    CHECK(job.by.predicate->name == std::string_view("ball_ball"));
    CHECK(runs == 3);
    return {0.001, 0.004, pairs_};
  }

private:
  std::uint64_t pairs_;
};

} // namespace

TEST_CASE("a device's row: milliseconds and a ratio, another count than the CPU's is a failure") {
  const meetc::catalogue &all = cga::catalogue();
  const meetc::io::element_set balls = of_rows(all, "sphere", sphere_cloud(10, 1, 0.1, 0.2));
  const paper_bodies bodies(all, {}, true);
  yardstick by;
  pretended right(42), wrong(41);
  paper_context c{all, bodies, &right, by, true, 1, 3, 1000, [] {}};
  const device_cells cells = ask_device(c, balls, balls, 42, 0.2 / by.seconds(1));
  REQUIRE(cells.cells.size() == device_columns().size());
  CHECK(cells.cells[0].text == "1");
  CHECK(cells.cells[1].text == "4");
  CHECK(cells.cells[2].text == "50.0"); // 0.2 s over 4 ms
  CHECK(cells.time == Approx(0.004 / by.seconds(1)));
  table t;
  add_claim(c, {cells.core_over_gpu, 2000}, t);
  REQUIRE(t.notes.size() == 1);
  CHECK(t.notes[0].find("50.0 to 2,000.") != std::string::npos);
  c.device = &wrong;
  try {
    ask_device(c, balls, balls, 42, 1);
    FAIL("no failure");
  } catch (const failure &e) {
    CHECK(e.code() == no_device);
    CHECK(std::string(e.what()).find("41 pairs found on the device, 42 on the CPU") != std::string::npos);
  }
  c.device = nullptr;
  CHECK(ask_device(c, balls, balls, 42, 1).cells[0].text == "no device");
  add_claim(c, {0}, t);
  CHECK(t.notes.size() == 1);
  CHECK(bench_device_named("cpu") == nullptr);
  CHECK_THROWS_AS(bench_device_named("tpu"), failure);
}
