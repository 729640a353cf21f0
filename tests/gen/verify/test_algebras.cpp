// Other algebras, since the compiler knows none by name. A degenerate, a planar and two non-diagonal metrics are each
// verified against the dense product in their own basis, and predicates of the plane against exact geometry.
#include "gen/verify/dense_evaluator.hpp"
#include "gen/verify/verify.hpp"
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"
#include "tests/gen/oracle/random.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

using namespace meetc;
using namespace meetc::compiler_test;
using oracle_test::random_numbers;
using rational = oracle::rational;

namespace {

// Planes as vectors of R(3,0,1): points and lines are met from them.
const char *const plane_based = R"([algebra]
vectors = ['e0', 'e1', 'e2', 'e3']
squares = [0, 1, 1, 1]
[constants]
axes = '[e1, e2, e3]'
[kinds.plane]
store = ['a: real', 'b: real', 'c: real', 'd: real']
blade = 'a*e1 + b*e2 + c*e3 + d*e0'
[kinds.line]
store = ['P: plane', 'Q: plane']
blade = 'P ^ Q'
[kinds.point]
store = ['x: real', 'y: real', 'z: real']
blade = 'e1^e2^e3 + (x*e3^e2 + y*e1^e3 + z*e2^e1)^e0'
[functions]
'meet(X, Y)' = 'X ^ Y'
'reflect(P, X)' = 'P*X*P'
'norm2(B)' = '(B*B)[1]'
)";

// The conformal plane, R(3,1).
const char *const planar = R"([algebra]
vectors = ['e1', 'e2', 'e', 'eb']
squares = [1, 1, 1, -1]
null    = ['n', 'nb']
import  = ['words.toml']
[constants]
I    = 'e1 ^ e2 ^ e ^ eb'
n    = 'e + eb'
nb   = 'e - eb'
axes = '[e1, e2]'
[kinds.point]
store    = ['x: real', 'y: real']
position = true
blade    = '2*(x*e1 + y*e2) + (x*x + y*y)*n - nb'
[kinds.circle]
store = ['c: point', 'r: real']
blade = '-I*(c - r*r*n)'
where = 'r >= 0'
hull  = '[c]'
pad   = 'r'
from.points.of    = ['a: point', 'b: point', 'c: point']
from.points.blade = 'a ^ b ^ c'
[kinds.line]
store = ['p: point', 'q: point']
blade = 'p ^ q ^ n'
[kinds.point_pair]
store = ['p: point', 'q: point']
blade = 'p ^ q'
[kinds.segment]
store = ['p: point', 'q: point']
blade = 'p ^ q ^ n'
hull  = '[p, q]'
parts.ends = '[p, q]'
[functions]
'norm2(B)' = '(B*B)[1]'
'turn(a, b, c)' = 'sign((a ^ b ^ c ^ n)[I])'
'side(H, p)' = 'sign((H ^ p)[I])'
[functions.'meet(X, Y)']
is    = '(I*X) | Y'
where = 'grade(X) + grade(Y) >= 4'
[predicates.disc_disc]
of   = ['S: circle', 'T: circle']
mode = 'solid'
hit  = 'sign(2*((I*S) | (I*T)) + 8*S.r*T.r) >= 0'
[predicates.ring_ring]
of   = ['S: circle', 'T: circle']
mode = 'surface'
hit  = 'sign(norm2(meet(S, T))) >= 0'
[predicates.cross]
of   = ['s: segment', 't: segment']
hit  = '''
    turn(s.p, s.q, t.p) * turn(s.p, s.q, t.q) <= 0
and turn(t.p, t.q, s.p) * turn(t.p, t.q, s.q) <= 0
and all(k in axes: overlap(k, s.ends, t.ends))'''
)";

