// The separation of polynomials: the terms add up to the polynomial, exactly, and fewer would not do. The second part
// is shown without the pass: the numbers p(X_i, Y_j) at random points, modulo a prime, have a rank that no sum of fewer
// products can have.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"
#include "tests/gen/oracle/random.hpp"

#include "gen/poly/separate.hpp"

#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace meetc;
using namespace meetc::compiler_test;
using oracle_test::random_numbers;
using polynomial = poly::poly;
using poly::separation;

namespace {

constexpr std::uint64_t prime = 2147483647;

std::uint64_t modulo(const mpz_class &z) {
  return mpz_fdiv_ui(z.get_mpz_t(), prime);
}
std::uint64_t inverse(std::uint64_t a) {
  std::uint64_t out = 1;
  for (std::uint64_t e = prime - 2; e; e >>= 1, a = a * a % prime)
    if (e & 1)
      out = out * a % prime;
  return out;
}

// The rank, modulo the prime, of p at `points` random values of X by as many of Y.
int rank_of_values(const polynomial &p, int first_of_y, int points, std::uint64_t seed) {
  random_numbers random(seed);
  const auto n = static_cast<std::size_t>(points), variables = static_cast<std::size_t>(p.in().size());
  std::vector<std::vector<std::uint64_t>> at(n, std::vector<std::uint64_t>(variables));
  for (auto &point : at)
    for (auto &v : point)
      v = static_cast<std::uint64_t>(random.integer(1, 2000000000));
  std::vector<std::vector<std::uint64_t>> m(n, std::vector<std::uint64_t>(n));
  for (const poly::term &t : p.terms()) {
    const std::uint64_t c = modulo(t.coefficient.get_num()) * inverse(modulo(t.coefficient.get_den())) % prime;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        std::uint64_t value = c;
        for (const poly::power &f : t.factors)
          for (int e = 0; e < f.exponent; ++e)
            value = value * at[f.variable < first_of_y ? i : j][static_cast<std::size_t>(f.variable)] % prime;
        m[i][j] = (m[i][j] + value) % prime;
      }
  }
  int rank = 0;
  for (std::size_t column = 0, from = 0; column < n && from < n; ++column) {
    std::size_t pivot = from;
    while (pivot < n && m[pivot][column] == 0)
      ++pivot;
    if (pivot == n)
      continue;
    std::swap(m[pivot], m[from]);
    const std::uint64_t scale = inverse(m[from][column]);
    for (std::size_t i = from + 1; i < n; ++i)
      if (const std::uint64_t factor = m[i][column] * scale % prime)
        for (std::size_t j = column; j < n; ++j)
          m[i][j] = (m[i][j] + (prime - factor) * m[from][j]) % prime;
    ++from;
    ++rank;
  }
  return rank;
}

bool within(const polynomial &p, int from, int to) {
  for (const int v : p.variables())
    if (v < from || v >= to)
      return false;
  return true;
}

// Everything that the header of the pass promises.
separation checked(const polynomial &p, int first_of_y) {
  const separation s = separate(p, first_of_y);
  CHECK(poly::to_poly(s) == p);
  const int n = p.in().size();
  CHECK(within(s.of_x, 0, first_of_y));
  CHECK(within(s.of_y, first_of_y, n));
  for (const poly::product &k : s.products) {
    CHECK(within(k.f, 0, first_of_y));
    CHECK(within(k.g, first_of_y, n));
    CHECK_FALSE(k.f.is_constant());
    CHECK_FALSE(k.g.is_constant());
    CHECK(k.f.primitive().first == 1);
  }
  CHECK(rank_of_values(p, first_of_y, s.terms() + 2, 7) == s.terms());
  return s;
}

polynomial random_polynomial(const poly::ring &r, int from, int to, int terms, random_numbers &random) {
  polynomial sum(r);
  for (int i = 0; i < terms; ++i) {
    polynomial product(r, random.fraction());
    for (int degree = random.integer(0, 3); degree > 0; --degree)
      product = product * polynomial::variable(r, random.integer(from, to - 1));
    sum = sum + product;
  }
  return sum;
}

std::string text(const separation &s) {
  std::string out;
  for (const poly::product &k : s.products)
    out += fmt::format("({}) ({})\n", k.f.text(), k.g.text());
  return out + fmt::format("{}\n{}\n", s.of_x.text(), s.of_y.text());
}

polynomial balls(const poly::ring &r) {
  const auto v = [&](int i) { return polynomial::variable(r, i); };
  polynomial p(r);
  for (int i = 0; i < 3; ++i)
    p = p + (v(i) - v(i + 4)) * (v(i) - v(i + 4));
  return p - (v(3) + v(7)) * (v(3) + v(7));
}

