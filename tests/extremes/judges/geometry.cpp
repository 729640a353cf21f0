#include "tests/extremes/judges/geometry.hpp"

#include "tests/generated/judge/judge.hpp"

namespace meetc::extremes_test {
namespace {

using vec = std::array<mpq_class, 3>;
vec difference(const row &x, std::size_t i, const row &y, std::size_t j) {
  vec out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = mpq_class(static_cast<double>(x[3 * i + k])) - mpq_class(static_cast<double>(y[3 * j + k]));
  return out;
}
mpq_class determinant(const vec &a, const vec &b, const vec &c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// As in algebra_spec/cga3.toml: + inside a sphere; [b-a, c-a, p-a]; [p2-p1, v1, v2].
int value_sign(const subject &s, const pair_of_rows &p) {
  const vec between = difference(p.b, 0, p.a, 0);
  if (generated_test::padded(s.a)) {
    const mpq_class r(static_cast<double>(p.a[3]));
    return sgn(mpq_class(r * r - between[0] * between[0] - between[1] * between[1] - between[2] * between[2]));
  }
  const vec u = difference(p.a, 1, p.a, 0);
  return s.a == shape::triangle ? sgn(determinant(u, difference(p.a, 2, p.a, 0), between))
                                : sgn(determinant(between, u, difference(p.b, 1, p.b, 0)));
}

} // namespace

int truth_by_geometry(const subject &s, const pair_of_rows &p) {
  return s.sign ? value_sign(s, p) : generated_test::touching(s.a, p.a, s.b, p.b, s.surface);
}

} // namespace meetc::extremes_test
