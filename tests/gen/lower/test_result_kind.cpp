// The types of values: by their grades, and by the coefficients that are zero.
#include "gen/lower/kernel/compile.hpp"
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

// Planes as vectors, with motors; the scalar of a translator is 1.
const char *const planes = R"([algebra]
vectors = ['e0', 'e1', 'e2', 'e3']
squares = [0, 1, 1, 1]
[kinds.plane]
store = ['a: real', 'b: real', 'c: real', 'd: real']
blade = 'a*e1 + b*e2 + c*e3 + d*e0'
[kinds.point]
store = ['x: real', 'y: real', 'z: real']
blade = 'e123 - x*e023 - y*e031 - z*e012'
[kinds.motor]
store = ['s: real', 'a: real', 'b: real', 'c: real', 'd: real', 'e: real', 'f: real', 'p: real']
blade = 's + a*e23 + b*e31 + c*e12 + d*e01 + e*e02 + f*e03 + p*e0123'
[kinds.translator]
store = ['d: real', 'e: real', 'f: real']
blade = '1 + d*e01 + e*e02 + f*e03'
[functions]
'gp(A, B)' = 'A*B'
)";

std::string type_of(const compilation &c, const std::string &request) {
  const lang::kind *k = compile_text(c, request).value.result_kind;
  return k ? k->name : "";
}

} // namespace

TEST_CASE("a value is no kind whose blade has a number other than 0 where the value has 0") {
  const compilation &c = default_scene();
  const std::pair<const char *, const char *> wanted[] = {
      {"dual(plane)", ""}, // a point's coefficient on nb is -1
      {"meet(line, line)", ""},
      {"dual(sphere)", "point"}, // a vector with all coefficients
      {"meet(sphere, sphere)", "circle"},
      {"meet(sphere, plane)", "circle"},
      {"meet(plane, plane)", "line"},
      {"meet(line, sphere)", "point_pair"},
      {"meet(line, plane)", "flat_point"},
      {"rev(line)", "line"},
  };
  for (const auto &[request, kind] : wanted) {
    INFO(request);
    CHECK(type_of(c, request) == kind);
  }
}

TEST_CASE("a product of planes is a motor, whose last coefficient may be 0") {
  const temporary_folder folder;
  folder.write("a.toml", planes);
  const compilation c = load(folder.write("s.toml", small_scene("'gp(plane, plane)'")).string());
  const std::pair<const char *, const char *> wanted[] = {
      {"gp(plane, plane)", "motor"},
      {"gp(motor, motor)", "motor"},
      {"sandwich(motor, plane)", "plane"},
      {"sandwich(motor, point)", "point"},
      {"gp(translator, translator)", "translator"},
      {"grade(translator, 2)", "motor"}, // without the 1 it is no translator
      {"dual(point)", "plane"},
      {"dual(plane)", "point"},
      {"gp(plane, point)", "motor"},
      {"plane & point", ""},
  };
  for (const auto &[request, kind] : wanted) {
    INFO(request);
    CHECK(type_of(c, request) == kind);
  }
}

TEST_CASE("versors compose and act across blades and stored operands") {
  const temporary_folder folder;
  folder.write("a.toml", planes);
  folder.write("s.toml",
               small_scene("'gp(motor, motor)', 'sandwich(motor, point)', 'gp(plane, plane)', 'rnorm2(motor)', "
                           "'gp(motor, translator)'"));
  REQUIRE(run_meetc("generate s.toml -o out", folder.path()).code == 0);
  CHECK(read(folder.path() / "out/x/gp_plane_plane.hpp").find("const plane<T> &X, const plane_blade<T> &Y") ==
        std::string::npos); // no versor, and so no mixture
  folder.write("use.cpp", R"(#include <x/x.hpp>
#include <cstdio>
int main() {
  const x::plane<double> a{1, 2, 2, 3}, b{2, -1, 2, -1}, c{0, 1, 1, 5}, d{3, 1, -1, 2};
  const auto ab = x::gp(a, b), cd = x::gp(c, d); // motors, as blades
  const x::point<double> p{1, -2, 4};
  const x::motor<double> m{ab.scalar, ab.e2_e3, -ab.e1_e3, ab.e1_e2, ab.e0_e1, ab.e0_e2, ab.e0_e3, ab.e0_e1_e2_e3};
  const auto by_blade = x::sandwich(x::gp(cd, ab), p);
  const auto mixed = x::sandwich(x::gp(cd, m), blade(p));
  const auto moved = x::sandwich(cd, x::sandwich(m, p));
  const bool same = by_blade.e0_e2_e3 == mixed.e0_e2_e3 && mixed.e0_e2_e3 == moved.e0_e2_e3 &&
                    mixed.e1_e2_e3 == moved.e1_e2_e3 && mixed.e0_e1_e2 == moved.e0_e1_e2;
  const x::translator<double> t{1, 2, 3};
  std::printf("%d %d %d\n", same, x::rnorm2(m) == x::rnorm2(ab), x::gp(ab, t).scalar == ab.scalar);
}
)");
  const outcome o =
      run_meetc("--version > said; c++ -std=c++20 -Wall -Wextra -Werror -Iout use.cpp -o use && ./use", folder.path());
  INFO(o.err);
  CHECK(o.code == 0);
  CHECK(o.out == "1 1 1\n");
}
