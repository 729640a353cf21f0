// `show --emit=json` for every ordered pair of declared kinds: B and B^2 in the declared basis against the dense
// product, exactly, on valid operands that only the oracle made.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"
#include "tests/gen/oracle/random.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

using namespace meetc;
using namespace meetc::compiler_test;
using oracle::multivector;
using oracle::outer;
using oracle_test::random_numbers;
using json = nlohmann::ordered_json;
using rational = oracle::rational;

namespace {

const std::vector<std::string> basis{"e1", "e2", "e3", "e", "eb"};

std::string blade_name(std::size_t mask) {
  std::string out;
  for (std::size_t i = 0; i < basis.size(); ++i)
    if (mask >> i & 1)
      out += (out.empty() ? "" : "^") + basis[i];
  return out.empty() ? "1" : out;
}

// Declared order: by grade, then by the vectors that take part.
std::vector<std::string> declared_order() {
  std::vector<std::size_t> masks(32);
  for (std::size_t i = 0; i < masks.size(); ++i)
    masks[i] = i;
  const auto vectors = [](std::size_t m) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < 5; ++i)
      if (m >> i & 1)
        out.push_back(i);
    return out;
  };
  std::sort(masks.begin(), masks.end(), [&](std::size_t a, std::size_t b) {
    const auto va = vectors(a), vb = vectors(b);
    return std::pair(va.size(), va) < std::pair(vb.size(), vb);
  });
  std::vector<std::string> out;
  for (const std::size_t m : masks)
    out.push_back(blade_name(m));
  return out;
}

// The paper's objects, written here a second time, in its declared basis.
class geometry {
public:
  explicit geometry(std::uint64_t seed) : dense_(oracle::dense_algebra::diagonal({1, 1, 1, 1, -1})), random_(seed) {}

  const oracle::dense_algebra &algebra() const { return dense_; }

  multivector vector() { return vector_of(random_.fraction(3), random_.fraction(3), random_.fraction(3)); }
  multivector point() {
    const rational x = random_.fraction(3), y = random_.fraction(3), z = random_.fraction(3);
    return oracle::subtract(
        oracle::add(oracle::scale(2, vector_of(x, y, z)), oracle::scale(x * x + y * y + z * z, n())),
        oracle::subtract(dense_.vector(3), dense_.vector(4)));
  }
  multivector sphere_of(const multivector &centre) {
    const rational r = random_.fraction(3);
    return oracle::subtract(centre, oracle::scale(r * r, n()));
  }
  multivector dual(const multivector &x) const { return oracle::scale(-1, dense_.geometric(dense_.pseudoscalar(), x)); }
  multivector plane_vector(const multivector &normal, const rational &d) const {
    return oracle::add(normal, oracle::scale(d, n()));
  }
  // A random element of a kind, from one of its descriptions.
  multivector element(const std::string &kind) {
    const bool other = random_.integer(0, 1) != 0;
    if (kind == "point")
      return point();
    if (kind == "direction")
      return vector();
    if (kind == "point_pair" || kind == "box")
      return outer(point(), point());
    if (kind == "flat_point")
      return outer(point(), n());
    if (kind == "triangle_pair")
      return dense_.meet(element("triangle"), element("triangle"));
    if (kind == "line" || kind == "segment")
      return outer(outer(point(), other || kind == "segment" ? point() : vector()), n());
    if (kind == "circle") {
      if (other)
        return outer(outer(point(), point()), point());
      // A sphere about the centre cut by a plane through it: N . c from -(N + d n) | c = 0 on the dual side.
      const multivector c = point(), normal = vector();
      const rational along = oracle::scalar_part(dense_.left_contraction(normal, c)) / 2;
      return dual(outer(sphere_of(c), plane_vector(normal, along)));
    }
    if (kind == "plane" || kind == "triangle")
      return other || kind == "triangle" ? outer(outer(outer(point(), point()), point()), n())
                                         : dual(plane_vector(vector(), random_.fraction(5)));
    if (kind == "sphere")
      return other ? outer(outer(outer(point(), point()), point()), point()) : dual(sphere_of(point()));
    FAIL("the test knows no " << kind);
    return dense_.zero();
  }

private:
  oracle::dense_algebra dense_;
  random_numbers random_;

