// meetc eval: exact values; meetc show without a kernel: the list of them; meetc new: a first project.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc::compiler_test;

namespace {

struct evaluated {
  const char *expression, *with, *want;
};

// By hand, in the conventions of the shipped algebra of space.
const evaluated values[] = {
    // The squared norm of two spheres' meet is -4 (d^2 - (r+s)^2)(d^2 - (r-s)^2): d = 2, r = 1, s = 1/2 give -4 (7/4)(15/4).
    {"norm2(meet(S, T))", "S: sphere = 0,0,0,1; T: sphere = 2,0,0,1/2", "-105/4 = -26.25\n"},
    {"norm2(meet(S, T))", "S: sphere = 0,0,0,1; T: sphere = 2,0,0,1", "0\n"},
    {"p", "p: point = 1,2,-0.5",
     "e1               2\ne2               4\ne3               -1\nn                21/4 = "
     "5.25\nnb               -1\n"},
    {"e31", "", "e1^e3            -1\n"},
    {"1/3", "", "1/3 = 0.3333333333333333\n"},
    {"e1*e1 - 1", "", "0\n"},
    {"sign(S.r - 3)", "S: sphere = 0,0,0,1", "-1\n"},
    {"S.r == 1", "S: sphere = 0,0,0,1", "true\n"},
    {"ball_ball(S, T)", "S: sphere = 0,0,0,1; T: sphere = 2,0,0,1;", "true\n"},
    {"ball_ball(S, T)", "S: sphere = 0,0,0,1; T: sphere = 2,0,0,999999999999999999999999/1000000000000000000000000",
     "false\n"},
    {"meet(S, L)", "S: sphere = 0,0,0,1; L: line = 1,2,3,1,2,3", "0\n"},
    {"S.r*10", "S: sphere = 0,0,0,1e-1", "1\n"},
    {"S.r", "S: sphere = +1.50,-2E+2, 7 ,12e-2", "3/25 = 0.12\n"},
    {"S.c.y", "S: sphere = +1.50,-2E+2, 7 ,12e-2", "-200\n"},
};

const struct {
  const char *arguments, *message;
} refused[] = {
    {"-e 'S' --with 'S: sphere = 0,0,0'", "a sphere stores 4 numbers (c.x, c.y, c.z, r), not 3"},
    {"-e 'S' --with 'S: sphere = 0,0,0,-1'", "this is no valid sphere: r >= 0"},
    {"-e 'P' --with 'P: point_pair = 1,2,3,1,2,3'", "this is no valid point_pair: p != q"},
    {"-e 'S' --with 'S: sphere'", "expected 'name: kind = numbers', and ';' between operands"},
    {"-e 'S' --with 'S = 1,2,3,4'", "expected 'name: kind'"},
    {"-e 'S' --with 'S: spere = 1,2,3,4'", "no kind 'spere'"},
    {"-e 'S' --with 'S: sphere = 1,2,x,4'", "'x' is not a number, such as 12, -0.5, 1e-3 or 2/3"},
    {"-e 'S' --with 'S: sphere = 1,2,1/0,4'", "'1/0' is not a number"},
    {"-e 'S' --with 'S: sphere = 1,2,,4'", "'' is not a number"},
    {"-e 'S' --with 'S: sphere = 1,2,1e99999,4'", "'1e99999' is not a number"},
    {"-e 'S' --with 'S: sphere = 1,2,nan,4'", "'nan' is not a number"},
    {"-e 'S' --with 'n: sphere = 1,2,3,4'", "'n' is taken"},
    {"-e 'S' --with 'S: sphere = 1,2,3,4; S: sphere = 1,2,3,4'", "'S' is taken"},
    {"-e 'T' --with 'S: sphere = 1,2,3,4'", "-e:1:1: error: unknown name 'T'"},
    {"-e '[S]' --with 'S: sphere = 1,2,3,4'", "-e:1:1: error: a list where a number or a multivector is needed"},
    {"-e 'S/(S.r - 4)' --with 'S: sphere = 1,2,3,4'", "'(S.r - 4)' has no inverse"},
    {"-e 'S +' --with 'S: sphere = 1,2,3,4'", "-e:1:3: error: expected a value"},
    {"", "--expression is required"},
};

} // namespace

