// Relations that kinds state: cheaper programs of values, with a certificate; checked on samples; never in a sign.
#include "gen/ir/evaluate.hpp"
#include "gen/ir/residue.hpp"
#include "gen/lower/expand/decision.hpp"
#include "gen/verify/verify.hpp"
#include "tests/gen/lower/versors.hpp"

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

struct row {
  const char *kernel;
  ops have;           // of the whole
  ops versor, object; // prepared: for a versor, and for each object
};

void check(const compilation &c, const std::vector<row> &rows) {
  REQUIRE(c.kernels.size() == rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    INFO(rows[i].kernel);
    const lower::formula &f = c.kernels[i].value;
    CHECK(all(f.from_blades) == rows[i].have);
    CHECK(plain(ir::count_object(f.prepared, poly::residency::a)) == rows[i].versor);
    CHECK(plain(ir::count_pair(f.prepared)) == rows[i].object);
    REQUIRE(f.is_expanded());
    for (const auto &[code, assumed] :
         {std::pair(&f.from_blades, &f.assumed), std::pair(&f.prepared, &f.prepared_assumed)})
      CHECK(ir::to_poly(*code, *f.numbers) == (assumed->taken.empty() ? f.polynomials : assumed->computed));
    const verify::report r = verify::verify_formula(*c.model, c.kernels[i], 40, 5);
    CHECK(r.wrong == 0);
    CHECK(r.cases >= 40);
  }
}

std::string listed(const std::vector<row> &rows) {
  std::string out;
  for (const row &r : rows)
    out += fmt::format("'{}', ", r.kernel);
  return out;
}

} // namespace

TEST_CASE("unit rotors and motors: the best known programs, whole and prepared") {
  const std::vector<row> rows{{"sandwich(rotor, direction)", {15, 12}, {10, 10}, {9, 6}},
                              {"sandwich(motor, point)", {22, 18}, {22, 19}, {12, 9}},
                              {"sandwich(motor, plane)", {22, 18}, {22, 19}, {12, 9}},
                              {"sandwich(motor, line)", {45, 39}, {24, 26}, {27, 21}}};
  const temporary_folder folder;
  const compilation c = compiled(folder, with_unit_motors(planes_as_vectors), listed(rows));
  check(c, rows);
  for (const lower::kernel &k : c.kernels) {
    REQUIRE(k.value.assumed.taken.size() == 1);
    CHECK(k.value.assumed.taken[0].operand == "X");
    CHECK(k.value.assumed.taken[0].nearly);
    CHECK(k.value.assumed.taken[0].within == 1e-6);
  }
}

TEST_CASE("a point of weight 1: a relation that holds identically") {
  const std::vector<row> rows{{"sandwich(motor, point)", {18, 18}, {22, 19}, {9, 9}}};
  const temporary_folder folder;
  const std::string algebra =
      with(with_unit_motors(planes_as_vectors), "point", "relations.is = ['point[e1^e2^e3] = 1']\n");
  const compilation c = compiled(folder, algebra, listed(rows));
  check(c, rows);
  const std::string text = shown(c, c.kernels[0], "cpp");
  CHECK_THAT(text,
             contains("Takes point[e1^e2^e3] = 1 of Y for granted, which holds identically in its stored numbers.") &&
                 contains("Takes motor * rev(motor) = 1 of X for granted, within 1e-06 in each coefficient.") &&
                 contains("B.e1_e2_e3 differs from the formula's value by at most 1e-06 times the sizes of: 1") &&
                 contains("struct sandwich_motor_point"));
  CHECK_THAT(shown(c, c.kernels[0], "c"), contains("/* Takes motor * rev(motor) = 1 of X for granted, within 1e-06"));
}

TEST_CASE("a unit conformal versor, whose relations stand in both orders") {
  const std::vector<row> rows{{"moved(versor, round)", {79, 70}, {89, 80}, {25, 20}}};
  const temporary_folder folder;
  check(compiled(folder, with(conformal, "versor", unit_versor("versor", "round", ", 'rev(versor) * versor = 1'")),
                 listed(rows)),
        rows);
}

