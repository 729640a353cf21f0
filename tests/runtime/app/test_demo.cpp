// `meet demo`: a table, coloured meshes and pictures, without any input.
#include "fixture.hpp"

using namespace fixture;

TEST_CASE("the demo writes what it says and its meshes give the counts it prints") {
  fs::remove_all(at("show"));
  const said s = run({"demo", "-o", "show"});
  INFO(s.err);
  REQUIRE(s.code == 0);
  for (const char *const predicate : {"triangle_triangle", "segment_triangle", "ball_triangle", "ball_ball"})
    CHECK(has(s.out, predicate));
  std::size_t written = 0;
  std::istringstream lines(s.out);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("wrote ", 0) == 0) {
      ++written;
      CHECK(fs::file_size(folder() / line.substr(6)) > 10000);
    }
  CHECK(written == 12);
  CHECK(has(s.out, "\nOpen show/animal-figure.html in a browser: turn the scene, and click on a pair to fly there.\n"));
  CHECK(files_in(at("show")) == written);
  const std::uint64_t pairs = answer({"show/animal.ply", "show/figure.ply"})["pairs"];
  CHECK(pairs == 1690);
  CHECK(has(s.out, "1,690"));
  // It can be run again, with the same files.
  const std::string before = get(at("show/animal-figure.png"));
  const std::string page = get(at("show/animal-figure.html"));
  CHECK(run({"demo", "-o", "show"}).code == 0);
  CHECK(get(at("show/animal-figure.png")) == before);
  CHECK(get(at("show/animal-figure.html")) == page);
}

TEST_CASE("a folder that cannot be used") {
  put("plain", "no folder");
  CHECK(has(complaint({"demo", "-o", "plain"}), "plain: is not a folder"));
  CHECK(has(complaint({"demo", "-o", "/proc/none"}), "/proc"));
}
