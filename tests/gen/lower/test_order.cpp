// The order of basis blades that an algebra states: names, signs and places of coefficients, with the same values.
#include "gen/lower/kernel/compile.hpp"
#include "gen/verify/verify.hpp"
#include "tests/gen/lower/versors.hpp"

#include <algorithm>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

using lower::rational;
using names = std::vector<std::string>;

// Those of klein, where a motor is (1, e23, e31, e12) and (e0123, e01, e02, e03); of ganja.js; and the last blades first.
const char *const klein = "['1', 'e23', 'e31', 'e12', 'e0123', 'e01', 'e02', 'e03']";
const char *const ganja = "['e01', 'e02', 'e03', 'e12', 'e31', 'e23', 'e021', 'e013', 'e032', 'e123']";
const char *const backward = "['e3', 'e0', 'e32', 'e10', 'e3^e1^e2', 'e321^e0']";

compilation ordered(const temporary_folder &folder, const std::string &order, const std::string &kernels) {
  folder.write("base.toml", planes_as_vectors);
  return compiled(
      folder, fmt::format("[algebra]\nextends = 'base.toml'\n{}\n", order.empty() ? "" : "order = " + order), kernels);
}

// A blade by its vectors in alphabetical order, and the sign of their permutation.
std::pair<names, int> sorted(names vectors) {
  int sign = 1;
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (std::size_t j = i + 1; j < vectors.size(); ++j)
      if (vectors[j] < vectors[i])
        std::swap(vectors[i], vectors[j]), sign = -sign;
  return {vectors, sign};
}

names texts(const std::vector<lower::basis_blade> &blades) {
  names out;
  for (const lower::basis_blade &b : blades)
    out.push_back(b.text());
  return out;
}

// The coefficients of a kernel's value on sorted blades, for operands with the coefficients `at`, by operand and sorted blade.
using coefficients = std::map<names, rational>;
coefficients evaluated(const compilation &c, const lower::kernel &k, const std::vector<coefficients> &at) {
  std::vector<rational> inputs;
  for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
    for (const lower::basis_blade &b : lower::named(c.model->working(), lower::support(*c.model, *k.asked.kinds[i]))) {
      const auto [blade, sign] = sorted(b.vectors);
      inputs.push_back(at[i].at(blade) * sign);
    }
  const std::vector<rational> values = ir::evaluate(k.value.from_blades, inputs);
  coefficients out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [blade, sign] = sorted(k.value.result_names[i].vectors);
    out[blade] = values[i] * sign;
  }
  return out;
}

// Different numbers on every blade of four vectors.
coefficients numbers(int from) {
  coefficients out;
  for (int mask = 0; mask < 16; ++mask) {
    names blade;
    for (int i = 0; i < 4; ++i)
      if (mask >> i & 1)
        blade.push_back(fmt::format("e{}", i));
    out[blade] = rational(from + 7 * mask - mask * mask, 1 + mask % 3);
    out[blade].canonicalize();
  }
  return out;
}

const char *const products =
    "'gp(motor, motor)', 'sandwich(motor, point)', 'gp(plane, point)', 'rc(motor)', 'dual(plane)', "
    "'line & point', 'undual(plane)', 'project(point, line)'";

} // namespace

TEST_CASE("motors in the order of another library have equal values") {
  const temporary_folder plain_folder;
  const compilation plain = ordered(plain_folder, "", products);
  for (const char *order : {klein, ganja, backward}) {
    const temporary_folder folder;
    const compilation c = ordered(folder, order, products);
    REQUIRE(c.kernels.size() == plain.kernels.size());
    for (std::size_t i = 0; i < c.kernels.size(); ++i) {
      INFO(order << ": " << c.kernels[i].asked.text);
      const std::vector<coefficients> at{numbers(3), numbers(-20)};
      CHECK(evaluated(c, c.kernels[i], at) == evaluated(plain, plain.kernels[i], at));
      CHECK(all(c.kernels[i].value.from_blades) == all(plain.kernels[i].value.from_blades)); // at equal cost
    }
    CHECK(run_meetc("verify s.toml --cases 100", folder.path()).code == 0);
  }
}

TEST_CASE("emitted blades follow the order, in every target") {
  const temporary_folder folder;
  const compilation c = ordered(folder, klein, "'gp(motor, motor)'");
  const lower::kernel &k = c.kernels[0];
  const names want{"1", "e2^e3", "e3^e1", "e1^e2", "e0^e1^e2^e3", "e0^e1", "e0^e2", "e0^e3"};
  CHECK(texts(k.value.result_names) == want);
  CHECK(texts(lower::named(c.model->working(), lower::support(*c.model, *k.asked.kinds[0]))) == want);
  for (const char *target : {"cpp", "c", "python", "glsl", "wgsl", "poly", "json", "schedule", "latex"}) {
    INFO(target);
    const std::string text = shown(c, k, target);
    const bool spells = std::string(target) == "latex";
    CHECK_THAT(text, contains(spells ? "e_{3}" : "e3") && !contains("e1_e3") && !contains("e1^e3"));
    CHECK((spells || text.find("e3_e1") != std::string::npos || text.find("e3^e1") != std::string::npos));
  }
  REQUIRE(run_meetc("generate s.toml -o out", folder.path()).code == 0);
  for (const char *file : {"kinds.hpp", "k.h"})
    CHECK_THAT(read(folder.path() / "out" / "k" / file),
               contains("scalar, e2_e3, e3_e1, e1_e2, e0_e1_e2_e3, e0_e1, e0_e2, e0_e3;"));
  const outcome o = run_meetc("eval s.toml -e 'M' --with 'M: motor = 1,2,3,4,5,6,7,8'", folder.path());
  CHECK(o.out == "1                1\ne2^e3            2\ne3^e1            3\ne1^e2            4\n"
                 "e0^e1^e2^e3      8\ne0^e1            5\ne0^e2            6\ne0^e3            7\n");
}

