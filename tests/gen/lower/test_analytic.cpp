// Functions that are no polynomials: where they stand, what they take, and what is said where they do not go.
#include "gen/lang/analytic.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {
constexpr const char *of_side = "'sign(meet(H, p))'";

const broken rows[] = {
    {"", "", "s.toml:4:19",
     "'exp' is no polynomial, and so stands in no formula and no sign; ask for it as a kernel of its own",
     "exp(sphere)", "", "'norm2(exp(sphere))'"},
    {of_side, "'sign(norm(p))'", "a.toml:32:22", "'norm' is no polynomial", "norm(p)", "", "'touch'"},
    {of_side, "'sign(sqrt(norm2(p)))'", "a.toml:32:22", "'sqrt' is no polynomial", "sqrt(norm2(p))", "", "'touch'"},
    {"", "", "s.toml:4:13", "'gives' takes 1 argument, not 2", "gives(sphere, point)", "", "'gives(sphere, point)'"},
    {"", "", "s.toml:4:19",
     "'gives' takes a kind, as in 'gives(point)'; ask for 'meet(sphere, sphere)' as another kernel",
     "meet(sphere, sphere)", "", "'gives(meet(sphere, sphere))'"},
    {"", "", "s.toml:4:19", "no kind 'sphre'", "sphre", "", "'gives(sphre)'"},
    {"", "", "s.toml:4:13", "the algebra has no table [gives.sphere]; it has none of [gives.KIND]", "gives(sphere)", "",
     "'gives(sphere)'"},
    {"", "", "s.toml:4:13",
     "'gives(*)' stands for the kinds with a table [gives.KIND], and the algebra has no such table; write one in the "
     "algebra, as [gives.point] with a line for each thing that is read back",
     "gives(*)", "", "'gives(*)'"},
    {"", "", "s.toml:4:17",
     "'*' stands for kinds in 'gives(*)' and in formulas, and not in 'exp(*)'; name the kind, as in 'exp(point)'", "*",
     "", "'exp(*)'"},
    {"", "", "s.toml:4:13", "the blade of 'sphere' has n and nb, which are not orthogonal", "log(sphere)", "",
     "'log(sphere)'"},
    {"[functions]", "[gives.ball]\nr = '1'\n[functions]", "a.toml:30:8",
     "no kind 'ball'; kinds: point, sphere, segment", "ball", ""},
    {"[functions]", "[gives.sphere]\nexists = '1'\n[functions]", "a.toml:31:1", "'exists' is a member of everything",
     "exists", ""},
    {"[functions]", "[gives.sphere]\npoint = '1'\n[functions]", "a.toml:31:1", "'point' would hide what is declared",
     "point", ""},
    {"[functions]", "[gives.sphere]\nr = 'sphere[x]'\n[functions]", "a.toml:31:13", "unknown name 'x'", "x", ""},
    {"[functions]", "[gives.sphere]\nr = 'exp(sphere)'\n[functions]", "a.toml:31:6", "'exp' is no polynomial",
     "exp(sphere)", ""},
    {"[functions]", "[gives.sphere]\nr = 'sqrt(sphere)'\n[functions]", "a.toml:31:11",
     "a multivector where a number is needed", "sphere", "", "'gives(sphere)'"},
    {"[functions]", "[gives.sphere]\nr = 'I*sphere'\n[functions]", "a.toml:30:8",
     "[gives.sphere] has no entry that is a number or an element of a kind", "sphere", "", "'gives(sphere)'"},
    {"[functions]", "[gives.sphere]\nr = '1/sphere'\n[functions]", "a.toml:31:8",
     "nothing says that V = 'sphere' has an inverse", "sphere", "", "'gives(sphere)'"},
};

constexpr const char *planes = R"([algebra]
vectors = ['e1', 'e2', 'e3', 'e0', 'm']
squares = [1, 1, 1, 0, -1]

[constants]
axes = '[e1, e2, e3]'

[kinds.point]
store    = ['x: real', 'y: real', 'z: real']
position = true
blade    = 'x*e1 + y*e2 + z*e3 + e0'

[kinds.motor]
store = ['s: real', 'a: real', 'b: real', 'c: real', 'd: real', 'e: real', 'f: real', 'p: real']
blade = 's + a*e23 + b*e31 + c*e12 + d*e01 + e*e02 + f*e03 + p*e1230'

[kinds.rotor]
store = ['s: real', 'a: real', 'b: real', 'c: real']
blade = 's + a*e23 + b*e31 + c*e12'

[kinds.line]
store = ['a: real', 'b: real', 'c: real']
blade = 'a*e23 + b*e31 + c*e03'

[kinds.boost]
store = ['s: real', 'a: real']
blade = 's + a*(e1^m)'
)";

std::string refused(const temporary_folder &folder, const std::string &kernel) {
  folder.write("s.toml", fmt::format("[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = ['{}']\n", kernel));
  const outcome o = run_meetc("generate s.toml -o out", folder.path());
  CHECK(o.code == 2);
  return o.err;
}
} // namespace

