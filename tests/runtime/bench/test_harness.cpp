// The harness: turns by any clock, methods that are checked, and tables as data.
#include "tests/catch.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/bench/harness/method.hpp"
#include "meet/bench/harness/report.hpp"
#include "meet/bench/tables/cpu/cpu.hpp"
#include "meet/io/files/atomic_file.hpp"

#include <cga/cga_runtime.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <unistd.h>

using namespace meetc::bench;
using meetc::answer;
using meetc::index_pair;
using meetc::app::failure;

namespace {

// Time is what the works say that they took.
class pretended final : public clock {
public:
  void start() override { start_ = now; }
  double stop() override { return now - start_; }
  double now = 0;

private:
  double start_ = 0;
};

std::function<difference()> says(difference d) {
  return [d] { return d; };
}

} // namespace

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

TEST_CASE("a table of rows shows its columns of each row") {
  struct row {
    std::string name;
    int hits;
    double seconds;
    double twice() const { return 2 * seconds; }
  };
  const table t =
      table_of<row>("rows", "Rows",
                    {{"name", "name", of_words, &row::name},
                     {"hits", "hits", of_count, &row::hits},
                     {"ms", "ms", of_milliseconds, &row::twice},
                     {"share", "share", [](const row &r) { return r.hits > 0 ? of_share(0.5) : missing(); }}},
                    {{"one", 1000, 0.5}, {"none", 0, 0.001}}, {"A note."});
  CHECK(as_json(t).dump() == R"({"name":"rows","rows":[{"name":"one","hits":1000,"ms":1000,"share":0.5},)"
                             R"({"name":"none","hits":0,"ms":2,"share":null}]})");
  CHECK(as_markdown(t) == "## Rows\n\n| name | hits | ms | share |\n|---|---:|---:|---:|\n"
                          "| one | 1,000 | 1e+03 | 50.0 % |\n| none | 0 | 2 | - |\n\nA note.\n");
}

TEST_CASE("a list of pairs is compared with the exact one") {
  const std::vector<index_pair> truth{{0, 1}, {0, 3}, {2, 0}};
  const auto is = [&truth](const std::vector<index_pair> &found, std::uint64_t extra, std::uint64_t missed) {
    const difference d = difference_of(found, truth);
    return d.found == found.size() && d.extra == extra && d.missed == missed;
  };
  CHECK(is({{2, 0}, {0, 3}, {0, 1}}, 0, 0)); // in any order
  CHECK(is({}, 0, 3));
  CHECK(is({{0, 1}, {0, 2}, {2, 0}}, 1, 1));
  CHECK(is({{0, 1}, {0, 1}, {0, 3}, {2, 0}}, 1, 0)); // twice
  CHECK(is({{5, 5}}, 1, 3));
  const std::vector<answer> given{answer::yes, answer::no, answer::yes}, right{answer::yes, answer::yes, answer::no};
  const difference d = difference_of(given, right);
  CHECK((d.found == 2 && d.extra == 1 && d.missed == 1));
  CHECK((difference_of(3, 5).missed == 2 && difference_of(5, 3).extra == 2 && difference_of(4, 4).wrong() == 0));
}

TEST_CASE("works take turns, and the median of each counts") {
  CHECK(median({}) == 0);
  CHECK(median({3}) == 3);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  pretended by;
  std::string order;
  int run = 0;
  const auto takes = [&](char name, std::vector<double> seconds) {
    return [&, name, seconds, at = std::size_t{0}]() mutable {
      order += name;
      ++run;
      by.now += seconds[at++ % seconds.size()];
    };
  };
  // The first of each warms up.
  const times t = take_turns(by, {takes('a', {100, 1, 2, 9, 3, 4}), takes('b', {7})}, {5, 1e6, 0});
  CHECK(order == "abababababab");
  CHECK(t.repetitions == 5);
  CHECK(t.seconds == std::vector<double>{3, 7});
  // A short work is repeated until a measurement is long enough, and counts as one.
  run = 0;
  CHECK(take_turns(by, {takes('a', {0.25})}, {3, 1e6, 1}).seconds == std::vector<double>{0.25});
  CHECK(run == 1 + 3 * 4);
  CHECK(take_turns(by, {takes('a', {1})}, {1000, 50, 0}).repetitions == 50); // what there is time for
  CHECK(take_turns(by, {takes('a', {1})}, {1000, 0, 0}).repetitions == 3);   // and no fewer
  host_clock here(1);
  CHECK(take_turns(here, {reference_work()}, {3, 1, 0}).seconds[0] > 0);
}

TEST_CASE("medians of the reports of runs, without the first") {
  const std::vector<double> reported{1000, 1, 5, 3};
  std::size_t at = 0;
  const auto [one, other] = medians_of<2>(3, [&] {
    const double x = reported[at++];
    return std::array{x, -x};
  });
  CHECK(at == 4);
  CHECK(one == 3);
  CHECK(other == -3);
}

