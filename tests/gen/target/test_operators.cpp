// The header of operators: sums, multiples, reverses, and the products that a scene asks for; and how little formulas include.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <cstdlib>
#include <fmt/format.h>

using namespace meetc::compiler_test;

namespace {

const char *const scene =
    "[scene]\nalgebra = 'vga3.toml'\nnamespace = 'k'\nkernels = ['rotor * rotor', 'vector ^ vector', "
    "'vector | vector', 'vector * vector', 'rotor * vector']\n";

const char *const uses = R"(#include <k/operators.hpp>
#include <cstdio>
using vector = k::vector_blade<double>;
int main() {
  constexpr vector a{1, 2, 3}, b{4, -5, 7};
  constexpr auto plane = a ^ b;
  static_assert(plane.e1_e2 == 1 * -5 - 2 * 4);
  static_assert((~plane).e1_e2 == -plane.e1_e2 && (-plane).e1_e3 == -plane.e1_e3);
  static_assert((a | b) == 4 - 10 + 21);
  static_assert((2 * a - b + a * 3).e3 == 15 - 7);
  static_assert(noexcept(a ^ b) && noexcept(a + b));
  // A rotor that turns e1 to e2 and, twice, to -e1.
  constexpr k::rotor_blade<double> r = vector{0, 1, 0} * vector{1, 0, 0} * 1;
  constexpr auto twice = r * r;
  static_assert(twice.scalar == -1 && (~r * r).scalar == 1);
  std::puts("right");
}
)";

std::pair<int, std::string> shell(const fs::path &folder, const std::string &command) {
  const int status = std::system(
      fmt::format("cd '{}' && ({}) >said 2>&1", folder.string(), command).c_str()); // NOLINT: the test's own words
  return {status, read(folder / "said")};
}

} // namespace

TEST_CASE("the header of operators has what the scene asks for, and no other product") {
  const temporary_folder folder;
  folder.write("s.toml", scene);
  const outcome o = run_meetc("generate s.toml -o out", folder.path());
  INFO(o.err);
  REQUIRE(o.code == 0);
  folder.write("uses.cpp", uses);
  const auto [failed, said] =
      shell(folder.path(), "c++ -std=c++20 -Wall -Wextra -Wconversion -Werror uses.cpp -I out -o uses && ./uses");
  INFO(said);
  CHECK(failed == 0);
  CHECK(said == "right\n");
  folder.write("other.cpp",
               "#include <k/operators.hpp>\nauto f(const k::vector_blade<> &a, const k::rotor_blade<> &b) { "
               "return a * b; }\n");
  CHECK(shell(folder.path(), "c++ -std=c++20 -fsyntax-only other.cpp -I out").first != 0);
}

TEST_CASE("a formula's header includes neither the decisions of predicates nor <cmath>") {
  const temporary_folder folder;
  folder.write("s.toml", scene);
  REQUIRE(run_meetc("generate s.toml -o out", folder.path()).code == 0);
  const auto [failed, headers] =
      shell(folder.path(), "echo '#include <k/operators.hpp>' | c++ -std=c++20 -M -x c++ - -I out");
  REQUIRE(failed == 0);
  CHECK_THAT(headers, contains("meetc/number/formula.hpp"));
  for (const char *heavy : {"meetc/decide/", "meetc/support.hpp", "cmath"})
    CHECK(headers.find(heavy) == std::string::npos);
}
