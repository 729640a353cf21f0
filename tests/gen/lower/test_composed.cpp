// Formulas whose expansion is long are composed of their parts, and every coefficient of a formula is an output.
#include "gen/ir/residue.hpp"
#include "gen/verify/verify.hpp"
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <fmt/format.h>
#include <gmpxx.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

// Planes as vectors of R(3,0,1), with motors and lines by their coefficients, and the reverse by hand.
const char *const motors = R"([algebra]
vectors = ['e0', 'e1', 'e2', 'e3']
squares = [0, 1, 1, 1]
[constants]
I = 'e0 ^ e1 ^ e2 ^ e3'
[kinds.line]
store = ['a: real', 'b: real', 'c: real', 'd: real', 'e: real', 'f: real']
blade = 'a*(e2^e3) + b*(e3^e1) + c*(e1^e2) + d*(e0^e1) + e*(e0^e2) + f*(e0^e3)'
[kinds.motor]
store = ['s: real', 'a: real', 'b: real', 'c: real', 'd: real', 'e: real', 'f: real', 'p: real']
blade = 's + a*(e2^e3) + b*(e3^e1) + c*(e1^e2) + d*(e0^e1) + e*(e0^e2) + f*(e0^e3) + p*I'
[functions]
'gp(A, B)'       = 'A * B'
'norm2(B)'       = '(B*B)[1]'
'rev(M)'         = '2*(M[1] + M[I]*I) - M'
'sandwich(M, X)' = 'M * X * rev(M)'
'twice(M, X)'    = 'sandwich(M, sandwich(M, X))'
'moved(M, X)'    = 'twice(gp(M, M), twice(gp(M, gp(M, M)), X))'
'deep(M, X)'     = 'moved(M, moved(M, X))'
)";

compilation compiled(const temporary_folder &folder, const std::string &kernels) {
  folder.write("a.toml", motors);
  folder.write(
      "s.toml",
      fmt::format("[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nbackends = ['cpp', 'c']\nkernels = [{}]\n", kernels));
  compilation c = load((folder.path() / "s.toml").string());
  compile_all(c);
  return c;
}

// The formula's values at these inputs.
std::vector<ir::rational> at(const lower::kernel &k, const std::vector<int> &inputs) {
  return ir::evaluate(k.value.from_blades, {inputs.begin(), inputs.end()});
}

} // namespace

TEST_CASE("a formula with coefficients of hundreds of terms has a body, whatever its form") {
  const temporary_folder folder;
  const compilation c =
      compiled(folder, "'sandwich(gp(motor, motor), line)', 'gp(sandwich(motor, motor), sandwich(motor, motor))', "
                       "'norm2(sandwich(gp(motor, motor), line))', 'sandwich(motor, gp(motor, motor))'");
  for (const lower::kernel &k : c.kernels) {
    INFO(k.asked.text);
    CHECK(k.value.from_blades.results.size() == k.value.result.size());
    CHECK(k.value.is_expanded());
    CHECK(ir::same_values(k.value.from_blades, k.value.polynomials, *k.value.numbers));
    const verify::report r = verify::verify_formula(*c.model, k, 30, 7);
    CHECK(r.wrong == 0);
    CHECK(r.cases >= 30);
  }
  // The unit motor moves nothing. Line: e01 e02 e03 e12 e13 e23.
  const lower::kernel &moved = c.kernels[0];
  REQUIRE(moved.value.result.size() == 6);
  std::vector<int> inputs{1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 4, 5, 6, 3, -2, 1};
  CHECK(at(moved, inputs) == std::vector<ir::rational>{4, 5, 6, 3, -2, 1});
  const ir::counts n = ir::count(moved.value.from_blades.nodes, moved.value.from_blades.results);
  CHECK(n.multiplications + n.fused == 100);
  CHECK(n.additions + n.fused == 85);
}