// The conformal space, declared in its null basis: the metric is not diagonal, and the basis does not change.
const char *const null_basis = R"([algebra]
vectors = ['o', 'e1', 'e2', 'e3', 'n']
metric  = [[0, 0, 0, 0, -1], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, 0, 0, 0, 0]]
[constants]
I    = 'e1 ^ e2 ^ e3 ^ o ^ n'
axes = '[e1, e2, e3]'
[kinds.point]
store    = ['x: real', 'y: real', 'z: real']
position = true
blade    = 'o + x*e1 + y*e2 + z*e3 + (x*x + y*y + z*z)*n/2'
[kinds.sphere]
store = ['c: point', 'r: real']
blade = 'I*(c - r*r*n/2)'
where = 'r >= 0'
hull  = '[c]'
pad   = 'r'
[kinds.line]
store = ['p: point', 'q: point']
blade = 'p ^ q ^ n'
[functions]
'norm2(B)' = '(B*B)[1]'
'dual(X)' = 'I*X'
[functions.'meet(X, Y)']
is    = '(I*X) | Y'
where = 'grade(X) + grade(Y) >= 5'
[predicates.ball_ball]
of   = ['S: sphere', 'T: sphere']
mode = 'solid'
hit  = 'sign((dual(S) | dual(T)) + S.r*T.r) >= 0'
)";

// A metric without any structure: half of it fractions, one direction null.
const char *const crooked = R"([algebra]
vectors = ['a', 'b', 'c']
metric  = [[0, '1/2', -3], ['1/2', 2, '-5/7'], [-3, '-5/7', 1]]
[constants]
I = 'a ^ b ^ c'
[kinds.vector]
store = ['x: real', 'y: real', 'z: real']
blade = 'x*a + y*b + z*c'
[kinds.plane]
store = ['u: vector', 'v: vector']
blade = 'u ^ v'
[functions]
'meet(X, Y)' = '(I*X) | Y'
'mixed(X, Y)' = 'X*Y + (X | Y)*I - Y*X*X/3'
'norm2(B)' = '(B*B)[1]'
)";

struct other {
  const char *name, *algebra;
  std::vector<std::string> kernels;
};
const std::vector<other> others{
    {"plane based",
     plane_based,
     {"meet(plane, plane)", "meet(plane, line)", "meet(line, plane)", "reflect(plane, plane)", "reflect(plane, line)",
      "reflect(plane, point)", "norm2(plane)", "norm2(line)", "norm2(meet(plane, plane))", "norm2(point)"}},
    {"planar",
     planar,
     {"meet(circle, circle)", "meet(line, circle)", "meet(circle, line)", "meet(line, line)",
      "norm2(meet(circle, circle))", "norm2(meet(line, circle))", "norm2(meet(line, line))", "meet(point_pair, circle)",
      "disc_disc", "ring_ring", "cross"}},
    {"null basis",
     null_basis,
     {"meet(sphere, sphere)", "meet(sphere, line)", "meet(line, line)", "norm2(meet(sphere, sphere))",
      "norm2(meet(sphere, line))", "norm2(meet(line, line))", "ball_ball"}},
    {"crooked",
     crooked,
     {"meet(plane, plane)", "mixed(vector, vector)", "mixed(plane, vector)", "mixed(vector, plane)",
      "mixed(plane, plane)", "norm2(vector)", "norm2(plane)", "norm2(meet(plane, plane))"}},
};

compilation compile_other(const temporary_folder &folder, const other &o) {
  folder.write("a.toml", o.algebra);
  folder.write("words.toml", read(source_folder() / "algebra_spec" / "predicates" / "words.toml"));
  folder.write("s.toml", small_scene(fmt::format("'{}'", fmt::join(o.kernels, "', '"))));
  compilation c = load((folder.path() / "s.toml").string());
  compile_all(c);
  return c;
}

} // namespace

TEST_CASE("formulas and predicates of other algebras are verified in the same way") {
  for (const other &o : others) {
    const temporary_folder folder;
    const compilation c = compile_other(folder, o);
    for (const lower::kernel &k : c.kernels) {
      INFO(o.name << ": " << k.asked.text);
      const verify::report r =
          k.is_predicate ? verify::verify_predicate(*c.model, k, 1500, 3) : verify::verify_formula(*c.model, k, 40, 3);
      CHECK(r.wrong == 0);
      CHECK(r.cases >= 40);
      CHECK(r.note.empty());
      if (k.is_predicate)
        CHECK((r.hits > 100 && r.hits < r.cases - 100));
      else
        CHECK(ir::to_poly(k.value.from_blades, *k.value.numbers) == k.value.polynomials);
    }
  }
}

