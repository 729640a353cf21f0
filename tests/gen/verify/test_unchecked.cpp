// meetc verify names what it could not compare, and meetc says what is zero.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

#include <fmt/format.h>

using namespace meetc::compiler_test;

namespace {

// The small algebra with its line of kernels, an added kind without hull, and a predicate of it.
outcome run(const temporary_folder &folder, const std::string &command, const std::string &algebra,
            const std::string &kernels, const std::string &more = "") {
  folder.write("a.toml", algebra);
  folder.write("s.toml", small_scene(kernels) + more);
  return run_meetc(command, folder.path());
}

std::string with_plane() {
  return edited(small_algebra, "[functions]\n",
                "[kinds.plane]\nstore = ['a: real', 'b: real', 'c: real', 'd: real']\n"
                "blade = 'I*(a*e1 + b*e2 + c*e3 + d*n)'\n[functions]\n") +
         "[predicates.above]\nof = ['S: sphere', 'P: plane']\nhit = 'sign(S.r - P.d) > 0'\n";
}

} // namespace

TEST_CASE("verify compares a predicate of an operand without a hull with what the spec says, and says that it does") {
  const temporary_folder folder;
  const outcome checked = run(folder, "verify s.toml", with_plane(), "'above', 'norm2(meet(sphere, sphere))'");
  INFO(checked.out << checked.err);
  CHECK(checked.code == 0);
  CHECK_THAT(checked.out, contains("above                                0 wrong of"));
  CHECK_THAT(checked.out, contains("norm2(meet(sphere, sphere))          0 wrong of"));
  CHECK_THAT(checked.out, !contains("not checked"));
  CHECK_THAT(checked.out, contains(" degenerate), by its text\n") &&
                              contains("no wrong question, since a kind has no hull: above\n"));
  CHECK_THAT(run(folder, "verify s.toml", with_plane(), "'touch'").out,
             !contains("by its text") && !contains("no hull"));
}

TEST_CASE("a counterexample names operands as eval takes them, and the equal points that the compiler trusts") {
  const temporary_folder folder;
  const std::string mistaken =
      edited(small_algebra, "[functions]\n",
             "[kinds.capsule]\nstore = ['p: point', 'q: point', 'r: real']\nhull = '[p, q]'\npad = 'r'\n"
             "parts.ends = '[p, q]'\nwhere = 'r >= 0'\nblade = 'p^q^n'\n[functions]\n") +
      "[predicates.endless]\nof = ['S: sphere', 'K: capsule']\nmode = 'solid'\n"
      "hit = 'sign(norm2(meet(sphere(S.c, S.r + K.r), K))) >= 0'\n";
  const outcome wrong = run(folder, "verify s.toml", mistaken, "'endless'");
  INFO(wrong.out << wrong.err);
  CHECK(wrong.code == 1);
  const std::size_t at = wrong.out.find("first: S: sphere = ");
  REQUIRE(at != std::string::npos);
  const std::size_t begin = at + 7, end = wrong.out.find(" is a hit by the predicate, and a miss by the hulls", begin);
  REQUIRE(end != std::string::npos);
  const std::string with = wrong.out.substr(begin, end - begin);
  CHECK(run_meetc("eval s.toml -e 'endless(S, K)' --with '" + with + "'", folder.path()).out == "true\n");
  CHECK_THAT(wrong.out, contains(" is a miss by the hulls, and a hit by the predicate, as all are where K.p = K.q\n"));
}

TEST_CASE("verify fails where it cannot compare a predicate, unless that is allowed") {
  const temporary_folder folder;
  const std::string algebra = edited(with_plane(), "'sign(S.r - P.d) > 0'", "'sign(S.r - P.d) > 0 and grade(P) == 4'");
  const outcome refused = run(folder, "verify s.toml", algebra, "'above'");
  CHECK(refused.code == 1);
  CHECK_THAT(refused.out, contains("not checked: above") && contains("--allow-unchecked"));
  const outcome allowed = run_meetc("verify s.toml --allow-unchecked", folder.path());
  CHECK(allowed.code == 0);
  CHECK_THAT(allowed.out, contains("not checked: above"));
}

