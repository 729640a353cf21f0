// The programs of products of multivectors with nothing assumed: exact counts, the polynomials, and the dense product.
#include "gen/ir/residue.hpp"
#include "gen/verify/verify.hpp"
#include "tests/gen/lower/versors.hpp"

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

struct row {
  const char *kernel;
  ops have, limit; // the exact count, and what is never to be exceeded
};

void check(const char *algebra, const std::vector<row> &rows) {
  std::string kernels;
  for (const row &r : rows)
    kernels += fmt::format("'{}', ", r.kernel);
  const temporary_folder folder;
  const compilation c = compiled(folder, algebra, kernels);
  REQUIRE(c.kernels.size() == rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    INFO(rows[i].kernel);
    const lower::formula &f = c.kernels[i].value;
    CHECK(all(f.from_blades) == rows[i].have);
    CHECK(rows[i].have.multiplications <= rows[i].limit.multiplications);
    CHECK(rows[i].have.additions <= rows[i].limit.additions);
    REQUIRE(f.is_expanded());
    CHECK(ir::to_poly(f.from_blades, *f.numbers) == f.polynomials);
    const verify::report r = verify::verify_formula(*c.model, c.kernels[i], 30, 11);
    CHECK(r.wrong == 0);
    CHECK(r.cases >= 30);
  }
}

} // namespace

TEST_CASE("V X ~V of any rotor or motor: the commutator's form, however the reverse is written") {
  check(planes_as_vectors, {{"sandwich(rotor, direction)", {22, 15}, {22, 15}},
                            {"sandwich(motor, point)", {30, 21}, {30, 21}},
                            {"by_hand(motor, point)", {30, 21}, {30, 21}},
                            {"back(motor, point)", {30, 21}, {30, 21}},
                            {"flipped(point, motor)", {30, 21}, {30, 21}},
                            {"sandwich(motor, plane)", {30, 21}, {30, 21}},
                            {"sandwich(motor, line)", {52, 45}, {62, 51}}});
}

TEST_CASE("V X ~V of any conformal versor: pairs of its numbers are changed, and kernels shared") {
  check(conformal, {{"moved(versor, round)", {89, 83}, {90, 83}}});
}

TEST_CASE("a formula costs no more than it was written with") {
  // gp: 48/40; the sandwich of a motor and a point: 30/21.
  check(planes_as_vectors, {{"gp(motor, motor)", {48, 40}, {48, 40}},
                            {"sandwich(gp(motor, motor), point)", {78, 61}, {78, 61}},
                            {"sandwich(motor, sandwich(motor, point))", {60, 42}, {60, 42}},
                            {"sandwich(gp(motor, motor), line)", {100, 85}, {100, 85}}});
}

TEST_CASE("a number from stored operands costs no more than from their blades") {
  const temporary_folder folder;
  const compilation c =
      compiled(folder, std::string(planes_as_vectors) + "'over(M, p, q)' = '(sandwich(M, p) ^ q)[I]'\n",
               "'over(motor, point, plane)', 'over(motor, direction, plane)'");
  for (const lower::kernel &k : c.kernels) {
    INFO(k.asked.text);
    const ops stored = all(k.value.from_stored), blades = all(k.value.from_blades);
    CHECK(stored.multiplications + stored.additions <= blades.multiplications + blades.additions);
    CHECK(verify::verify_formula(*c.model, k, 30, 3).wrong == 0);
  }
}

TEST_CASE("B squared by Gram and Lagrange in the algebra's own metric") {
  check(conformal, {{"gram(round, round)", {15, 11}, {15, 11}},
                    {"dots(round, round)", {15, 11}, {15, 11}},
                    {"gram(round, flat)", {13, 9}, {13, 9}},
                    {"gram(flat, flat)", {9, 5}, {11, 7}}});
}
