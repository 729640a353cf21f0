// Formulas without the instruction for a fused multiply-add: they call nothing of the C library, in C++ and in C, and integers
// are refused where a formula divides.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>

using namespace meetc::compiler_test;

namespace {

const char *const scene = "[scene]\nalgebra = 'cga3.toml'\nnamespace = 'k'\nbackends = ['cpp', 'c']\nkernels = [\n"
                          "'meet(sphere, plane)', 'norm2(meet(sphere, line))', 'meet(circle, circle)', "
                          "'norm2(meet(circle, circle))']\n";

const char *const in_cpp = R"(#include <k/k.hpp>
double c(const k::circle<double> &x, const k::circle<double> &y) { return k::norm2_meet(x, y); }
float s(const k::sphere<float> &x, const k::line<float> &y) { return k::norm2_meet(x, y); }
auto l(const k::circle<double> &x, const k::circle<double> &y) { return k::meet(x, y); }
)";

const char *const in_c = R"(#include <k/k.h>
double c(const k_circle *x, const k_circle *y) { return k_norm2_meet_circle_circle(x, y); }
float s(const k_spheref *x, const k_linef *y) { return k_norm2_meet_sphere_linef(x, y); }
)";

// The exit code, and what the command prints on both streams.
std::pair<int, std::string> shell(const fs::path &folder, const std::string &command) {
  const int status = std::system(
      fmt::format("cd '{}' && ({}) >said 2>&1", folder.string(), command).c_str()); // NOLINT: the test's own words
  return {status, read(folder / "said")};
}

} // namespace

TEST_CASE("without the instruction no formula calls fma(), and with it all use it") {
#if !defined(__x86_64__)
  WARN("not checked: only x86-64 has compilers' flags for both");
#else
  const temporary_folder folder;
  folder.write("s.toml", scene);
  const outcome o = run_meetc("generate s.toml -o out", folder.path());
  INFO(o.err);
  REQUIRE(o.code == 0);
  folder.write("formulas.cpp", in_cpp);
  folder.write("formulas_c.c", in_c);
  struct row {
    const char *compile;
    bool fma;
  };
  for (const row &r : {row{"c++ -std=c++20 -O2 -march=x86-64 -c formulas.cpp -o u.o -I out", false},
                       row{"c++ -std=c++20 -O2 -march=x86-64 -mfma -c formulas.cpp -o u.o -I out", true},
                       row{"cc -std=c99 -O2 -march=x86-64 -c formulas_c.c -o u.o -I out", false},
                       row{"cc -std=c99 -O2 -march=x86-64 -mfma -c formulas_c.c -o u.o -I out", true}}) {
    const auto [failed, said] = shell(folder.path(), r.compile);
    INFO(r.compile << '\n' << said);
    REQUIRE(failed == 0);
    const std::string missing = shell(folder.path(), "nm -u u.o").second;
    const std::string code = shell(folder.path(), "objdump -d u.o").second;
    CHECK(missing.find("fma") == std::string::npos);
    CHECK((code.find("vfmadd") != std::string::npos) == r.fma);
    CHECK(code.find("mulsd") != std::string::npos);
  }
#endif
}

TEST_CASE("a formula with a quotient refuses integers, and the others take them") {
  const temporary_folder folder;
  folder.write("s.toml", scene);
  REQUIRE(run_meetc("generate s.toml -o out", folder.path()).code == 0);
  for (const char *integer : {"int", "__int128", "mpz_class"}) {
    folder.write("halves.cpp", fmt::format("#include <gmpxx.h>\n#include <k/k.hpp>\n"
                                           "auto f(const k::circle<{}> &c) {{ return k::blade(c); }}\n",
                                           integer));
    const auto [failed, said] = shell(folder.path(), "c++ -std=c++20 -fsyntax-only halves.cpp -I out");
    INFO(integer);
    CHECK(failed != 0);
    CHECK_THAT(said, contains("this formula divides; integers would round the quotient"));
  }
  folder.write(
      "whole.cpp",
      "#include <k/k.hpp>\nauto f(const k::sphere<int> &s, const k::line<int> &l) { return k::norm2_meet(s, l); }\n");
  const auto [refused, why] = shell(folder.path(), "c++ -std=c++20 -fsyntax-only whole.cpp -I out");
  INFO(why);
  CHECK(refused == 0);
}