TEST_CASE("verify names functions that are no polynomials, which it compares with nothing") {
  const temporary_folder folder;
  folder.write("a.toml",
               "[algebra]\nvectors = ['e1', 'e2', 'e3']\nsquares = [1, 1, 1]\n[kinds.rotor]\ngrades = [0, 2]\n"
               "[kinds.turn]\ngrades = [2]\n[functions]\n'gp(A, B)' = 'A * B'\n");
  folder.write("s.toml", "[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nkernels = ['gp(rotor, rotor)', 'exp(turn)']\n");
  const outcome refused = run_meetc("verify s.toml", folder.path());
  INFO(refused.out << refused.err);
  CHECK(refused.code == 1);
  CHECK_THAT(refused.out,
             contains("gp(rotor, rotor)                     0 wrong of") && contains("not checked: exp(turn)"));
  CHECK(run_meetc("verify s.toml --allow-unchecked", folder.path()).code == 0);
}

TEST_CASE("a coefficient along a vector of either basis is one number in show and in verify") {
  const temporary_folder folder;
  const std::string algebra =
      edited(small_algebra, "[functions]\n",
             "[functions]\n'along_n(M)' = 'M[n]'\n'along_e(M)' = 'M[e]'\n'along_e1n(M)' = 'M[e1^n]'\n"
             "'along_e1e(M)' = 'M[e1^e]'\n'along_I(M)' = 'M[I]'\n'square(M)' = 'M*M'\n");
  const std::string kernels = "'along_n(square(sphere))', 'along_e(square(sphere))', 'along_n(meet(sphere, sphere))', "
                              "'along_e1n(meet(sphere, sphere))', 'along_e1e(meet(sphere, sphere))', 'along_n(point)', "
                              "'along_e(point)'";
  const outcome verified = run(folder, "verify s.toml", algebra, kernels,
                               "zero = ['along_n(square(sphere))', 'along_e(square(sphere))', "
                               "'along_n(meet(sphere, sphere))']\n");
  INFO(verified.out << verified.err);
  CHECK(verified.code == 0);
  for (const char *kernel : {"along_e1n(meet(sphere, sphere))", "along_e1e(meet(sphere, sphere))", "along_n(point)"})
    for (const char *emit : {"poly", "json", "latex", "cpp"}) {
      const outcome shown = run_meetc(fmt::format("show s.toml '{}' --emit={}", kernel, emit), folder.path());
      INFO(kernel << " " << emit << ": " << shown.err);
      CHECK(shown.code == 0);
    }
  // A point is 2x + x^2 n - nb, so along n it is x^2.
  CHECK_THAT(run_meetc("show s.toml -e 'p[n]' --with 'p: point' --emit=poly", folder.path()).out, contains("p.n"));
}

TEST_CASE("a kernel that is zero for all operands is told, unless the scene says so") {
  const temporary_folder folder;
  const std::string algebra = edited(small_algebra, "[functions]\n", "[functions]\n'nothing(A)' = 'A - A'\n");
  const outcome told =
      run(folder, "generate s.toml -o out", algebra, "'nothing(sphere)', 'norm2(meet(sphere, sphere))'");
  CHECK(told.code == 0);
  CHECK_THAT(told.err,
             contains("s.toml:4:13: warning: 'nothing(sphere)' is zero for all operands") && contains("^~~~"));
  const outcome said =
      run(folder, "generate s.toml -o out", algebra, "'nothing(sphere)'", "zero = ['nothing(sphere)']\n");
  CHECK(said.code == 0);
  CHECK(said.err.empty());
  // From stored numbers a point is a null vector, and a constant is a number as a written one is.
  const outcome stored = run(folder, "generate s.toml -o out", small_algebra, "'norm2(point)'");
  CHECK_THAT(stored.err, contains("warning: 'norm2(point)' is zero for all operands"));
  const outcome constant =
      run(folder, "generate s.toml -o out",
          edited(edited(algebra, "'A - A'", "'A^two'"), "[constants]\n", "[constants]\ntwo = '1 + 1'\n"),
          "'nothing(sphere)'");
  CHECK(constant.code == 2);
  CHECK_THAT(constant.err, contains("'^' is the outer product, which a number only scales: write A*A for a square"));
  const outcome other =
      run(folder, "generate s.toml -o out", algebra, "'nothing(sphere)'", "zero = ['nothing(spere)']\n");
  CHECK(other.code == 2);
  CHECK_THAT(other.err, contains("scene.zero lists 'nothing(spere)', which scene.kernels does not; did you mean"));
  const outcome not_zero = run(folder, "generate s.toml -o out", algebra, "'norm2(meet(sphere, sphere))'",
                               "zero = ['norm2(meet(sphere, sphere))']\n");
  CHECK(not_zero.code == 2);
  CHECK_THAT(not_zero.err, contains("which is not zero"));
}