TEST_CASE("eval prints exact values") {
  const temporary_folder folder;
  for (const auto &[expression, with, want] : values) {
    const outcome o = run_meetc(
        fmt::format("eval '{}' -e '{}' --with '{}'", default_scene_path().string(), expression, with), folder.path());
    INFO(expression << " with " << with << ": " << o.err);
    CHECK(o.code == 0);
    CHECK(o.out == want);
  }
}

TEST_CASE("eval takes 0 for any grade of a function's domain, and no other argument") {
  const temporary_folder folder;
  folder.write("a.toml", "[algebra]\nvectors = ['e1', 'e2', 'e3']\nsquares = [1, 1, 1]\n[kinds.arrow]\ngrades = [1]\n"
                         "[functions]\n'f(X, Y)' = {is = 'X ^ Y + e12', where = 'grade(Y) == 2'}\n"
                         "'g(X, Y)' = {is = 'X ^ Y + e12', where = 'grade(X) + grade(Y) == 3'}\n");
  folder.write("s.toml", "[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nkernels = ['norm2(arrow)']\n");
  const auto of = [&](const char *call) {
    return run_meetc(fmt::format("eval s.toml -e '{}' --with 'A: arrow = 0,0,0; B: arrow = 1,2,3'", call),
                     folder.path());
  };
  CHECK(of("f(B, A)").out == "e1^e2            1\n");
  CHECK(of("g(A, B)").out == "e1^e2            1\n");
  for (const char *const call : {"f(A, B)", "f(B, B)", "g(B, B)"})
    CHECK_THAT(of(call).err, contains("is not defined here"));
}

TEST_CASE("eval refuses what is no operand or no value, in one line") {
  const temporary_folder folder;
  for (const auto &[arguments, message] : refused) {
    const outcome o = run_meetc(fmt::format("eval '{}' {}", default_scene_path().string(), arguments), folder.path());
    INFO(arguments << ": " << o.err);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK_THAT(o.err, contains(message));
  }
}

TEST_CASE("show without a kernel lists the kernels of a scene") {
  const temporary_folder folder;
  folder.write("a.toml", small_algebra);
  folder.write("s.toml", small_scene("'touch', 'norm2(meet(sphere, *))'"));
  const outcome o = run_meetc("show s.toml", folder.path());
  CHECK(o.code == 0);
  CHECK(o.out == "touch                                            S: sphere, T: sphere\n"
                 "norm2(meet(sphere, point))                       X: sphere, Y: point\n"
                 "norm2(meet(sphere, sphere))                      X: sphere, Y: sphere\n");
}

TEST_CASE("new writes a project whose scene is verified, and nothing where something is") {
  const temporary_folder folder;
  const outcome o = run_meetc("new made/first", folder.path());
  CHECK(o.code == 0);
  CHECK_THAT(o.out, contains("meetc verify made/first/scene.toml"));
  const outcome verified = run_meetc("verify made/first/scene.toml", folder.path());
  CHECK(verified.code == 0);
  CHECK_THAT(verified.out, contains("0 wrong of") && contains("in 4 kernels"));
  // The line that the command proposes: the line through both points.
  const outcome joined =
      run_meetc("eval made/first/scene.toml -e 'A & B' --with 'A: point = 1,2,0; B: point = 1,2,5'", folder.path());
  CHECK(joined.out == "e0^e1            10\ne0^e2            -5\ne1^e2            5\n");
  const std::string before = read(folder.path() / "made/first/scene.toml");
  const outcome again = run_meetc("new made/first", folder.path());
  CHECK(again.code == 2);
  CHECK(again.err == "error: made/first: is there already, and not an empty folder\n");
  CHECK(read(folder.path() / "made/first/scene.toml") == before);
  folder.write("file", "");
  CHECK(run_meetc("new file", folder.path()).code == 2);
  CHECK(run_meetc("new file/inside", folder.path()).code == 2);
  fs::create_directory(folder.path() / "empty");
  CHECK(run_meetc("new empty", folder.path()).code == 0);
}