TEST_CASE("a function that is no polynomial stands alone, and a reading is checked as all else is") {
  check_broken(rows);
}

TEST_CASE("functions of motions refuse what is none, by name") {
  const temporary_folder folder;
  folder.write("a.toml", planes);
  CHECK_THAT(refused(folder, "exp(point)"), contains("the blade of 'point' has a coefficient on e1, and is no versor"));
  CHECK_THAT(refused(folder, "exp(rotor)"),
             contains("it takes bivectors, and the blade of 'rotor' has a coefficient on 1"));
  CHECK_THAT(refused(folder, "log(line)"), contains("and the blade of 'line' has no scalar"));
  CHECK_THAT(refused(folder, "sqrt(boost)"), contains("the blade of 'boost' has m, which squares to -1"));
  // Points that are vectors are not moved by a translation of this algebra.
  CHECK_THAT(refused(folder, "pose(motor)"), contains("V point ~V, which is not the moved point"));
  CHECK_THAT(refused(folder, "pose(*)"), contains("not in 'pose(*)'; name the kind, as in 'pose(point)'"));
}

TEST_CASE("the backend glsl carries no roots, and a declared function hides what is none of the algebra's") {
  const temporary_folder folder;
  folder.write("a.toml", std::string(planes) + "[functions]\n'norm(A)' = 'rnorm2(A)'\n");
  folder.write("s.toml", "[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nbackends = ['cpp', 'c']\nrungs = ['fp64']\n"
                         "kernels = ['norm(motor)']\n");
  CHECK(run_meetc("generate s.toml -o out", folder.path()).code == 0);
  CHECK_THAT(read(folder.path() / "out" / "x" / "norm_motor.hpp"), contains("multiplications"));
  folder.write("s.toml", "[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nbackends = ['glsl']\nrungs = ['fp32']\n"
                         "kernels = ['exp(line)']\n");
  CHECK_THAT(run_meetc("generate s.toml -o out", folder.path()).err,
             contains("s.toml:6:13: error: the backend 'glsl' carries no functions but polynomials"));
  CHECK_THAT(run_meetc("show s.toml", folder.path()).out, contains("exp(line)"));
  CHECK_THAT(run_meetc("show s.toml 'exp(line)'", folder.path()).out, contains("meetc::motions::exp<T>"));
  CHECK(run_meetc("show s.toml 'exp(line)' --emit=poly", folder.path()).code == 2);
}

TEST_CASE("the table of functions that are no polynomials in docs/spec.md is that of the compiler") {
  std::string table;
  for (const lang::analytic &f : lang::analytics())
    table += fmt::format("| {} | {} |\n", f.form, f.value);
  CHECK_THAT(read(source_folder() / "docs" / "spec.md"), contains("| kernel | value |\n|---|---|\n" + table + "\n"));
}

TEST_CASE("gives(*) stands for every kind with a table, and for no other") {
  const temporary_folder folder;
  const auto asked = [&](const std::string &algebra, const char *more) {
    folder.write("s.toml", fmt::format("[scene]\nalgebra = '{}'\nnamespace = 'k'\nkernels = ['gives(*)']\n{}",
                                       (source_folder() / "algebra_spec" / algebra).string(), more));
    compilation c = load((folder.path() / "s.toml").string());
    compile_all(c);
    std::vector<std::string> out;
    for (const lower::analytic_kernel &k : c.analytic)
      out.push_back(k.text);
    return out;
  };
  CHECK(asked("cga3_gives.toml", "") == std::vector<std::string>{"gives(point)", "gives(sphere)", "gives(plane)",
                                                                 "gives(line)", "gives(circle)", "gives(point_pair)",
                                                                 "gives(flat_point)"});
  CHECK(asked("cga3_gives.toml", "kinds = ['line', 'segment', 'sphere']\n") ==
        std::vector<std::string>{"gives(sphere)", "gives(line)"});
  const outcome o = run_meetc("show s.toml", folder.path());
  CHECK_THAT(o.out, contains("gives(line)") && contains("no polynomial") && !contains("*"));
  CHECK(run_meetc("generate s.toml -o out", folder.path()).code == 0);
  CHECK_THAT(read(folder.path() / "out" / "k" / "gives_line.hpp"), contains("struct line_given"));
  // None of the scene's kinds has one.
  folder.write("s.toml", "[scene]\nalgebra = 'cga3_gives.toml'\nnamespace = 'k'\nkernels = ['gives(*)']\n"
                         "kinds = ['segment']\n");
  const outcome none = run_meetc("show s.toml", folder.path());
  CHECK(none.code == 2);
  CHECK_THAT(none.err,
             contains("s.toml:4:13: error: 'gives(*)' stands for the kinds with a table [gives.KIND], and none "
                      "of the scene's kinds has one, only point, sphere,"));
}
