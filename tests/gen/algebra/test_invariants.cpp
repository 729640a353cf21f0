// Facts that any correct compiler must find in the shipped algebra, as identities of polynomials.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"
#include "tests/gen/oracle/random.hpp"

#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;
using oracle_test::random_numbers;
using rational = oracle::rational;

namespace {

using operands = std::vector<std::pair<std::string, std::string>>;

// Expressions over shared operands, expanded exactly in their stored numbers.
class expansion {
public:
  explicit expansion(const operands &with) {
    std::vector<std::string> names;
    std::vector<const lang::kind *> kinds;
    for (const auto &[name, kind] : with) {
      names.push_back(name);
      kinds.push_back(&model().kind(kind, {}));
    }
    ring_ = lower::stored_numbers(model(), names, kinds).numbers;
    expand_ = std::make_unique<lower::expander>(model(), *ring_, signs_);
    for (std::size_t i = 0; i < names.size(); ++i)
      environment_.emplace_back(names[i], expand_->operand(*kinds[i], names[i] + '.'));
  }
  lower::multivector operator()(const std::string &text) {
    return expand_->evaluate_multivector(*lang::parse_expression(text, "a test"), environment_);
  }
  lower::sign_value sign(const std::string &text) {
    return std::get<lower::sign_value>(expand_->evaluate(*lang::parse_expression(text, "a test"), environment_).is);
  }
  bool equal(const std::string &a, const std::string &b) { return ((*this)(a) - (*this)(b)).is_zero(); }

private:
  std::shared_ptr<poly::ring> ring_;
  lower::decision signs_;
  std::unique_ptr<lower::expander> expand_;
  lower::environment environment_;

  static const lower::model &model() { return *default_scene().model; }
};

// Solves a 3 by 3 system by Cramer's rule.
std::array<rational, 3> solve(const std::array<std::array<rational, 3>, 3> &a, const std::array<rational, 3> &b) {
  const auto determinant = [](const std::array<std::array<rational, 3>, 3> &m) -> rational {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  };
  const rational d = determinant(a);
  std::array<rational, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    auto m = a;
    for (std::size_t row = 0; row < 3; ++row)
      m[row][k] = b[row];
    out[k] = determinant(m) / d;
  }
  return out;
}

} // namespace

TEST_CASE("points are null, and their product is the distance") {
  expansion e(operands{{"P", "point"}, {"Q", "point"}});
  CHECK(e("norm2(P)").is_zero());
  CHECK(e("P*P").is_zero());
  CHECK(e.equal("P | Q", "-2*((P.x - Q.x)*(P.x - Q.x) + (P.y - Q.y)*(P.y - Q.y) + (P.z - Q.z)*(P.z - Q.z))"));
  CHECK(e.equal("n*n", "0"));
  CHECK(e.equal("nb*nb", "0"));
  CHECK(e.equal("n | nb", "2"));
  CHECK(e.equal("I*I", "-1"));
}

TEST_CASE("the radius comes back from the blade of a sphere") {
  expansion e(operands{{"S", "sphere"}});
  CHECK(e.equal("norm2(I*S)",
                "S.r*S.r*(((I*S) | n) * ((I*S) | n))")); // r^2 = S^2 / (S . n)^2, of the dual vector
}

TEST_CASE("the radius comes back from the blade of a sphere through four points") {
  const lower::model &m = *default_scene().model;
  const lang::kind &sphere = *m.spec().find_kind("sphere");
  const auto makers = lower::makers(m, sphere);
  REQUIRE(makers.size() == 2);
  const lower::blade_maker &through = makers[1];
  const auto blades = lower::support(m, sphere);
  const poly::ring ring([&] {
    std::vector<std::string> names;
    for (const auto b : blades)
      names.push_back(m.working().name(b));
    return names;
  }());
  lower::decision unused;
  lower::expander expand(m, ring, unused);
  const lower::environment env{{"S", expand.general(blades, ring.names())}};
  const auto number = [&](const char *text, const std::vector<rational> &at) {
    const auto v = expand.evaluate_multivector(*lang::parse_expression(text, "a test"), env);
    return v.is_zero() ? rational(0) : v.terms().begin()->second.evaluate(at);
  };
  random_numbers random(5);
  int checked = 0;
  for (int round = 0; round < 40; ++round) {
    std::array<std::array<rational, 3>, 4> p;
    std::vector<rational> inputs;
    for (auto &point : p)
      for (rational &x : point)
        inputs.push_back(x = random.fraction(4));
    // The centre follows from three linear equations: |c - p0|^2 = |c - pi|^2.
    std::array<std::array<rational, 3>, 3> a;
    std::array<rational, 3> b;
    for (std::size_t i = 0; i < 3; ++i) {
      b[i] = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        a[i][k] = 2 * (p[i + 1][k] - p[0][k]);
        b[i] += p[i + 1][k] * p[i + 1][k] - p[0][k] * p[0][k];
      }
    }
    const auto coefficients = ir::evaluate(through.code, inputs);
    const rational weight = number("(I*S) | n", coefficients);
    if (weight == 0)
      continue; // four coplanar points
    const auto c = solve(a, b);
    rational square = 0;
    for (std::size_t k = 0; k < 3; ++k)
      square += (c[k] - p[0][k]) * (c[k] - p[0][k]);
    CHECK(number("norm2(I*S)", coefficients) / (weight * weight) == square);
    ++checked;
  }
  CHECK(checked > 30);
}

