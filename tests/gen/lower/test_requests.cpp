// The requests of a scene: expressions of kinds, many operands, and wildcards.
#include "gen/verify/verify.hpp"
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

// A scene of the shipped algebra of space.
compilation asked(const temporary_folder &folder, const std::string &kernels, const std::string &more = "") {
  folder.write("s.toml",
               fmt::format("[scene]\nalgebra = '{}'\nnamespace = 'x'\nkernels = [{}]\nbackends = ['cpp', 'c']\n{}",
                           (source_folder() / "algebra_spec" / "cga3.toml").string(), kernels, more));
  compilation c = load((folder.path() / "s.toml").string());
  compile_all(c);
  return c;
}

std::vector<std::string> texts(const compilation &c) {
  std::vector<std::string> out;
  for (const lower::kernel &k : c.kernels)
    out.push_back(k.asked.text);
  return out;
}

bool has(const std::vector<std::string> &all, const std::string &text) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

} // namespace

TEST_CASE("any expression of kinds is a kernel, with a name that says it") {
  const temporary_folder folder;
  const compilation c = asked(
      folder, "'2*meet(sphere, plane)', '~circle', 'e12*line', 'meet(line, line)[n]', '-dual(plane)', 'plane & plane', "
              "'point ^ point ^ n', '(sphere | plane)/0.5', 'sandwich(sphere*plane, point)', 'line - line'");
  const std::vector<std::string> names{"product_2_meet_sphere_plane",
                                       "rev_circle",
                                       "product_e12_line",
                                       "part_meet_line_line",
                                       "negative_dual_plane",
                                       "regressive_plane_plane",
                                       "wedge_wedge_point_point",
                                       "quotient_inner_0_5_sphere_plane",
                                       "sandwich_product_sphere_plane_point",
                                       "difference_line_line"};
  REQUIRE(c.kernels.size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    INFO(c.kernels[i].asked.text);
    CHECK(c.kernels[i].asked.name() == names[i]);
    const verify::report r = verify::verify_formula(*c.model, c.kernels[i], 10, 2);
    CHECK(r.wrong == 0);
    CHECK(r.cases > 10);
  }
  // The doubled meet has the coefficients of the meet, doubled.
  const lower::kernel plain = compile_text(c, "meet(sphere, plane)");
  REQUIRE(plain.value.polynomials.size() == c.kernels[0].value.polynomials.size());
  for (std::size_t i = 0; i < plain.value.polynomials.size(); ++i)
    CHECK(plain.value.polynomials[i].scaled(2).text() == c.kernels[0].value.polynomials[i].text());
  CHECK(run_meetc("generate s.toml -o out", folder.path()).code == 0);
  CHECK_THAT(read(folder.path() / "out/x/product_2_meet_sphere_plane.hpp"), contains(" product_2_meet("));
}

TEST_CASE("a kernel has as many operands as it names, up to sixteen") {
  const temporary_folder folder;
  std::string sum = "direction";
  for (int i = 1; i < 16; ++i)
    sum += " + direction";
  const compilation c = asked(folder, "'norm2(direction*direction*direction*direction*direction)', '" + sum + "'");
  CHECK(c.kernels[0].asked.names == std::vector<std::string>{"X", "Y", "Z", "W", "X5"});
  CHECK(c.kernels[1].asked.names.back() == "X16");
  for (const lower::kernel &k : c.kernels)
    CHECK(verify::verify_formula(*c.model, k, 20, 2).wrong == 0);
  CHECK(run_meetc("generate s.toml -o out", folder.path()).code == 0);
}

TEST_CASE("an operand's name is none of a vector or a constant of the algebra") {
  const temporary_folder folder;
  folder.write("a.toml",
               "[algebra]\nvectors = ['X', 'Y']\nsquares = [1, 1]\n[kinds.vec]\nstore = ['a: real', 'b: real']\n"
               "blade = 'a*X + b*Y'\n[functions]\n'f(A)' = 'X*A'\n");
  compilation c = load(folder.write("s.toml", small_scene("'X*vec', 'f(vec)'")).string());
  compile_all(c);
  CHECK(c.kernels[0].asked.names.front() == "Xo");
  CHECK(c.kernels[0].value.polynomials.size() == 2);
  for (const lower::kernel &k : c.kernels)
    CHECK(verify::verify_formula(*c.model, k, 20, 2).wrong == 0);
}

TEST_CASE("meet(*, *) is the meet of every pair of kinds that has one, on the shipped algebra") {
  const temporary_folder folder;
  const compilation c = asked(folder, "'meet(*, *)', 'norm2(meet(*, line))'");
  const std::vector<std::string> all = texts(c);
  std::vector<const lang::kind *> kinds;
  for (const lang::kind &k : c.scene->in.kinds)
    if (k.name != "segment" && k.name != "triangle" && k.name != "box" && k.name != "triangle_pair")
      kinds.push_back(&k);
  REQUIRE(kinds.size() == 8);
  // Defined is where the grades say so; a meet that is always 0 is left out.
  const std::map<std::string, int> grade{{"point", 1}, {"direction", 1}, {"point_pair", 2}, {"flat_point", 2},
                                         {"line", 3},  {"circle", 3},    {"plane", 4},      {"sphere", 4}};
  std::size_t defined = 0, zero = 0;
  for (const lang::kind *x : kinds)
    for (const lang::kind *y : kinds) {
      const std::string text = fmt::format("meet({}, {})", x->name, y->name);
      INFO(text);
      if (grade.at(x->name) + grade.at(y->name) < 5) {
        CHECK_FALSE(has(all, text));
        continue;
      }
      ++defined;
      const lower::kernel k = compile_text(c, text);
      const bool is_zero = k.value.polynomials.size() == 1 && k.value.polynomials[0].is_zero();
      zero += is_zero;
      CHECK(has(all, text) != is_zero);
    }
  CHECK(defined == 40);
  CHECK(zero < 6);
  CHECK(has(all, "norm2(meet(sphere, line))"));
  CHECK_FALSE(has(all, "norm2(meet(line, line))")); // it is 0 for all lines
  CHECK_FALSE(has(all, "norm2(meet(point, line))"));
  CHECK(run_meetc("verify s.toml --cases 100", folder.path()).code == 0);
  CHECK(run_meetc("generate s.toml -o out", folder.path()).err.empty());
}

TEST_CASE("a scene may say of which kinds its wildcards are") {
  const temporary_folder folder;
  const compilation c = asked(folder, "'meet(*, *)'", "kinds = ['sphere', 'plane']\n");
  CHECK(texts(c) == std::vector<std::string>{"meet(sphere, sphere)", "meet(sphere, plane)", "meet(plane, sphere)",
                                             "meet(plane, plane)"});
}
