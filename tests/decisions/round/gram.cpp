#include "tests/decisions/round/gram.hpp"

namespace meetc::decisions_round {

gram::gram()
    : numbers({"ww", "w1", "w2", "g11", "g12", "g22", "R", "dd", "d", "r1", "r2", "s", "t", "tau", "l1", "l2"}),
      zero(numbers), one(numbers, 1), ww(variable("ww")), w1(variable("w1")), w2(variable("w2")), g11(variable("g11")),
      g12(variable("g12")), g22(variable("g22")), R(variable("R")), dd(variable("dd")), d(variable("d")),
      r1(variable("r1")), r2(variable("r2")), s(variable("s")), t(variable("t")), tau(variable("tau")),
      l1(variable("l1")), l2(variable("l2")), wb(ww - 2 * w1 + g11), wc(ww - 2 * w2 + g22), w3(w2 - w1 - g12 + g11),
      g33(g11 - 2 * g12 + g22), area(g11 * g22 - g12 * g12), ma(area - (w1 * g22 - w2 * g12) - (w2 * g11 - w1 * g12)),
      mb(w1 * g22 - w2 * g12), mc(w2 * g11 - w1 * g12), volume(ww * area - w1 * mb - w2 * mc) {}

const gram &gram::ring() {
  static const gram only;
  return only;
}

polynomial gram::variable(const char *name) const {
  return polynomial::variable(numbers, numbers.find(name));
}

polynomial gram::length(const polynomial &u, const polynomial &v) const {
  return g11 * u * u + 2 * (g12 * u * v) + g22 * v * v;
}
polynomial gram::reach(const polynomial &at_s, const polynomial &at_t) const {
  return ww - 2 * (at_s * w1) - 2 * (at_t * w2) + length(at_s, at_t);
}

bool gram::of_operands(const polynomial &p) const {
  for (const int v : p.variables())
    for (const char *unknown : {"d", "s", "t", "tau", "l1", "l2"})
      if (numbers.name(v) == unknown)
        return false;
  return true;
}

std::vector<polynomial> gram::images(const emitted &e, const poly::ring &stored) const {
  std::vector<polynomial> out(static_cast<std::size_t>(numbers.size()), polynomial(stored));
  const auto set = [&](const char *name, const polynomial &p) {
    out[static_cast<std::size_t>(numbers.find(name))] = p;
  };
  const auto real = [&](int v) { return polynomial::variable(stored, v); };
  const int second = e.inputs_a;
  const vector3 w = minus(stored_point(stored, 0), stored_point(stored, second));
  set("ww", dot(w, w));
  set("dd", dot(w, w));
  set("R", real(3) * real(3));
  set("r1", real(3));
  if (e.second == other::sphere)
    set("r2", real(second + 3));
  if (e.second == other::segment || e.second == other::triangle) {
    const vector3 d1 = minus(stored_point(stored, second + 3), stored_point(stored, second));
    set("w1", dot(w, d1));
    set("g11", dot(d1, d1));
    if (e.second == other::triangle) {
      const vector3 d2 = minus(stored_point(stored, second + 6), stored_point(stored, second));
      set("w2", dot(w, d2));
      set("g12", dot(d1, d2));
      set("g22", dot(d2, d2));
    }
  }
  return out;
}

polynomial dot(const vector3 &u, const vector3 &v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
vector3 cross(const vector3 &u, const vector3 &v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
vector3 minus(const vector3 &u, const vector3 &v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}
vector3 stored_point(const poly::ring &stored, int first) {
  return {polynomial::variable(stored, first), polynomial::variable(stored, first + 1),
          polynomial::variable(stored, first + 2)};
}

} // namespace meetc::decisions_round
