// `meetc targets` says what each target carries: whatever its table says is generated, and all else is refused.
#include "gen/target/target.hpp"
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

// The meaning of a column: the kernels and the rungs of a scene, and what a refusal says.
struct request {
  const char *column, *kernels, *rest, *refusal;
};
constexpr request requests[] = {
    {"formulas", "norm2(meet(sphere, sphere))", "rungs = ['fp32']", "carries no formulas"},
    {"gives,exp", "gives(point)", "rungs = ['fp32']", "carries no functions but polynomials"},
    {"plain", "ball_ball", "rungs = ['fp32']", "carries no predicates"},
    {"certified", "ball_ball", "rungs = ['certified']", "carries no certified answers"},
    {"tolerant", "ball_ball", "rungs = ['fp32', 'tolerant']\nbox = 10\ntolerance = 1e-3",
     "carries no answers within a tolerance"},
};

// The cells of a line, which no more than one space parts within.
std::vector<std::string> cells(const std::string &line) {
  std::vector<std::string> out;
  for (std::size_t from = 0; from < line.size();) {
    const std::size_t to = std::min(line.find("  ", from), line.size());
    out.push_back(line.substr(from, to - from));
    from = std::min(line.find_first_not_of(' ', to), line.size());
  }
  return out;
}

} // namespace

TEST_CASE("the table of targets says what is generated and what is refused") {
  const temporary_folder folder;
  const outcome listed = run_meetc("targets", folder.path());
  REQUIRE(listed.code == 0);
  std::istringstream lines(listed.out);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> titles = cells(line);
  std::vector<std::string> names;
  int refused = 0;
  while (std::getline(lines, line)) {
    const std::vector<std::string> row = cells(line);
    REQUIRE(row.size() == titles.size());
    names.push_back(row.front());
    for (const request &r : requests) {
      const auto column = std::find(titles.begin(), titles.end(), r.column) - titles.begin();
      REQUIRE(column < std::ssize(row));
      folder.write("s.toml", fmt::format("[scene]\nalgebra = 'cga3_gives.toml'\nnamespace = 'k'\nbackends = ['{}']\n"
                                         "kernels = ['{}']\n{}\n",
                                         row.front(), r.kernels, r.rest));
      const outcome o = run_meetc("generate s.toml -o out", folder.path());
      INFO(row.front() << ", " << r.column << '\n' << o.err);
      const std::string &says = row[static_cast<std::size_t>(column)];
      CHECK((says == "yes" || says == "-"));
      CHECK((o.code == 0) == (says == "yes"));
      if (o.code != 0) {
        CHECK_THAT(o.err, contains(r.refusal));
        ++refused;
      }
    }
  }
  CHECK(names == target::backends().known);
  CHECK(refused > 0);
}

TEST_CASE("shaders compute in float32 alone") {
  const temporary_folder folder;
  for (const char *name : {"glsl", "wgsl"}) {
    folder.write("s.toml", fmt::format("[scene]\nalgebra = 'cga3.toml'\nnamespace = 'k'\nbackends = ['{}']\n"
                                       "kernels = ['ball_ball']\nrungs = ['fp64']\n",
                                       name));
    const outcome o = run_meetc("generate s.toml -o out", folder.path());
    CHECK(o.code == 2);
    CHECK_THAT(o.err,
               contains(fmt::format("s.toml:5:13: error: the backend '{}' computes in float32 alone, and the scene "
                                    "asks for 'ball_ball' without the rung 'fp32'",
                                    name)));
  }
}

TEST_CASE("reserved words and the names that replace them are different members of a shader") {
  const temporary_folder folder;
  folder.write("a.toml", "[algebra]\nvectors = ['e1', 'e2']\nsquares = [1, 1]\n[kinds.pair]\n"
                         "store = ['buffer: real', 'm_buffer: real']\nblade = 'buffer*e1 + m_buffer*e2'\n");
  folder.write("s.toml", "[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nbackends = ['glsl', 'wgsl']\n"
                         "rungs = ['fp32']\nkernels = ['pair*pair']\n");
  REQUIRE(run_meetc("generate s.toml -o out", folder.path()).code == 0);
  CHECK_THAT(read(folder.path() / "out" / "k" / "k.glsl"),
             contains("float m_buffer;") && contains("float m_m_buffer;"));
  CHECK_THAT(read(folder.path() / "out" / "k" / "k.wgsl"), contains("m_m_buffer: f32"));
}