TEST_CASE("swapping the operands of a meet changes its sign as the dual grades say") {
  const lower::model &m = *default_scene().model;
  const std::vector<std::pair<std::string, int>> kinds{
      {"point_pair", 2}, {"line", 3}, {"circle", 3}, {"plane", 4}, {"sphere", 4}};
  for (const auto &[x, gx] : kinds)
    for (const auto &[y, gy] : kinds) {
      if (gx + gy < 5)
        continue;
      INFO(x << ' ' << y);
      expansion e(operands{{"X", x}, {"Y", y}});
      const int sign = (5 - gx) * (5 - gy) % 2 ? -1 : 1;
      CHECK(e.equal("meet(X, Y)", fmt::format("{}*meet(Y, X)", sign < 0 ? "(-1)" : "1")));
      CHECK(e.equal("norm2(meet(X, Y))", "norm2(meet(Y, X))"));
      CHECK(algebra::grade(m.working().pseudoscalar()) == 5);
      const auto meet = e("meet(X, Y)");
      for (const auto &[b, c] : meet.terms())
        CHECK(algebra::grade(b) == gx + gy - 5);
    }
}

TEST_CASE("two lines: B squared is identically zero, and B a multiple of n") {
  expansion e(operands{{"K", "line"}, {"L", "line"}});
  CHECK(e("norm2(meet(K, L))").is_zero());
  CHECK(e.equal("meet(K, L)", "meet(K, L)[n]*n"));
  CHECK_FALSE(e("meet(K, L)").is_zero());
}

TEST_CASE("twist turns over with either line's direction, and not with the order of the lines") {
  expansion e(operands{{"a", "point"}, {"b", "point"}, {"c", "point"}, {"d", "point"}});
  const auto ab = e.sign("twist(segment(a, b), segment(c, d))");
  CHECK(ab.atoms.size() == 1);
  CHECK(e.sign("twist(segment(b, a), segment(c, d))") == -ab);
  CHECK(e.sign("twist(segment(a, b), segment(d, c))") == -ab);
  CHECK(e.sign("twist(segment(b, a), segment(d, c))") == ab);
  CHECK(e.sign("twist(segment(c, d), segment(a, b))") == ab);
  CHECK(e.sign("twist(segment(a, b), segment(a, c))").unit == 0); // lines that share a point
}

TEST_CASE("side is the orientation of four points, and turns over with their order") {
  expansion e(operands{{"a", "point"}, {"b", "point"}, {"c", "point"}, {"p", "point"}});
  const auto side = e.sign("side(triangle(a, b, c), p)");
  CHECK(side.atoms.size() == 1);
  CHECK(e.sign("side(triangle(b, a, c), p)") == -side);
  CHECK(e.sign("side(triangle(b, c, a), p)") == side);
  CHECK(e.sign("side(triangle(a, b, p), c)") == -side);
  CHECK(e.sign("side(triangle(a, b, c), a)").unit == 0);
  // [b - a, c - a, p - a] by components
  const char *text = "sign((b.x-a.x)*((c.y-a.y)*(p.z-a.z) - (c.z-a.z)*(p.y-a.y))"
                     " + (b.y-a.y)*((c.z-a.z)*(p.x-a.x) - (c.x-a.x)*(p.z-a.z))"
                     " + (b.z-a.z)*((c.x-a.x)*(p.y-a.y) - (c.y-a.y)*(p.x-a.x)))";
  CHECK(e.sign(text) == side);
}

TEST_CASE("a sphere's side is plus inside, zero on the surface, minus outside") {
  expansion e(operands{{"S", "sphere"}, {"p", "point"}});
  CHECK(e.sign("side(S, p)") == e.sign("sign(S.r*S.r - (p.x - S.c.x)*(p.x - S.c.x) - (p.y - S.c.y)*(p.y - S.c.y)"
                                       " - (p.z - S.c.z)*(p.z - S.c.z))"));
}

TEST_CASE("B squared of two spheres factors into its two quadrics") {
  const lower::predicate &p = default_kernel("sphere_sphere").decision;
  REQUIRE(p.signs.atoms().size() == 2);
  for (const auto &atom : p.signs.atoms())
    CHECK(atom.total_degree() == 2);
}