TEST_CASE("a certificate bounds what a relation leaves out") {
  const temporary_folder folder;
  const compilation c = compiled(folder, with_unit_motors(planes_as_vectors), "'sandwich(motor, line)'");
  const lower::formula &f = c.kernels[0].value;
  // A motor that is not unit: the values differ from the formula's by at most the residual times the sizes.
  const std::vector<ir::rational> at{
      ir::rational(9, 8), {1, 3}, {-1, 5}, {2, 7}, {1, 2}, {3, 4}, {-2, 3}, {1, 9}, 3, -2, 5, {1, 2}, 4, -1};
  REQUIRE(at.size() == f.blade_inputs.size());
  ir::rational residual = 0; // the largest coefficient of motor * rev(motor) - 1
  const lower::kernel norm = compile_expression(c, "M * rev(M) - 1", {{"M", "motor"}});
  // A formula that the relations would make a constant keeps its program.
  CHECK(norm.value.assumed.taken.empty());
  for (const ir::rational &x : ir::evaluate(norm.value.from_blades, {at.begin(), at.begin() + 8}))
    residual = std::max(residual, ir::rational(abs(x)));
  const std::vector<ir::rational> have = ir::evaluate(f.from_blades, at);
  std::vector<ir::rational> sizes;
  for (const ir::rational &x : at)
    sizes.emplace_back(abs(x));
  bool any = false;
  for (std::size_t i = 0; i < have.size(); ++i) {
    const ir::rational difference = abs(ir::rational(have[i] - f.polynomials[i].evaluate(at)));
    CHECK(difference <= residual * f.assumed.taken[0].left_out[i].evaluate(sizes));
    any = any || difference != 0;
  }
  CHECK(any);
}

TEST_CASE("verify sees a program that is right for products of two reflections alone") {
  const temporary_folder folder;
  const compilation c = compiled(folder, with_unit_motors(planes_as_vectors), "'sandwich(motor, point)'");
  lower::kernel wrong = c.kernels[0];
  // 2 (s p - u.d) is zero for every motor; p alone is zero for products of two reflections in planes through a common point.
  lower::formula &f = wrong.value;
  ir::node_id &first = f.from_blades.results[0];
  std::size_t p = 0;
  while (f.blade_inputs[p] != "X.e0^e1^e2^e3")
    ++p;
  first = f.from_blades.nodes.add(first, f.from_blades.nodes.input(static_cast<int>(p)));
  f.assumed.computed = ir::to_poly(f.from_blades, *f.numbers);
  CHECK(verify::verify_formula(*c.model, wrong, 40, 5).wrong > 0);
}

TEST_CASE("a sign never takes a relation that rounding makes true") {
  const temporary_folder folder, other;
  const std::string function = "'above(M, q)' = 'sign((q ^ (M * (e1^e2^e3) * rev(M)))[I])'\n";
  const std::string with_unit = with_unit_motors(planes_as_vectors) + function;
  const char *const kernel = "'above(motor, plane)'";
  const compilation a = compiled(folder, planes_as_vectors + function, kernel), b = compiled(other, with_unit, kernel);
  const auto &of_a = a.kernels[0].decision.signs.atoms(), &of_b = b.kernels[0].decision.signs.atoms();
  REQUIRE(of_a.size() == of_b.size());
  REQUIRE_FALSE(of_a.empty());
  for (std::size_t i = 0; i < of_a.size(); ++i)
    CHECK(of_a[i].text() == of_b[i].text());
}

