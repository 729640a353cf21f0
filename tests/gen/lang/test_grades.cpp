// Kinds that are given by grades.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

std::string algebra_with(const std::string &kind) {
  return "[algebra]\nvectors = ['x', 'y', 'z']\nsquares = [1, 0, -1]\n[kinds.any]\n" + kind +
         "\n[functions]\n'gp(A, B)' = 'A * B'\n";
}

compilation compiled(const temporary_folder &folder, const std::string &kind) {
  folder.write("a.toml", algebra_with(kind));
  folder.write("s.toml",
               "[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nkernels = ['gp(any, any)']\nbackends = ['cpp']\n");
  compilation c = load((folder.path() / "s.toml").string());
  compile_all(c);
  return c;
}

} // namespace

TEST_CASE("a kind of grades stores a number for each of its blades, by grade and in the order of the vectors") {
  const temporary_folder by_grades, by_hand;
  const compilation c = compiled(by_grades, "grades = [0, 2, 3]");
  std::vector<std::string> stored;
  for (const lang::field &f : c.scene->in.find_kind("any")->store) {
    stored.push_back(f.name);
    CHECK(f.type == "real");
  }
  CHECK(stored == std::vector<std::string>{"c_1", "c_x_y", "c_x_z", "c_y_z", "c_x_y_z"});
  const compilation d = compiled(by_hand, "store = ['a: real', 'b: real', 'c: real', 'd: real', 'e: real']\n"
                                          "blade = 'a + b*(x^y) + c*(x^z) + d*(y^z) + e*(x^y^z)'");
  REQUIRE(c.kernels[0].value.polynomials.size() == 6); // not on x nor on z
  REQUIRE(c.kernels[0].value.result_names == d.kernels[0].value.result_names);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(c.kernels[0].value.polynomials[i].text() == d.kernels[0].value.polynomials[i].text());
  CHECK(run_meetc("verify s.toml --cases 100", by_grades.path()).code == 0);
}

TEST_CASE("grades that say nothing, or what the algebra lacks, are refused") {
  struct refusal {
    const char *kind, *message;
  };
  for (const auto &[kind, message] : {
           refusal{"grades = [0, 4]", "a.toml:5:10: error: kind 'any' has grade 4, and the algebra has 3 vectors"},
           refusal{"grades = [2, 0]", "a.toml:5:14: error: kinds.any.grades ascend"},
           refusal{"grades = [1, 1]", "a.toml:5:14: error: kinds.any.grades ascend"},
           refusal{"grades = []", "a.toml:5:10: error: kinds.any.grades is empty"},
           refusal{"grades = 2", "a.toml:5:10: error: kinds.any.grades"},
           refusal{"grades = [0.5]", "a.toml:5:11: error: kinds.any.grades are whole numbers, as in [0, 2]"},
           refusal{"grades = [-1]", "a.toml:5:11: error: kinds.any.grades are whole numbers, as in [0, 2]"},
           refusal{"grades = [0]\nstore = ['a: real']", "a.toml:6:9: error: kinds.any has 'grades'"},
           refusal{"grades = [0]\nblade = '1'", "a.toml:6:9: error: kinds.any has 'grades'"},
           refusal{"grades = [1]\nposition = true", "a.toml:6:12: error: kinds.any has 'grades'"},
       }) {
    const temporary_folder folder;
    folder.write("a.toml", algebra_with(kind));
    folder.write("s.toml", "[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nkernels = ['gp(any, any)']\n");
    const outcome o = run_meetc("show s.toml --emit=counts", folder.path());
    INFO(kind);
    CHECK(o.code == 2);
    CHECK_THAT(o.err, contains(message));
  }
}