// Polynomials as in the JSON, by their variables with exponents.
using terms = std::map<std::map<std::string, int>, mpq_class>;
terms read_terms(const nlohmann::json &list) {
  terms out;
  for (const auto &t : list) {
    mpq_class c(t.at(0).get<std::string>());
    c.canonicalize();
    out[t.at(1).get<std::map<std::string, int>>()] += c;
  }
  return out;
}
terms sum_of(const nlohmann::json &separation) {
  terms out = read_terms(separation.at("of_x"));
  for (const auto &[variables, c] : read_terms(separation.at("of_y")))
    out[variables] += c;
  for (const auto &product : separation.at("products"))
    for (const auto &[f, a] : read_terms(product.at(0)))
      for (const auto &[g, b] : read_terms(product.at(1))) {
        std::map<std::string, int> both = f;
        for (const auto &[name, exponent] : g)
          both[name] += exponent;
        out[both] += a * b;
      }
  std::erase_if(out, [](const auto &t) { return t.second == 0; });
  return out;
}

} // namespace

TEST_CASE("random polynomials are separated exactly, into as few terms as there can be") {
  random_numbers random(2024);
  const poly::ring r({"a", "b", "c", "d", "e", "f"});
  std::size_t additive = 0, largest = 0;
  for (int i = 0; i < 150; ++i) {
    const int first_of_y = random.integer(1, 5);
    const polynomial p = random_polynomial(r, 0, 6, random.integer(1, 25), random);
    INFO(p.text());
    const separation s = checked(p, first_of_y);
    additive += static_cast<std::size_t>(s.additive());
    largest = std::max(largest, s.products.size());
  }
  CHECK(additive > 50);
  CHECK(largest >= 4);
}

TEST_CASE("sums of a known number of products are separated into that number") {
  random_numbers random(5);
  const poly::ring r({"a", "b", "c", "d", "e", "f"});
  for (int rank = 1; rank <= 6; ++rank)
    for (int i = 0; i < 12; ++i) {
      // f_k starts with a^k b and g_k with d^k e, which no other has: they are independent.
      polynomial p(r), f(r, 1), g(r, 1);
      for (int k = 0; k < rank; ++k) {
        f = f * polynomial::variable(r, 0);
        g = g * polynomial::variable(r, 3);
        p = p + (f * polynomial::variable(r, 1) + random_polynomial(r, 1, 3, 4, random).scaled(3)) *
                    (g * polynomial::variable(r, 4) + random_polynomial(r, 4, 6, 4, random));
      }
      INFO(p.text());
      CHECK(checked(p, 3).terms() == rank);
    }
}

TEST_CASE("additive terms are split off where they cost no term, and only there") {
  const poly::ring r({"x", "y"});
  const polynomial x = polynomial::variable(r, 0), y = polynomial::variable(r, 1), one(r, 1);
  struct row {
    polynomial p;
    std::size_t products;
    std::string of_x, of_y;
  };
  for (const row &e : {row{polynomial(r), 0, "0", "0"}, row{one.scaled(3), 0, "3", "0"}, row{x + y, 0, "x", "y"},
                       row{x + y + one, 0, "x + 1", "y"}, row{(x + one) * (y + one), 1, "0", "0"},
                       row{x * y + one, 1, "1", "0"}, row{x * y + x, 1, "0", "0"}, row{x * y + x * x, 1, "x^2", "0"},
                       row{x * y + y * y, 1, "0", "y^2"}, row{x * y + x * x + y * y + x, 1, "x^2 + x", "y^2"},
                       row{x * x + x * y + y, 1, "x^2", "0"}, row{x * x, 0, "x^2", "0"}, row{y, 0, "0", "y"}}) {
    INFO(e.p.text());
    const separation s = checked(e.p, 1);
    CHECK(s.products.size() == e.products);
    CHECK(s.of_x.text() == e.of_x);
    CHECK(s.of_y.text() == e.of_y);
  }
}

TEST_CASE("touching balls are four products and two additive terms") {
  const poly::ring r({"x", "y", "z", "r", "u", "v", "w", "s"});
  const separation half = checked(balls(r).scaled(poly::rational(1, 2)), 4);
  CHECK(half.terms() == 6);
  CHECK(text(half) == "(x) (-u)\n(y) (-v)\n(z) (-w)\n(r) (-s)\n"
                      "1/2*x^2 + 1/2*y^2 + 1/2*z^2 - 1/2*r^2\n1/2*u^2 + 1/2*v^2 + 1/2*w^2 - 1/2*s^2\n");
}