TEST_CASE("a formula that is too long to expand has the values of its expression") {
  const temporary_folder folder;
  const compilation c = compiled(folder, "'deep(motor, line)', 'norm2(deep(motor, line))'");
  for (const lower::kernel &k : c.kernels) {
    INFO(k.asked.text);
    CHECK_FALSE(k.value.is_expanded());
    CHECK(verify::verify_formula(*c.model, k, 30, 7).wrong == 0);
    CHECK(ir::count(k.value.from_blades.nodes, k.value.from_blades.results).total() < 2000);
  }
  CHECK(c.kernels[0].value.result.size() == 6);
  CHECK(c.kernels[1].value.is_number());
  for (const char *emit : {"poly", "json", "latex"}) {
    const outcome o = run_meetc(fmt::format("show s.toml 'deep(motor, line)' --emit={}", emit), folder.path());
    CHECK(o.code == 2);
    CHECK_THAT(o.err, contains(fmt::format("the polynomials of 'deep(motor, line)' are too long for --emit={}", emit)));
  }
  CHECK_THAT(run_meetc("show s.toml 'deep(motor, line)' --emit=cpp", folder.path()).out,
             contains("too long to be expanded") && contains("B.e0_e1 = ") && contains("B.e2_e3 = "));
}

TEST_CASE("a result that is not assigned is seen by verify") {
  const temporary_folder folder;
  const compilation c = compiled(folder, "'gp(motor, motor)'");
  lower::kernel lacking = c.kernels[0];
  lacking.value.from_blades.results.pop_back();
  CHECK(verify::verify_formula(*c.model, lacking, 5, 1).wrong == 1);
  lower::kernel empty = c.kernels[0];
  empty.value.from_blades.results.clear();
  CHECK(verify::verify_formula(*c.model, empty, 5, 1).wrong == 1);
  lower::kernel negative = c.kernels[0];
  negative.value.from_blades.results[3] =
      negative.value.from_blades.nodes.negate(negative.value.from_blades.results[3]);
  CHECK(verify::verify_formula(*c.model, negative, 5, 1).wrong == 1);
}

TEST_CASE("residues: two primes, and values that tell programs apart") {
  for (const std::uint64_t p : ir::residue_primes) {
    const mpz_class prime(std::to_string(p));
    CHECK(mpz_probab_prime_p(prime.get_mpz_t(), 50) != 0);
    CHECK(mpz_sizeinbase(prime.get_mpz_t(), 2) == 61);
    CHECK(ir::residue(ir::rational(-1, 3), p) == ir::residue(ir::rational(2, 3), p) - 1 + (p - p));
    CHECK(ir::residue(ir::rational(-1), p) == p - 1);
  }
  const poly::ring ring({"x", "y"});
  ir::arena nodes({ir::residency::a, ir::residency::b});
  const ir::node_id x = nodes.input(0), y = nodes.input(1);
  const ir::node_id square = nodes.multiply(nodes.add(x, y), nodes.add(x, y));
  const ir::node_id expanded = nodes.add(
      nodes.multiply(x, x), nodes.add(nodes.multiply(nodes.constant(2), nodes.multiply(x, y)), nodes.multiply(y, y)));
  const ir::node_id wrong = nodes.add(
      nodes.multiply(x, x), nodes.add(nodes.multiply(nodes.constant(3), nodes.multiply(x, y)), nodes.multiply(y, y)));
  const auto residues = ir::residues(ir::program{nodes, {square, expanded, wrong}});
  CHECK(residues[0] == residues[1]);
  CHECK(residues[0] != residues[2]);
  CHECK(residues[0].size() == 2 * ir::residue_points);
  CHECK(residues[0] == ir::residues(ir::to_poly({nodes, {square}}, ring)[0]));
  CHECK(ir::same_values({nodes, {square}}, {nodes, {expanded}}, ring));
  CHECK_FALSE(ir::same_values({nodes, {square}}, {nodes, {wrong}}, ring));
  CHECK_FALSE(ir::same_values({nodes, {square}}, {nodes, {square, square}}, ring));
}