  multivector n() const { return oracle::add(dense_.vector(3), dense_.vector(4)); }
  multivector vector_of(const rational &x, const rational &y, const rational &z) const {
    return oracle::add(oracle::add(oracle::scale(x, dense_.vector(0)), oracle::scale(y, dense_.vector(1))),
                       oracle::scale(z, dense_.vector(2)));
  }
};

using values = std::map<std::string, rational>;

void name_coefficients(const std::string &operand, const multivector &m, values &out) {
  for (std::size_t mask = 0; mask < m.size(); ++mask)
    out[operand + '.' + blade_name(mask)] = m[mask];
}

const std::map<std::string, int> grades{{"point", 1},   {"direction", 1}, {"point_pair", 2}, {"flat_point", 2},
                                        {"line", 3},    {"circle", 3},    {"plane", 4},      {"sphere", 4},
                                        {"segment", 3}, {"triangle", 4},  {"box", 2},        {"triangle_pair", 3}};

// The keys of an object are in the given order.
void check_order(const json &object, const std::vector<std::string> &order) {
  std::size_t at = 0;
  for (const auto &[key, value] : object.items()) {
    const auto it = std::find(order.begin() + static_cast<std::ptrdiff_t>(at), order.end(), key);
    if (it == order.end())
      FAIL_CHECK(key << " stands out of order");
    else
      at = static_cast<std::size_t>(it - order.begin()) + 1;
  }
}

// meet(x, y) as JSON; B and B^2 on random elements.
void check_pair(const std::string &text, const std::string &x, const std::string &y, geometry &g, int rounds) {
  const json j = json::parse(text);
  CHECK(j.at("kernel") == "meet(" + x + ", " + y + ")");
  CHECK(j.at("operands") == json({{"X", x}, {"Y", y}}));
  std::vector<std::string> top;
  for (const auto &[key, value] : j.items())
    top.push_back(key);
  CHECK(top == std::vector<std::string>{"kernel", "operands", "blades", "norm2", "separate"});
  static const std::vector<std::string> order = declared_order();
  std::vector<std::string> variables;
  for (const char *operand : {"X.", "Y."})
    for (const std::string &b : order)
      variables.push_back(operand + b);
  check_order(j.at("blades"), order);
  for (const auto &[blade, polynomial] : j.at("blades").items())
    for (const json &term : polynomial)
      check_order(term.at(1), variables);
  for (int round = 0; round < rounds; ++round) {
    const multivector a = g.element(x), b = g.element(y);
    values at;
    name_coefficients("X", a, at);
    name_coefficients("Y", b, at);
    const multivector want = g.algebra().meet(a, b);
    multivector have = g.algebra().zero();
    for (std::size_t mask = 0; mask < have.size(); ++mask)
      if (const auto it = j.at("blades").find(blade_name(mask)); it != j.at("blades").end())
        have[mask] = evaluate(*it, at);
    CHECK(have == want);
    CHECK(evaluate(j.at("norm2"), at) == oracle::scalar_part(g.algebra().geometric(want, want)));
  }
}

} // namespace

TEST_CASE("every pair with a meet, as JSON in the declared basis, is the dense product") {
  const compilation &c = default_scene();
  const std::vector<std::string> kinds = c.model->spec().kind_names();
  CHECK(kinds.size() == grades.size());
  geometry g(21);
  int pairs = 0;
  for (const std::string &x : kinds)
    for (const std::string &y : kinds) {
      INFO(x << ' ' << y);
      const std::string request = fmt::format("meet({}, {})", x, y);
      if (grades.at(x) + grades.at(y) >= 5) {
        check_pair(shown(c, compile_text(c, request), "json"), x, y, g, 6);
        ++pairs;
      } else {
        CHECK_THROWS_WITH(compile_text(c, request),
                          contains("is not defined here") && contains(fmt::format("grade(X) = {}", grades.at(x))));
      }
    }
  CHECK(pairs == 103);
}

