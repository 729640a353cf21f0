#include "tests/paper/cga.hpp"

#include <bit>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace meetc::paper_test {

vec operator+(const vec &a, const vec &b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
vec operator-(const vec &a, const vec &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
vec operator*(const rational &k, const vec &a) {
  return {k * a[0], k * a[1], k * a[2]};
}
rational dot(const vec &a, const vec &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
vec cross(const vec &a, const vec &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

vec random_vec(random_numbers &r, int limit) {
  return {r.fraction(limit), r.fraction(limit), r.fraction(limit)};
}
vec lattice_vec(random_numbers &r, int limit) {
  return {r.integer(0, limit), r.integer(0, limit), r.integer(0, limit)};
}

const oracle::dense_algebra &algebra() {
  static const oracle::dense_algebra g = oracle::dense_algebra::diagonal({1, 1, 1, 1, -1});
  return g;
}

multivector operator+(const multivector &a, const multivector &b) {
  return oracle::add(a, b);
}
multivector operator-(const multivector &a, const multivector &b) {
  return oracle::subtract(a, b);
}
multivector operator*(const rational &k, const multivector &a) {
  return oracle::scale(k, a);
}
multivector operator*(const multivector &a, const multivector &b) {
  return algebra().geometric(a, b);
}

multivector outer(std::initializer_list<multivector> factors) {
  const multivector *first = factors.begin();
  multivector r = *first;
  for (const multivector *f = first + 1; f != factors.end(); ++f)
    r = oracle::outer(r, *f);
  return r;
}

const multivector &I() {
  static const multivector m = algebra().pseudoscalar();
  return m;
}
const multivector &n() {
  static const multivector m = algebra().vector(3) + algebra().vector(4);
  return m;
}
const multivector &nb() {
  static const multivector m = algebra().vector(3) - algebra().vector(4);
  return m;
}
multivector euclidean(const vec &a) {
  multivector m = algebra().zero();
  for (std::size_t i = 0; i < 3; ++i)
    m[std::size_t{1} << i] = a[i];
  return m;
}

multivector point(const vec &x) {
  return euclidean(rational(2) * x) + square(x) * n() - nb();
}
multivector point_pair(const vec &p, const vec &q) {
  return outer({point(p), point(q)});
}
multivector flat_point(const vec &p) {
  return outer({point(p), n()});
}
multivector line(const vec &p, const vec &q) {
  return outer({point(p), point(q), n()});
}
multivector circle(const vec &p, const vec &q, const vec &s) {
  return outer({point(p), point(q), point(s)});
}
multivector plane(const vec &p, const vec &q, const vec &s) {
  return outer({point(p), point(q), point(s), n()});
}
multivector sphere(const vec &p, const vec &q, const vec &s, const vec &t) {
  return outer({point(p), point(q), point(s), point(t)});
}
multivector centred_sphere(const vec &centre, const rational &squared_radius) {
  return rational(-1) * (I() * (point(centre) - squared_radius * n()));
}

multivector meet(const multivector &x, const multivector &y) {
  return algebra().meet(x, y);
}
rational norm2(const multivector &b) {
  return oracle::scalar_part(b * b);
}

rational coefficient(const multivector &b, const std::string &blade) {
  static const std::vector<std::string> names = {"e1", "e2", "e3", "e", "eb"};
  std::istringstream words(blade);
  std::size_t mask = 0;
  bool odd = false; // swaps that sort the names
  for (std::string word; words >> word;) {
    std::size_t i = 0;
    while (names.at(i) != word)
      ++i;
    if (mask >> i & 1)
      throw std::invalid_argument("a repeated vector in " + blade);
    odd ^= std::popcount(mask >> i) % 2 != 0;
    mask |= std::size_t{1} << i;
  }
  return odd ? rational(-b.at(mask)) : b.at(mask);
}

int nonzero_blades(const multivector &b) {
  int count = 0;
  for (const rational &c : b)
    count += c != 0;
  return count;
}

circle_shape circumcircle(const vec &p, const vec &q, const vec &s) {
  const vec a = q - p, b = s - p, normal = cross(a, b);
  const rational f = 1 / (2 * square(normal));
  const vec offset = f * cross(square(a) * b - square(b) * a, normal);
  return {p + offset, normal, square(offset)};
}

lattice_circle random_circle(random_numbers &r, int limit) {
  for (;;) {
    const vec p = lattice_vec(r, limit), q = lattice_vec(r, limit), s = lattice_vec(r, limit);
    if (!zero(cross(q - p, s - p)))
      return {p, q, s, circumcircle(p, q, s), circle(p, q, s)};
  }
}

} // namespace meetc::paper_test
