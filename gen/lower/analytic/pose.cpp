// Poses: the factor between the translation of a versor and that of the points that it moves, V P ~V.
//
// A point of the algebra may be a vector, a trivector or a null vector, at any scale, and only those that V moves have a pose.
// So the factor is read off one exact product, and some exact products of rotations and translations are compared with the
// points that the matrix gives.
#include "gen/algebra/operators.hpp"
#include "gen/lower/analytic/analytic.hpp"
#include "gen/lower/expand/expand.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::lower {
namespace {

using units = std::array<std::optional<algebra::blade_term>, 8>;
using vector = std::array<rational, 3>;
using quaternion = std::array<rational, 8>;

class mover {
public:
  mover(const model &m, const lang::kind &point, const units &all)
      : model_(m), point_(point), units_(all), none_({}), expand_(m, none_, unused_) {}

  multivector point(const vector &x) {
    environment env;
    for (std::size_t i = 0; i < 3; ++i)
      env.emplace_back(point_.store[i].name, value{multivector(0, {none_, x[i]})});
    return expand_.evaluate_multivector(*point_.blade, env);
  }
  multivector versor(const quaternion &q) const {
    multivector out;
    for (std::size_t n = 0; n < 8; ++n)
      if (units_[n])
        out.add(units_[n]->at, {none_, q[n] * units_[n]->weight});
    return out;
  }
  multivector moved(const quaternion &q, const vector &x) {
    const multivector v = versor(q);
    return algebra::geometric(model_.working(), algebra::geometric(model_.working(), v, point(x)), algebra::reverse(v));
  }
  static rational at(const multivector &m, blade b) {
    const poly::poly *c = m.find(b);
    return c ? c->constant() : rational(0);
  }
  // The t for which a multivector is a multiple of the point at t along the first axis; nothing where no coefficients say.
  std::optional<rational> along(const multivector &v) {
    const multivector zero = point({0, 0, 0}), one = point({1, 0, 0}), other = point({-1, 0, 0});
    for (const auto &[i, unused] : zero.terms())
      for (const auto &[j, unused_too] : one.terms()) {
        const rational fixed = at(zero, i), from = at(zero, j), by = at(one, j) - from;
        if (at(one, i) == fixed && at(other, i) == fixed && by != 0 && at(other, j) == from - by && at(v, i) != 0)
          return (at(v, j) * fixed / at(v, i) - from) / by;
      }
    return std::nullopt;
  }
  static bool are_multiples(const multivector &v, const multivector &p) {
    for (const auto &[i, c] : p.terms())
      for (const auto &[j, d] : v.terms())
        if (at(v, i) * at(p, j) != at(v, j) * at(p, i))
          return false;
    return !v.is_zero();
  }

private:
  const model &model_;
  const lang::kind &point_;
  const units &units_;
  poly::ring none_;
  decision unused_;
  expander expand_;
};

vector cross(const vector &a, const vector &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// As meetc::pose_of does, in rationals.
vector image(const quaternion &q, const rational &shift, const vector &x) {
  const vector u{q[1], q[2], q[3]}, w{q[5], q[6], q[7]};
  const rational n = q[0] * q[0] + u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  const vector ux = cross(u, x), uux = cross(u, ux), uw = cross(u, w);
  vector out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = x[i] + (2 * (q[0] * ux[i] + uux[i]) + shift * (q[0] * w[i] - q[4] * u[i] + uw[i])) / n;
  return out;
}

// (s + u)(1 + J t): a rotation after a translation.
quaternion motion(const std::array<rational, 4> &r, const vector &t) {
  const vector u{r[1], r[2], r[3]}, ut = cross(u, t);
  quaternion q{r[0], r[1], r[2], r[3], -(u[0] * t[0] + u[1] * t[1] + u[2] * t[2])};
  for (std::size_t i = 0; i < 3; ++i)
    q[5 + i] = r[0] * t[i] + ut[i];
  return q;
}

} // namespace

rational pose_shift(const model &m, const lang::kind &k, const units &all, const location &where) {
  const auto point = std::find_if(m.spec().kinds.begin(), m.spec().kinds.end(),
                                  [](const lang::kind &p) { return p.position && p.store.size() == 3; });
  if (point == m.spec().kinds.end())
    throw spec_error(where,
                     fmt::format("'pose({})' needs a kind with 'position = true' and three numbers: the points that it "
                                 "moves",
                                 k.name));
  const auto refuse = [&] {
    throw spec_error(where,
                     fmt::format("'{0}' has no pose here: a versor V = {0} takes the blade of '{1}' to V {1} ~V, which "
                                 "is not the moved {1}",
                                 k.name, point->name));
  };
  if (!all[1] || !all[2] || !all[3])
    refuse();
  mover of(m, *point, all);
  rational shift = 0;
  if (all[5]) {
    const std::optional<rational> moved = of.along(of.moved(motion({1, 0, 0, 0}, {1, 0, 0}), {0, 0, 0}));
    if (!moved || *moved == 0)
      refuse();
    shift = *moved;
  }
  const rational far = all[5] ? 1 : 0;
  for (const auto &[r, t, x] :
       {std::tuple<std::array<rational, 4>, vector, vector>{{1, 0, 0, 0}, {2, -3, 5}, {1, 7, -2}},
        {{2, 1, 0, 0}, {0, 0, 0}, {3, 5, 7}},
        {{1, 2, -3, 5}, {7, -1, 4}, {-2, 3, 11}},
        {{0, 3, 1, -2}, {-5, 2, 3}, {4, -9, 6}}}) {
    const quaternion q = motion(r, {t[0] * far, t[1] * far, t[2] * far});
    if (!mover::are_multiples(of.moved(q, x), of.point(image(q, shift, x))))
      refuse();
  }
  return shift;
}

} // namespace meetc::lower