TEST_CASE("a sign whose terms differ in degree in a versor's numbers is refused, with the term to scale") {
  const std::string image = "(q ^ (M * (e1^e2^e3 - e0^e2^e3) * rev(M)))[I]";
  for (const auto &[body, is_refused] :
       {std::pair(image + " - q[e0]", true), std::pair(image + " - q[e0] * (M * rev(M))[1]", false)}) {
    INFO(body);
    const temporary_folder folder;
    folder.write("a.toml", with_unit_motors(planes_as_vectors) + "'beyond(M, q)' = 'sign(" + body + ")'\n");
    folder.write(
        "s.toml",
        "[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nrungs = ['fp32']\nkernels = ['beyond(motor, plane)']\n");
    const outcome o = run_meetc("generate s.toml -o out", folder.path());
    CHECK(o.code == (is_refused ? 2 : 0));
    if (is_refused)
      CHECK_THAT(o.err,
                 contains("has terms of degree 0 and of degree 2 in the numbers of X, a motor that is unit only up to "
                          "rounding; multiply the terms -Y.d by motor * rev(motor)") &&
                     contains("s.toml:5:12"));
  }
}

TEST_CASE("a relation or a sample that cannot be has a place and a remedy") {
  const std::string samples = "samples.of = ['p: plane', 'q: plane']\nsamples.blades = ['unit(p) * unit(q)']\n";
  const std::string unit = "relations.nearly = ['motor * rev(motor) = 1']\n";
  const std::vector<std::pair<std::string, std::string>> rows{
      {unit + samples, "kinds.motor.relations.nearly needs 'within'"},
      {unit + "relations.within = 1e-6\n", "kinds.motor.relations.nearly needs kinds.motor.samples"},
      {unit + "relations.within = 0\n" + samples, "kinds.motor.relations.within must be a number above 0"},
      {"relations.within = 1e-6\n", "kinds.motor.relations.within belongs to 'nearly', which is not there"},
      {samples, "kinds.motor.samples belongs to 'relations', which is not there"},
      {"relations.is = ['motor * rev(motor)']\n", "a relation is an equation: write 'a = b'"},
      {"relations.is = ['motor == 1']\n", "a relation is one equation: write 'a = b'"},
      {"relations.is = ['motor = 1 = 2']\n", "a relation is one equation: write 'a = b'"},
      {"relations.is = ['s*s = 1']\n",
       "'s' is a stored number, and a relation is about the blade: write its coefficient"},
      {"relations.is = ['motor * rev(motor) = 1']\n", "does not hold identically in the stored numbers of 'motor'; if "
                                                      "rounding makes it true, state it as relations.nearly"},
      {"relations.are = ['motor = 1']\n", "kinds.motor.relations has no 'are'; it may have: is, nearly, within"},
      {unit + "relations.within = 1e-6\nsamples.of = ['p: plane']\n", "kinds.motor.samples needs 'of'"},
      {unit + "relations.within = 1e-6\nsamples.of = ['p: plane']\nsamples.blades = []\n",
       "kinds.motor.samples.blades is empty"},
      {unit + "relations.within = 1e-6\nsamples.of = ['p: plane']\nsamples.blades = ['p']\n",
       "this sample of 'motor' has a coefficient of e0, which the kind's blade has not"},
      {unit + "relations.within = 1e-6\nsamples.of = ['p: plane']\nsamples.blades = ['p * p']\n",
       "this sample of 'motor' does not satisfy 'motor * rev(motor) = 1'"},
      {unit + "relations.within = 1e-6\nsamples.of = ['p: sheet']\nsamples.blades = ['p']\n", "no kind 'sheet'"},
      {unit + "relations.within = 1e-6\nsamples.of = ['p: plane']\nsamples.blades = ['q * p']\n", "unknown name 'q'"},
  };
  for (const auto &[lines, message] : rows) {
    INFO(lines);
    const temporary_folder folder;
    folder.write("a.toml", with(planes_as_vectors, "motor", lines));
    folder.write("s.toml", "[scene]\nalgebra = 'a.toml'\nnamespace = 'k'\nkernels = ['sandwich(motor, point)']\n");
    const outcome o = run_meetc("generate s.toml -o out", folder.path());
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK_THAT(o.err, contains(message) && contains("a.toml:") && contains("^"));
    CHECK_FALSE(fs::exists(folder.path() / "out"));
  }
}
