// Charts: gnuplot draws points where they belong, the same file each time, and a missing gnuplot is reported.
#include "tests/catch.hpp"
#include "tests/runtime/picture/decode.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/bench/harness/chart.hpp"
#include "meet/bench/tables/gpu/growth_chart.hpp"
#include "meet/picture/image.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <unistd.h>

using namespace meetc::bench;
using meetc::picture::decode;
using meetc::picture::image;

namespace {

std::filesystem::path here(const char *name) {
  return std::filesystem::temp_directory_path() / ("meetc-" + std::to_string(::getpid()) + "-" + name);
}

std::string bytes_of(const std::filesystem::path &file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

using points = std::vector<std::pair<double, double>>;

chart one_curve(points p) {
  return {"A title", "x of a 'chart'", "y_of it", {{"the_curve", curve_colours::red, std::move(p)}}};
}

// The columns and rows of the curve's own colour below the legend: first and last; the last is 0 without any.
std::array<int, 4> drawn(const chart &c) {
  const std::filesystem::path file = here("drawn.png");
  plot_of(c, 600, 400).draw(file);
  const image p = decode(bytes_of(file));
  std::filesystem::remove(file);
  REQUIRE(p.width == 600);
  REQUIRE(p.height == 400);
  std::array<int, 4> box{p.width, 0, p.height, 0};
  for (int y = 40; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x)
      if (p.at(x, y) == curve_colours::red)
        box = {std::min(box[0], x), std::max(box[1], x), std::min(box[2], y), std::max(box[3], y)};
  return box;
}

} // namespace

TEST_CASE("a chart draws its points at their places on logarithmic axes") {
  const std::array<int, 4> two = drawn(one_curve({{1, 1}, {10000, 100}}));
  // (100, 10) is at the midpoint of both axes, and so on the line.
  CHECK(drawn(one_curve({{1, 1}, {100, 10}, {10000, 100}})) == two);
  CHECK(two[1] - two[0] > 300);
  CHECK(two[3] - two[2] > 150);
  // The same axes, which another curve spans: the half of it is half as long both ways, but for the points' size.
  chart part = one_curve({{1, 1}, {100, 10}});
  part.curves.push_back({"spans", curve_colours::cpu, {{1, 100}, {10000, 1}}});
  const std::array<int, 4> half = drawn(part);
  CHECK(half[0] == two[0]);
  CHECK(std::abs(2 * (half[1] - half[0]) - (two[1] - two[0])) < 20);
  CHECK(std::abs(2 * (half[3] - half[2]) - (two[3] - two[2])) < 40); // the legend takes another line
}

TEST_CASE("points that a logarithmic chart cannot show are left out") {
  const std::array<int, 4> none = drawn(one_curve({{1, 0}, {10, -1}, {100, NAN}, {INFINITY, 1}}));
  CHECK(none[1] == 0);
  CHECK(drawn(one_curve({}))[1] == 0);
}

TEST_CASE("the same chart is the same file, and its words are in the script") {
  const chart c = one_curve({{1000, 0.5}, {1e6, 2000}});
  const std::filesystem::path x = here("x.png"), y = here("y.png");
  plot_of(c, 800, 450).draw(x);
  plot_of(c, 800, 450).draw(y);
  CHECK(bytes_of(x) == bytes_of(y));
  std::filesystem::remove(x), std::filesystem::remove(y);
  const std::string values = plot_of(c, 800, 450).values();
  for (const char *const part :
       {"title_words = 'A title'", R"(x_words = 'x of a '."'".'chart'."'".'')", "y_words = 'y_of it'",
        "names[1] = 'the_curve'", "x_low = 3\n", "x_high = 6\n", "y_low = -1\n", "y_high = 4\n"})
    CHECK(values.find(part) != std::string::npos);
  CHECK(plot("chart").set("line", "two\nlines").values() == "line = 'two lines'\n"); // no text becomes a command
}

TEST_CASE("a file that cannot be written and a missing gnuplot are one-line errors") {
  CHECK_THROWS_AS(plot_of(one_curve({{1, 1}}), 600, 400).draw(here("no-such-folder") / "x.png"), meetc::app::failure);
  CHECK_NOTHROW(need_gnuplot());
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  try {
    need_gnuplot();
    FAIL("no failure");
  } catch (const meetc::app::failure &e) {
    CHECK(std::string(e.what()).find("gnuplot was not found") != std::string::npos);
  }
  CHECK_THROWS_AS(plot_of(one_curve({{1, 1}}), 600, 400).draw(here("x.png")), meetc::app::failure);
  ::setenv("PATH", path.c_str(), 1);
}

TEST_CASE("growth: the times by the number of balls, without rows that were too slow or have no balls") {
  const meetc::app::json results = meetc::app::json::parse(R"({"device": "A GPU, of some kind", "tables": [
    {"name": "ball_ball", "rows": []},
    {"name": "growth", "rows": [
      {"scene": "balls, 40 x 40", "a": 40, "every_first": null, "tree_first": 2},
      {"scene": "balls, 10 x 10", "a": 10, "every_first": 0.5, "tree_first": 1},
      {"scene": "Bunny x Armadillo", "a": 70, "every_first": 1, "tree_first": 1}]}]})");
  const std::optional<chart> c = growth_chart(results);
  REQUIRE(c);
  CHECK(c->y_label == "Milliseconds, A GPU");
  REQUIRE(c->curves.size() == 2);
  CHECK(c->curves[0].points == points{{10, 0.5}});
  CHECK(c->curves[1].points == points{{10, 1}, {40, 2}});
  CHECK(!growth_chart(meetc::app::json::parse(R"({"device": "", "tables": []})")));
}

TEST_CASE("growth: a chart is drawn of a file, and another file is refused") {
  const std::filesystem::path folder = here("growth"), file = folder / "gpu.json";
  std::filesystem::create_directory(folder);
  const auto refusal = [&](const char *text) {
    std::ofstream(file) << text;
    try {
      draw_growth(file, folder);
    } catch (const meetc::io::error &e) {
      return std::string(e.what());
    }
    return std::string("none");
  };
  for (const char *text : {"{", "[]", "7", R"({"tables": 1})", R"({"tables": [{"name": "growth"}]})"})
    CHECK(refusal(text).find("gpu.json: not an object as `meet bench gpu --json` prints it") != std::string::npos);
  CHECK(refusal(R"({"tables": []})").find("gpu.json: it has no table of growth") != std::string::npos);
  CHECK(!std::filesystem::exists(folder / "growth.png"));
  std::ofstream(file) << R"({"device": "A GPU, of some kind", "tables": [{"name": "growth", "rows": [
    {"scene": "balls, 10 x 10", "a": 10, "every_first": 0.5, "tree_first": 1}]}]})";
  CHECK(draw_growth(file, folder).find("growth.png") != std::string::npos);
  CHECK(decode(bytes_of(folder / "growth.png")).width == 800);
  std::filesystem::remove_all(folder);
}