TEST_CASE("a method that promises the truth and gives another answer ends the benchmark with exit code 1") {
  pretended by;
  const works steps{[&] { by.now += 2; }, [&] { by.now += 3; }};
  const measured_methods m = measure("a scene", by,
                                     {{"exact", true, steps, says({7, 0, 0})},
                                      {"fast", false, {steps[1]}, says({8, 2, 1})},
                                      {"unasked", false, {steps[0]}, {}}},
                                     {3, 1e6, 0});
  REQUIRE(m.of.size() == 3);
  CHECK(m.of[0].seconds == std::vector<double>{2, 3});
  CHECK(m.of[0].found.found == 7);
  CHECK(m.of[1].seconds == std::vector<double>{3});
  CHECK(m.of[1].found.wrong() == 3);
  CHECK_THROWS_AS(measure("a scene", by, {{"unasked", true, {steps[0]}, {}}}, {3, 1e6, 0}), std::logic_error);
  for (const difference wrong : {difference{8, 1, 0}, difference{6, 0, 1}})
    try {
      measure("a scene", by, {{"fast", false, {steps[0]}, says({9, 2, 0})}, {"exact", true, {steps[0]}, says(wrong)}},
              {3, 1e6, 0});
      FAIL("no failure");
    } catch (const failure &e) {
      CHECK(e.code() == meetc::app::check_failed);
      CHECK(std::string(e.what()) == fmt::format("a scene: exact found {} hits, of which {} are false, and missed {}",
                                                 wrong.found, wrong.extra, wrong.missed));
    }
}

TEST_CASE("a certified rung that is wrong ends the table of families") {
  const meetc::catalogue &right = cga::catalogue();
  std::vector<meetc::predicate_info> predicates(right.predicates, right.predicates + right.predicate_count);
  for (meetc::predicate_info &p : predicates)
    if (p.name == std::string_view("triangle_triangle"))
      p.certify[0] = [](meetc::row_array, meetc::row_array, const index_pair *, std::size_t n, answer *out) {
        std::fill_n(out, n, answer::no);
      };
  meetc::catalogue broken = right;
  broken.predicates = predicates.data();
  const cpu_sets sets({broken, {}, true});
  cpu_result to;
  measure_families({{&right}, sets, 1, 3, true}, to);
  REQUIRE(to.tables.size() == 1);
  CHECK(to.tables[0].rows.size() == 6);
  try {
    measure_families({{&broken}, sets, 1, 3, true}, to);
    FAIL("no failure");
  } catch (const failure &e) {
    CHECK(e.code() == meetc::app::check_failed);
    CHECK(std::string(e.what()).find("families: random, overlapping boxes, ") == 0);
    CHECK(std::string(e.what()).find("certified found 0 hits, of which 0 are false, and missed ") != std::string::npos);
  }
  CHECK(to.tables.size() == 1);
}

TEST_CASE("a report is text, a page, an object, and files that are written together") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / fmt::format("meetc-report-{}", ::getpid());
  report r{"Measured", "meet bench some -o DIR", {"On a machine.", "By rules."}, {{"quick", true}}, {}, {}};
  r.tables.push_back({"one", "One", {{"n", "n"}}, {{of_count(3)}}, {}});
  CHECK(as_text(r) == "On a machine.\nBy rules.\n\nOne\n\nn\n3\n");
  CHECK(as_json(r) == "{\"quick\":true,\"tables\":[{\"name\":\"one\",\"rows\":[{\"n\":3}]}]}\n");
  const auto put = [](const fs::path &to) { meetc::io::write_file(to, "x"); };
  r.files = {{"a.csv", put}, {"a.png", put, "A picture"}};
  const std::string page = "# Measured\n\nWritten by `meet bench some -o DIR`.\n\nOn a machine.\n\nBy rules.\n\n"
                           "## One\n\n| n |\n|---|\n| 3 |\n\n## Figures\n\n![A picture](a.png)\n\nA picture\n";
  CHECK(as_markdown(r) == page);
  CHECK(report_folder({}, {"one.md"}).write(r, true) == as_json(r));
  const std::string at = folder.string();
  CHECK(report_folder(folder, {"one.md", "a.csv", "a.png"}).write(r, false) ==
        fmt::format("{}\nwrote {}/one.md\nwrote {}/a.csv\nwrote {}/a.png\n", as_text(r), at, at, at));
  for (const char *const file : {"one.md", "a.csv", "a.png"})
    CHECK(fs::exists(folder / file));
  fs::remove_all(folder);
  r.files[1].write = [](const fs::path &) { throw failure("no picture"); };
  CHECK_THROWS_AS(report_folder(folder, {"one.md", "a.csv", "a.png"}).write(r, false), failure);
  CHECK_FALSE(fs::exists(folder));
  CHECK_THROWS_AS(report_folder(fs::path(), {"one.md"}), failure);
}
