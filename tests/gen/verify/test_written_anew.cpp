// Algebras as a user writes them, with the operators of the language. Each had been written with all operators by hand, which
// took more text and as many operations or more.
#include "gen/verify/verify.hpp"
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

// A kernel with the operations that the one by hand took on blades.
struct kernel_row {
  const char *text;
  int multiplications, additions;
};
struct written {
  const char *algebra;
  std::size_t by_hand; // characters
  std::vector<kernel_row> kernels;
};

const written all[] = {
    {"e3",
     737,
     {{"vec*vec", 9, 5},
      {"vec ^ bivec", 3, 2},
      {"meet(bivec, bivec)", 6, 3},
      {"rnorm2(vec)", 3, 2},
      {"~even", 0, 0},
      {"sandwich(even, vec)", 19, 20},
      {"even*even", 16, 12}}},
    {"pga2",
     737,
     {{"vec*vec", 8, 4},
      {"vec ^ bivec", 3, 2},
      {"rnorm2(vec)", 2, 1},
      {"~even", 0, 0},
      {"sandwich(even, vec)", 15, 8},
      {"even*even", 12, 8}}},
    {"cga2",
     1256,
     {{"vec*vec", 14, 9},
      {"vec ^ bivec", 12, 8},
      {"meet(bivec, bivec)", 6, 5},
      {"rnorm2(vec)", 3, 2},
      {"~even", 0, 0},
      {"sandwich(even, vec)", 48, 48},
      {"even*even", 40, 48}}},
    {"cga3_null",
     2225,
     {{"vec*vec", 23, 14},
      {"vec ^ bivec", 30, 20},
      {"rnorm2(vec)", 4, 3},
      {"~even", 0, 0},
      {"sandwich(even, vec)", 144, 146},
      {"even*even", 160, 192},
      {"gram(vec, vec)", 15, 11},
      {"rnorm2(vec ^ vec)", 15, 11}}},
    {"cga3_orthogonal",
     2179,
     {{"vec*vec", 25, 14},
      {"vec ^ bivec", 30, 20},
      {"rnorm2(vec)", 5, 4},
      {"~even", 0, 0},
      {"sandwich(even, vec)", 176, 154},
      {"even*even", 256, 240}}},
    {"sta",
     1229,
     {{"vec*vec", 16, 9},
      {"vec ^ bivec", 12, 8},
      {"meet(bivec, bivec)", 6, 5},
      {"rnorm2(vec)", 4, 3},
      {"~even", 0, 0},
      {"sandwich(even, vec)", 64, 52},
      {"even*even", 64, 56}}},
    {"lie3", 4113, {{"vec*vec", 36, 20}, {"vec ^ bivec", 60, 40}, {"rnorm2(vec)", 6, 5}, {"~even", 0, 0}}},
    {"r33", 4114, {{"vec*vec", 36, 20}, {"vec ^ bivec", 60, 40}, {"rnorm2(vec)", 6, 5}, {"~even", 0, 0}}},
    {"r44", 3239, {{"vec*vec", 64, 35}, {"vec ^ bivec", 168, 112}, {"rnorm2(vec)", 8, 7}}},
    {"pga3",
     1978,
     {{"motor*motor", 48, 40},
      {"rotor*rotor", 16, 12},
      {"translator*rotor", 16, 8},
      {"sandwich(motor, point)", 35, 34},
      {"sandwich(motor, plane)", 35, 34},
      {"sandwich(motor, line)", 72, 58},
      {"sandwich(motor, direction)", 19, 20},
      {"line ^ plane", 12, 8},
      {"plane ^ plane", 12, 6},
      {"point & point", 12, 6},
      {"~motor", 0, 0},
      {"reflect(point, plane)", 17, 15},
      {"rnorm2(plane)", 3, 2},
      {"plane ^ plane ^ plane", 24, 14},
      {"sandwich(rotor, point)", 20, 22},
      {"sandwich(translator, point)", 11, 3},
      {"plane*plane", 15, 8},
      {"unit(motor, point)", 30, 24},
      {"unit(motor, direction)", 15, 12},
      {"unit(motor, plane)", 30, 24},
      {"unit(motor, line)", 48, 47},
      {"unit(rotor, point)", 15, 12},
      {"unit(rotor, direction)", 15, 12},
      {"unit(rotor, plane)", 15, 12}}},
    {"conformal",
     7845,
     {{"motor*motor", 48, 40},
      {"versor*versor", 192, 192},
      {"sandwich(motor, point)", 49, 52},
      {"sandwich(motor, sphere)", 49, 52},
      {"sandwich(motor, plane)", 35, 34},
      {"sandwich(motor, line)", 72, 58},
      {"sandwich(motor, circle)", 148, 126},
      {"sandwich(versor, point)", 152, 146},
      {"sphere & sphere", 20, 10},
      {"meet(sphere, sphere)", 20, 10},
      {"plane & line", 12, 8},
      {"point ^ point", 20, 10},
      {"reflect(point, sphere)", 24, 27},
      {"project(point, plane)", 16, 16},
      {"project(point, line)", 39, 21},
      {"dual(sphere)", 0, 0},
      {"~versor", 0, 0},
      {"rnorm2(circle)", 7, 6},
      {"rnorm2(versor)", 12, 11},
      {"commutator(motor, motor)", 18, 12},
      {"I*(circle ^ point)", 20, 15},
      {"scalar(sphere*sphere)", 5, 4},
      {"sandwich(sphere, point)", 24, 27}}},
};

} // namespace

TEST_CASE("algebras are shorter with the operators of the language, and no kernel takes more operations than by hand") {
  const fs::path folder_of_algebras = source_folder() / "tests/gen/verify/algebras";
  std::size_t files = 0;
  for (const auto &file : fs::directory_iterator(folder_of_algebras))
    files += file.path().extension() == ".toml";
  CHECK(files == std::size(all));
  for (const written &w : all) {
    const temporary_folder folder;
    const std::string text = read(folder_of_algebras / fmt::format("{}.toml", w.algebra));
    folder.write("algebra.toml", text);
    CHECK(text.size() < w.by_hand * 3 / 5);
    std::string kernels;
    for (const kernel_row &k : w.kernels)
      kernels += fmt::format("'{}', ", k.text);
    folder.write("s.toml", fmt::format("[scene]\nalgebra = 'algebra.toml'\nnamespace = 'x'\nkernels = [{}]\n"
                                       "backends = ['cpp', 'c']\n",
                                       kernels));
    compilation c = load((folder.path() / "s.toml").string(), {(source_folder() / "algebra_spec").string()});
    compile_all(c);
    REQUIRE(c.kernels.size() == w.kernels.size());
    for (std::size_t i = 0; i < c.kernels.size(); ++i) {
      const ir::program &p = c.kernels[i].value.from_blades;
      const ir::counts n = ir::count(p.nodes, p.results);
      INFO(w.algebra << ": " << w.kernels[i].text << ", " << n.multiplications + n.fused << '/'
                     << n.additions + n.fused);
      CHECK(n.multiplications + n.fused + n.additions + n.fused <=
            w.kernels[i].multiplications + w.kernels[i].additions);
      const verify::report r = verify::verify_formula(*c.model, c.kernels[i], 8, 5);
      CHECK(r.wrong == 0);
      CHECK(r.cases > 8);
    }
  }
}