TEST_CASE("the program prints the same, asked for by the scene or not, below grade 5 it says why") {
  geometry g(22);
  const std::string scene = '\'' + default_scene_path().string() + '\'';
  for (const auto &[x, y] : {std::pair("sphere", "line"), std::pair("triangle", "point"), std::pair("point", "sphere"),
                             std::pair("circle", "point_pair"), std::pair("plane", "sphere")}) {
    const outcome o = run_meetc(fmt::format("show {} meet {} {} --emit=json", scene, x, y), source_folder());
    REQUIRE(o.code == 0);
    CHECK(o.out == shown(default_scene(), compile_text(default_scene(), fmt::format("meet({}, {})", x, y)), "json"));
    check_pair(o.out, x, y, g, 3);
  }
  const outcome low = run_meetc(fmt::format("show {} meet point line --emit=json", scene), source_folder());
  CHECK(low.code == 2);
  CHECK(low.out.empty());
  CHECK(
      low.err.rfind("the command line:1:1: error: meet(point, line) is not defined here: grade(X) + grade(Y) >= 5 does "
                    "not hold, grade(X) = 1, grade(Y) = 3\n",
                    0) == 0);
}

TEST_CASE("the JSON of a predicate holds its atoms") {
  const json j = json::parse(shown(default_scene(), default_kernel("segment_triangle"), "json"));
  CHECK(j.at("atoms").at("reject").size() == 2);
  CHECK(j.at("atoms").at("common").size() == 3);
  CHECK(j.at("atoms").at("rare").size() == 45);
}

TEST_CASE("the LaTeX of a predicate is what was written, with short signs alone in full") {
  const std::string text = shown(default_scene(), default_kernel("segment_triangle"), "latex");
  CHECK_THAT(text, contains("\\texttt{sp} &= \\texttt{side(t, s.p)} \\\\\n") &&
                       contains("\\text{no, if} &\\ \\texttt{sp*sq > 0}") &&
                       contains("s_{0} &= \\texttt{side(t, s.p)}\\quad\\text{(24 terms)}") &&
                       contains("= \\texttt{s.p[e1] - t.a[e1]} =  \\mathit{s.p.x} -  \\mathit{t.a.x}"));
  CHECK(text.find("\\mathit{s.p.x} \\mathit{t.a.y} \\mathit{t.b.z}") == std::string::npos); // of the first sign
}

TEST_CASE("each stage can be shown of every kernel") {
  for (const lower::kernel *k : default_kernels(want::made_of_signs)) {
    CHECK_FALSE(shown(default_scene(), *k, "poly").empty());
    CHECK_FALSE(shown(default_scene(), *k, "latex").empty());
    CHECK_FALSE(shown(default_scene(), *k, "schedule").empty());
    CHECK_FALSE(shown(default_scene(), *k, "dag").empty());
  }
  const std::string scene = '\'' + default_scene_path().string() + '\'';
  for (const char *stage : {"spec", "poly", "separate", "dag", "schedule", "json", "latex", "cpp"})
    for (const char *what : {"meet sphere line", "segment_triangle", "side triangle point",
                             "-e 'norm2(meet(S, L))' --with 'S: sphere, L: line'"}) {
      INFO(stage << ' ' << what);
      const outcome o = run_meetc(fmt::format("show {} {} --emit={}", scene, what, stage), source_folder());
      CHECK(o.code == 0);
      CHECK_FALSE(o.out.empty());
      CHECK(o.err.empty());
    }
}