TEST_CASE("the JSON of other algebras is the dense product in the declared basis") {
  random_numbers random(41);
  for (const other &o : others) {
    const temporary_folder folder;
    const compilation c = compile_other(folder, o);
    const oracle::matrix metric = declared_metric(*c.model);
    const verify::dense_evaluator dense(c.model->spec(), metric, identity(metric.size()), c.model->to_declared());
    for (const lower::kernel &k : c.kernels) {
      if (k.is_predicate)
        continue;
      INFO(o.name << ": " << k.asked.text);
      const nlohmann::json j = nlohmann::json::parse(shown(c, k, "json"));
      for (int round = 0; round < 5; ++round) {
        std::map<std::string, rational> at;
        verify::dense_scope scope;
        for (std::size_t i = 0; i < k.asked.kinds.size(); ++i) {
          std::vector<rational> numbers;
          for (std::size_t n = 0; n < c.model->layout(*k.asked.kinds[i]).reals.size(); ++n)
            numbers.push_back(random.fraction(4));
          std::size_t next = 0;
          scope[k.asked.names[i]] = dense.operand(*k.asked.kinds[i], numbers, next);
          const auto &blade = scope[k.asked.names[i]].blade;
          for (std::size_t b = 0; b < blade.size(); ++b)
            at[k.asked.names[i] + '.' + c.model->declared().name(static_cast<algebra::blade>(b))] = blade[b];
        }
        const auto want = dense.evaluate(*k.asked.body, scope);
        auto have = dense.algebra().zero();
        for (std::size_t b = 0; b < have.size(); ++b)
          if (const auto it = j.at("blades").find(c.model->declared().name(static_cast<algebra::blade>(b)));
              it != j.at("blades").end())
            have[b] = evaluate(*it, at);
        CHECK(have == want);
        CHECK(evaluate(j.at("norm2"), at) == oracle::scalar_part(dense.algebra().geometric(want, want)));
      }
    }
  }
}

TEST_CASE("the null basis of space gives the same decision as e and eb") {
  const temporary_folder folder;
  const compilation c = compile_other(folder, others[2]);
  const lower::predicate &mine = c.kernels.back().decision, &shipped = default_kernel("ball_ball").decision;
  REQUIRE(mine.signs.atoms().size() == 1);
  REQUIRE(shipped.signs.atoms().size() == 1);
  CHECK(mine.signs.atoms()[0].text() == shipped.signs.atoms()[0].text());
}

TEST_CASE("the geometric product of any symmetric metric agrees with the dense one, blade by blade") {
  random_numbers random(42);
  for (int round = 0; round < 12; ++round) {
    const std::size_t n = 2 + static_cast<std::size_t>(random.integer(0, 2));
    oracle::matrix g(n, std::vector<rational>(n));
    std::vector<std::string> names;
    for (std::size_t i = 0; i < n; ++i) {
      names.push_back(std::string(1, static_cast<char>('a' + i)));
      for (std::size_t j = 0; j <= i; ++j)
        g[i][j] = g[j][i] = random.integer(0, 2) ? random.fraction(2) : rational(0);
    }
    const algebra::metric m(names, g);
    const oracle::dense_algebra dense(g);
    for (std::size_t a = 0; a < dense.size(); ++a)
      for (std::size_t b = 0; b < dense.size(); ++b) {
        auto x = dense.zero(), y = dense.zero(), have = dense.zero();
        x[a] = y[b] = 1;
        for (const auto &[at, weight] : m.geometric(static_cast<algebra::blade>(a), static_cast<algebra::blade>(b)))
          have[at] = weight;
        CHECK(have == dense.geometric(x, y));
      }
  }
}
