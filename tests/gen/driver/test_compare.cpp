// `meetc compare`: a scene pays only for its own kernels, and wrong arguments give one line.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>
#include <fstream>
#include <map>
#include <sstream>

using namespace meetc::compiler_test;

namespace {

std::string scene(const char *name) {
  return (source_folder() / "algebra_spec" / "scenes" / name).string();
}

// The table's cells by scene and column; of the kinds only the first.
std::map<std::string, std::map<std::string, double>> table_in(const std::string &text) {
  std::istringstream lines(text);
  std::string head, line;
  std::getline(lines, head);
  const std::vector<std::string> columns{"kernels", "files", "C++", "CUDA", "object", "pair", "rare", "stored"};
  std::map<std::string, std::map<std::string, double>> out;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string name;
    cells >> name;
    for (const std::string &c : columns)
      cells >> out[name][c];
    REQUIRE(cells);
  }
  return out;
}

} // namespace

TEST_CASE("compare: small scenes cost a part of the default scene, by the counts that are shown of their kernels") {
  const temporary_folder folder;
  const outcome o = run_meetc(fmt::format("compare '{}' '{}' '{}' '{}'", scene("default.toml"), scene("spheres.toml"),
                                          scene("mesh.toml"), scene("planar.toml")),
                              folder.path());
  INFO(o.out << o.err);
  REQUIRE(o.code == 0);
  auto of = table_in(o.out);
  REQUIRE(of.size() == 4);
  for (const auto &[name, figures] : of)
    for (const auto &[column, figure] : figures) {
      INFO(name << ", " << column);
      CHECK(figure <= of["default"][column]);
    }
  CHECK(of["spheres"]["kernels"] == 1);
  CHECK(of["spheres"]["pair"] == 11); // 4 multiplications and 7 additions, as its header says
  CHECK(of["spheres"]["rare"] == 0);
  CHECK(of["spheres"]["object"] == 0);
  CHECK(of["mesh"]["stored"] == 6); // two normals
  CHECK(of["mesh"]["object"] == 30);
  CHECK(of["mesh"]["C++"] < of["default"]["C++"] / 3);
  CHECK(of["planar"]["CUDA"] == 0);
}

TEST_CASE("compare: sources are compiled, and nothing is left of that") {
  const temporary_folder folder;
  const auto left = [] {
    std::size_t n = 0;
    for (const auto &entry : fs::directory_iterator(fs::temp_directory_path()))
      n += entry.path().filename().string().rfind("meetc-compare-", 0) == 0;
    return n;
  };
  const std::size_t before = left();
  const outcome o = run_meetc(fmt::format("compare '{}' --compile c++", scene("spheres.toml")), folder.path());
  INFO(o.out << o.err);
  REQUIRE(o.code == 0);
  CHECK_THAT(o.out, contains("object KB") && contains("compile s"));
  // The time of a pair, by predicate.
  std::istringstream after(o.out.substr(o.out.find("ns a pair")));
  std::string line, name;
  double nanoseconds = 0;
  std::getline(after, line);
  CHECK_THAT(line, contains("spheres"));
  REQUIRE(after >> name >> nanoseconds);
  CHECK(name == "ball_ball");
  CHECK(nanoseconds > 0);
  CHECK(left() == before);
}

TEST_CASE("compare: no formula needs more than other generators publish") {
  const temporary_folder folder;
  const fs::path peers = source_folder() / "docs" / "examples" / "peers";
  const outcome o = run_meetc(fmt::format("compare '{}' --formulas --beside '{}'",
                                          (peers / "peers_scene.toml").string(), (peers / "published.toml").string()),
                              folder.path());
  INFO(o.out << o.err);
  REQUIRE(o.code == 0);
  std::istringstream lines(o.out.substr(o.out.find("formulas of peers_scene")));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  CHECK_THAT(line, contains("mul/add") && contains("GAmphetamine") && contains("kingdon"));
  int compared = 0, dearer = 0; // where scalings count as multiplications
  while (std::getline(lines, line)) {
    INFO(line);
    // The formula may hold blanks: the cells are read from the right.
    std::istringstream words(line);
    std::vector<std::string> cells;
    for (std::string word; words >> word;)
      cells.push_back(word);
    REQUIRE(cells.size() >= 8);
    const auto pair = [](const std::string &cell) {
      const std::size_t slash = cell.find('/');
      return std::pair(std::stoi(cell.substr(0, slash)), std::stoi(cell.substr(slash + 1)));
    };
    const std::size_t last = cells.size() - 1;
    const auto [products, sums] = pair(cells[last - 6]);
    const int scalings = std::stoi(cells[last - 5]);
    for (std::size_t i = last - 2; i <= last; ++i)
      if (cells[i] != "-") {
        ++compared;
        CHECK(products <= pair(cells[i]).first);
        CHECK(products + sums <= pair(cells[i]).first + pair(cells[i]).second);
        dearer += products + scalings + sums > pair(cells[i]).first + pair(cells[i]).second;
      }
  }
  CHECK(compared == 23);
  CHECK(dearer == 1); // sandwich(motor, e023)/2
}