TEST_CASE("equal polynomials are separated into the same text") {
  random_numbers random(11);
  const poly::ring r({"a", "b", "c", "d", "e", "f"});
  for (int i = 0; i < 30; ++i) {
    const polynomial p = random_polynomial(r, 0, 6, 20, random), q = random_polynomial(r, 0, 6, 20, random);
    auto terms = (p + q).terms();
    std::reverse(terms.begin(), terms.end());
    CHECK(text(separate(p + q, 3)) == text(separate(polynomial::from_terms(r, terms), 3)));
  }
}

TEST_CASE("every shipped sign is separated in the stored numbers") {
  int signs = 0;
  for (const lower::kernel *k : default_kernels(want::made_of_signs)) {
    INFO(k->asked.text);
    for (const polynomial &atom : k->decision.signs.atoms()) {
      checked(atom, k->decision.inputs_a);
      ++signs;
    }
  }
  CHECK(signs > 100);
  const lower::predicate &solid = default_kernel("ball_ball").decision;
  REQUIRE(solid.signs.atoms().size() == 1);
  CHECK(checked(solid.signs.atoms()[0], solid.inputs_a).terms() == 6);
}

TEST_CASE("every shipped formula is separated on blades, and every meet is bilinear") {
  for (const lower::kernel *k : default_kernels(want::formulas)) {
    INFO(k->asked.text);
    const auto inputs_a = static_cast<int>(lower::support(*default_scene().model, *k->asked.kinds[0]).size());
    for (const polynomial &p : k->value.polynomials) {
      const separation s = checked(p, inputs_a);
      CHECK(s.additive() == 0);
      if (k->asked.function == "meet")
        for (const poly::product &product : s.products) {
          CHECK(product.f.total_degree() == 1);
          CHECK(product.g.total_degree() == 1);
        }
    }
  }
}

TEST_CASE("JSON has the sums of what it has as polynomials") {
  std::size_t seen = 0;
  for (const lower::kernel &k : default_scene().kernels) {
    INFO(k.asked.text);
    const auto all = nlohmann::json::parse(shown(default_scene(), k, "json"));
    const auto compare = [&](const nlohmann::json &written, const nlohmann::json &separation) {
      CHECK(read_terms(written) == sum_of(separation));
      ++seen;
    };
    if (k.is_predicate) {
      for (const auto &[stage, atoms] : all.at("atoms").items()) {
        REQUIRE(all.at("separate").at(stage).size() == atoms.size());
        for (std::size_t i = 0; i < atoms.size(); ++i)
          compare(atoms[i], all.at("separate").at(stage)[i]);
      }
      continue;
    }
    for (const auto &[blade, written] : all.at("blades").items())
      compare(written, all.at("separate").at(blade));
    compare(all.at("norm2"), all.at("separate").at("norm2"));
  }
  CHECK(seen > 250);
}

TEST_CASE("the table has every kernel of the scene, and counts every sign and value") {
  const std::string scene = '\'' + default_scene_path().string() + '\'';
  const outcome o = run_meetc(fmt::format("show {} --emit=separate", scene), source_folder());
  REQUIRE(o.code == 0);
  std::map<std::string, int> counted;
  std::istringstream lines(o.out);
  std::string kernel, row;
  std::getline(lines, row);
  const std::size_t column = row.find("  of");
  REQUIRE(column != std::string::npos);
  while (std::getline(lines, row) && row.rfind("columns:", 0) != 0) {
    if (row[0] != ' ')
      kernel = row.substr(0, row.find_last_not_of(' ', column - 1) + 1);
    std::istringstream cells(row.substr(column));
    std::string of;
    int count = 0, terms = 0, products = 0, additive = 0, columns = 0, steps = 0;
    REQUIRE(cells >> of >> count >> terms >> products >> additive >> columns >> steps);
    counted[kernel] += count;
    CHECK(terms == products + additive);
    CHECK(columns == 3 * products + 2 * additive);
    CHECK((16 * (steps - 1) < columns && columns <= 16 * steps));
    if (kernel == "ball_ball")
      CHECK((terms == 6 && columns == 16 && steps == 1));
  }
  CHECK(counted.size() == default_scene().kernels.size());
  for (const lower::kernel &k : default_scene().kernels) {
    INFO(k.asked.text);
    const auto &p = k.decision;
    CHECK(counted[k.asked.text] ==
          static_cast<int>(k.is_predicate ? p.reject.atoms.size() + p.common.atoms.size() + p.rare.atoms.size()
                                          : k.value.polynomials.size()));
  }
}
