// Step 1 of the proof: each emitted atom is the stated polynomial in inner products, and those have the meaning for
// vectors that the proof states. All is expanded over the rationals; nothing is sampled.
#include "tests/catch.hpp"
#include "tests/decisions/round/decision.hpp"

using namespace meetc;
using namespace meetc::decisions_round;

namespace {

std::vector<polynomial> stated_atoms(const emitted &e) {
  return e.value ? std::vector<polynomial>{stated_side()} : stated(e).atoms;
}

// The stored numbers of a ball and a triangle, and a point's parameters.
struct triangle_vectors {
  const poly::ring stored;
  std::vector<polynomial> images;
  vector3 w, d1, d2, d3, normal, from_b;

  triangle_vectors()
      : stored([] {
          std::vector<std::string> names = row_names(emitted_predicate("ball_triangle"));
          names.emplace_back("s");
          names.emplace_back("t");
          return names;
        }()) {
    const gram &g = gram::ring();
    images = g.images(emitted_predicate("ball_triangle"), stored);
    for (const char *unknown : {"s", "t"})
      images[static_cast<std::size_t>(g.numbers.find(unknown))] = parameter(unknown);
    const vector3 centre = stored_point(stored, 0), a = stored_point(stored, 4), b = stored_point(stored, 7),
                  c = stored_point(stored, 10);
    w = minus(centre, a), d1 = minus(b, a), d2 = minus(c, a), d3 = minus(c, b), normal = cross(d1, d2);
    from_b = minus(centre, b);
  }
  polynomial parameter(const char *name) const { return polynomial::variable(stored, stored.find(name)); }
  polynomial of(const polynomial &p) const { return p.substitute(images, stored); }
  vector3 times(const polynomial &k, const vector3 &u) const { return {k * u[0], k * u[1], k * u[2]}; }
};

} // namespace

TEST_CASE("every emitted atom is the stated polynomial in inner products") {
  const gram &g = gram::ring();
  int atoms = 0;
  for (const emitted &e : emitted_predicates()) {
    INFO(e.name);
    const poly::ring stored(row_names(e));
    const std::vector<polynomial> images = g.images(e, stored), emits = e.polynomials(stored), stated = stated_atoms(e);
    REQUIRE(emits.size() == stated.size());
    for (std::size_t i = 0; i < emits.size(); ++i) {
      INFO("atom " << i << ", " << stated[i].text());
      CHECK(g.of_operands(stated[i]));
      CHECK(emits[i] == stated[i].substitute(images, stored));
      ++atoms;
    }
  }
  CHECK(atoms == 1 + 2 + 5 + 5 + 16 + 16 + 1);
}

TEST_CASE("a stated polynomial with one mistake is not the emitted one") {
  int seen = 0;
  for (const mutant &m : mutants()) {
    const emitted &e = emitted_predicate(m.of);
    if (m.wrong.atoms == stated(e).atoms)
      continue; // the mistake is in the function of signs, not in an atom
    INFO(m.of << ": " << m.what);
    const poly::ring stored(row_names(e));
    const std::vector<polynomial> images = gram::ring().images(e, stored), emits = e.polynomials(stored);
    bool same = true;
    for (std::size_t i = 0; i < emits.size(); ++i)
      same = same && emits[i] == m.wrong.atoms[i].substitute(images, stored);
    CHECK_FALSE(same);
    ++seen;
  }
  CHECK(seen == 4);
}

TEST_CASE("the bytecode for wide integers computes the same polynomials") {
  for (const emitted &e : emitted_predicates()) {
    INFO(e.name);
    const poly::ring stored(row_names(e));
    CHECK(e.step_polynomials(stored) == e.polynomials(stored));
  }
}

TEST_CASE("the polynomials in inner products have the meaning for vectors that the proof states") {
  const gram &g = gram::ring();
  const triangle_vectors v;
  // These are squared lengths, so none is negative.
  CHECK(v.of(g.ww) == dot(v.w, v.w));
  CHECK(v.of(g.g11) == dot(v.d1, v.d1));
  CHECK(v.of(g.g22) == dot(v.d2, v.d2));
  CHECK(v.of(g.g33) == dot(v.d3, v.d3));
  CHECK(v.of(g.area) == dot(v.normal, v.normal));
  CHECK(v.of(g.wb) == dot(v.from_b, v.from_b));
  // An edge from b to c.
  CHECK(v.of(g.w3) == dot(v.from_b, v.d3));
  // The squared distance of the centre from a point of the triangle.
  const polynomial s = v.parameter("s"), t = v.parameter("t");
  const vector3 to = minus(minus(v.w, v.times(s, v.d1)), v.times(t, v.d2));
  CHECK(v.of(g.reach(g.s, g.t)) == dot(to, to));
  CHECK(v.of(g.volume) == square(dot(v.w, v.normal)));
  // A triangle without area: g11 d2 = g12 d1.
  const vector3 rest = minus(v.times(v.of(g.g11), v.d2), v.times(v.of(g.g12), v.d1));
  CHECK(dot(rest, rest) == v.of(g.g11 * g.area));
}

TEST_CASE("edges, corners and the foot of the perpendicular are those of the triangle") {
  const gram &g = gram::ring();
  const auto edge = [&](const polynomial &A, const polynomial &B, const polynomial &C) {
    return A - 2 * (g.s * B) + g.s * g.s * C;
  };
  CHECK(edge(g.ww, g.w1, g.g11) == g.reach(g.s, g.zero));
  CHECK(edge(g.ww, g.w2, g.g22) == g.reach(g.zero, g.s));
  CHECK(edge(g.wb, g.w3, g.g33) == g.reach(g.one - g.s, g.s));
  CHECK(g.reach(g.zero, g.zero) == g.ww);
  CHECK(g.reach(g.one, g.zero) == g.wb);
  CHECK(g.reach(g.zero, g.one) == g.wc);
  CHECK(g.ma + g.mb + g.mc == g.area);
  // w minus the foot is at right angles to both edges; all times the squared area.
  CHECK(g.area * g.w1 == g.mb * g.g11 + g.mc * g.g12);
  CHECK(g.area * g.w2 == g.mb * g.g12 + g.mc * g.g22);
}