TEST_CASE("compare: a file of counts has its place where it is wrong") {
  const temporary_folder folder;
  const std::string peers = (source_folder() / "docs" / "examples" / "peers" / "peers_scene.toml").string();
  const auto fails = [&](const std::string &text, const std::string &with) {
    std::ofstream(folder.path() / "counts.toml") << text;
    const outcome o =
        run_meetc(fmt::format("compare '{}' --formulas --beside '{}'", peers, (folder.path() / "counts.toml").string()),
                  folder.path());
    INFO(text << ": " << o.err);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK_THAT(o.err, contains(with));
  };
  fails("", "names its 'generators'");
  fails("generators = ['a']\nsums = 1\n", "counts.toml:2:1: error: a file of counts has no 'sums'");
  fails("generators = ['a']\n[counts]\n'motor*motor' = ['1/2', '3/4']\n", "there are 1 generators and 2 counts");
  fails("generators = ['a']\n[counts]\n'motor' = ['1/2']\n", "counts.toml:3:1: error: no scene asks for 'motor'");
}

TEST_CASE("compare: an error is one line") {
  const temporary_folder folder;
  const auto fails = [&](const std::string &arguments, const std::string &with) {
    const outcome o = run_meetc("compare " + arguments, folder.path());
    INFO(arguments << ": " << o.err);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK_THAT(o.err, contains(with));
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
  };
  fails("", "scenes is required");
  fails("nowhere.toml", "nowhere.toml: cannot be read");
  fails(fmt::format("'{}' --compile no-such-compiler", scene("spheres.toml")), "no-such-compiler: cannot be run");
  fails(fmt::format("'{}' --compile false", scene("spheres.toml")), "false: failed");
}

TEST_CASE("compare --kernels: the same kernel in two algebras, side by side") {
  const temporary_folder folder;
  folder.write("a.toml", small_algebra);
  folder.write("b.toml", edited(small_algebra, "'(B*B)[1]'", "'2*(B*B)[1] + (B*B)[1]'"));
  const std::string kernels = "'norm2(meet(sphere, sphere))', 'touch'";
  folder.write("s.toml", small_scene(kernels));
  folder.write("t.toml",
               edited(edited(small_scene(kernels + ", 'meet(sphere, sphere)'"), "a.toml", "b.toml"), "'x'", "'y'"));
  const outcome o = run_meetc("compare s.toml t.toml --kernels", folder.path());
  INFO(o.out << o.err);
  REQUIRE(o.code == 0);
  std::istringstream lines(o.out.substr(o.out.find("\n\n") + 2));
  std::string line;
  std::getline(lines, line);
  CHECK(line.substr(0, 6) == "kernel");
  CHECK_THAT(line, contains("s: mul/add  s: atoms  s: bound") && contains("t: mul/add  t: atoms  t: bound"));
  std::map<std::string, std::vector<std::string>> cells;
  while (std::getline(lines, line)) {
    const std::size_t end = line.find("  ");
    std::istringstream rest(line.substr(end));
    for (std::string cell; rest >> cell;)
      cells[line.substr(0, end)].push_back(cell);
  }
  REQUIRE(cells.size() == 3);
  const auto &norm = cells["norm2(meet(sphere, sphere))"], &touch = cells["touch"],
             &meet = cells["meet(sphere, sphere)"];
  REQUIRE(norm.size() == 6);
  REQUIRE(meet.size() == 6);
  CHECK(norm[0] != norm[3]); // three times the value is one multiplication more
  CHECK(norm[1] == "-");
  CHECK(meet[0] == "-"); // s does not ask for it
  CHECK(meet[3].find('/') != std::string::npos);
  // A factor 3 is no part of a sign.
  REQUIRE(touch.size() == 6);
  CHECK(std::vector(touch.begin(), touch.begin() + 3) == std::vector(touch.begin() + 3, touch.end()));
  CHECK(touch[1] == "2");
  CHECK(std::stod(touch[2]) > 1);
}

TEST_CASE("compare: scenes of one name are told apart by their paths, and columns are as wide as what they show") {
  const temporary_folder folder;
  const char *const text =
      "[scene]\nalgebra = 'cga3.toml'\nnamespace = 'x'\nkernels = ['norm2(meet(sphere, sphere))']\n";
  for (const char *name : {"a/s.toml", "b/s.toml", "größe.toml", "球.toml"})
    folder.write(name, text);
  const outcome o = run_meetc("compare a/s.toml b/s.toml größe.toml 球.toml --kernels", folder.path());
  REQUIRE(o.code == 0);
  CHECK_THAT(o.out, contains("a/s.toml: mul/add") && contains("b/s.toml: mul/add") && contains("größe: mul/add"));
  std::istringstream lines(o.out);
  std::vector<std::string> rows(5);
  for (std::string &row : rows)
    std::getline(lines, row);
  // "kernels" ends where the digit below it does: two bytes of größe are one column, and three of 球 are two.
  const std::size_t at = rows[0].find("kernels") + 6;
  CHECK(rows[1].substr(0, at + 1).back() == '1');
  CHECK(rows[3].starts_with("größe   "));
  CHECK(rows[3].substr(0, at + 3).back() == '1');
  CHECK(rows[4].substr(0, at + 2).back() == '1');
  CHECK(at == std::string("a/s.toml").size() + 2 + 6);
}