TEST_CASE("expressions mean the same in every order") {
  const temporary_folder plain_folder, folder;
  ordered(plain_folder, "", "'gp(motor, motor)'");
  ordered(folder, backward, "'gp(motor, motor)'");
  for (const char *e : {"rc(M)[e1^e2]", "lc(P)[e0]", "dual(Q)[e1^e3]", "undual(Q)[e3^e2]", "I[e0^e1^e2^e3]", "M[e31]",
                        "(M & P)[e1]", "(M^Q)[e0^e1^e3]", "(M|P)[1]", "rnorm2(M)", "sandwich(M, P)[e0^e2^e3]"}) {
    const std::string arguments = fmt::format(
        "eval s.toml -e '{}' --with 'M: motor = 1,2,3,4,5,6,7,8; P: point = 1,-2,3; Q: plane = 2,3,5,7'", e);
    INFO(e);
    const outcome want = run_meetc(arguments, plain_folder.path());
    CHECK(want.code == 0);
    CHECK(run_meetc(arguments, folder.path()).out == want.out);
  }
}

TEST_CASE("verify judges names and signs in the order") {
  const temporary_folder folder;
  compilation c = ordered(folder, ganja, "'gp(motor, motor)'");
  lower::kernel k = c.kernels[0];
  CHECK(verify::verify_formula(*c.model, k, 20, 1).wrong == 0);
  auto &blade = k.value.result_names[5].vectors;
  REQUIRE(blade == names{"e3", "e1"});
  std::swap(blade[0], blade[1]);
  CHECK(verify::verify_formula(*c.model, k, 20, 1).wrong > 0);
  std::swap(blade[0], blade[1]);
  std::swap(k.value.result_names[1], k.value.result_names[2]);
  CHECK(verify::verify_formula(*c.model, k, 20, 1).wrong > 0);
}

TEST_CASE("numbers of dual quaternions follow the order") {
  const temporary_folder plain_folder, folder;
  const char *const kernels = "'exp(line)', 'log(motor)', 'pose(motor)'";
  const compilation plain = ordered(plain_folder, "", kernels), c = ordered(folder, backward, kernels);
  REQUIRE(c.analytic.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(c.analytic[i].shift == plain.analytic[i].shift);
    for (const auto of : {&lower::analytic_kernel::in, &lower::analytic_kernel::out})
      for (std::size_t n = 0; n < 8; ++n) {
        const lower::dual_number &mine = (c.analytic[i].*of)[n], &want = (plain.analytic[i].*of)[n];
        REQUIRE(mine.at.has_value() == want.at.has_value());
        if (!mine.at)
          continue;
        const auto [a, sign_a] = sorted(mine.at->vectors);
        const auto [b, sign_b] = sorted(want.at->vectors);
        CHECK(a == b);
        CHECK(mine.sign * sign_a == want.sign * sign_b);
      }
  }
}

TEST_CASE("an order of null vectors, of kinds by grades, and of an algebra that extends one with an order") {
  const temporary_folder folder;
  const std::string cga3 = (source_folder() / "algebra_spec" / "cga3.toml").string();
  folder.write("a.toml", "[algebra]\nextends = '" + cga3 +
                             "'\norder = ['n', 'e3', 'e31', 'n^e1', 'nb^n']\n"
                             "[kinds.even]\ngrades = [0, 2]\n[functions]\n'gp(A, B)' = 'A * B'\n");
  folder.write("b.toml", "[algebra]\nextends = 'a.toml'\norder = ['e31']\n");
  folder.write("s.toml", "[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nkernels = ['meet(circle, sphere)', "
                         "'norm2(meet(sphere, sphere))', 'gp(even, point)', 'gp(even, even)', 'ball_ball']\n");
  folder.write("t.toml", "[scene]\nalgebra = 'b.toml'\nnamespace = 'k'\nkernels = ['gp(point, direction)']\n");
  CHECK(run_meetc("verify s.toml --cases 100", folder.path()).code == 0);
  CHECK(run_meetc("verify t.toml --cases 100", folder.path()).code == 0);
  compilation a = load((folder.path() / "s.toml").string()), b = load((folder.path() / "t.toml").string());
  names stored;
  for (const lang::field &f : a.scene->in.find_kind("even")->store)
    stored.push_back(f.name);
  CHECK(stored == names{"c_1", "c_e1_e2", "c_e3_e1", "c_e1_e", "c_e1_eb", "c_e2_e3", "c_e2_e", "c_e2_eb", "c_e3_e",
                        "c_e3_eb", "c_e_eb"});
  compile_all(a);
  CHECK(texts(lower::named(a.model->working(), lower::support(*a.model, a.model->kind("point", {})))) ==
        names{"e1", "e2", "n", "e3", "nb"});
  compile_all(b);
  CHECK(texts(b.kernels[0].value.result_names) ==
        names{"1", "e1^e2", "e3^e1", "e1^n", "e1^nb", "e2^e3", "e2^n", "e2^nb", "e3^n", "e3^nb"});
}
