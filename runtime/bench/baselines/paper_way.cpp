#include "meet/bench/baselines/paper_way.hpp"

#include "meet/bench/baselines/vectors.hpp"

#include <array>

namespace meetc::bench {

namespace {

using vec = baselines::vec<float>;
using baselines::corner;

vec operator+(const vec &a, const vec &b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

// A vector of the algebra.
struct conformal {
  vec v;
  float e, eb;
};
float inner(const conformal &a, const conformal &b) {
  return dot(a.v, b.v) + a.e * b.e - a.eb * b.eb;
}
conformal round(const vec &c, float radius) { // a point where the radius is 0
  const float square = dot(c, c) - radius * radius;
  return {c + c, square - 1, square + 1};
}

struct line {
  vec v, m;
};
line through(const vec &p, const vec &q) {
  return {q - p, cross(p, q)};
}
float twist(const line &k, const line &l) {
  return dot(k.v, l.m) + dot(l.v, k.m);
}
conformal plane_through(const vec &a, const vec &b, const vec &c) {
  const float d = dot(a, cross(b, c));
  return {cross(a, b) + cross(b, c) + cross(c, a), d, d};
}

bool agree(const std::array<float, 3> &s) {
  return (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) || (s[0] <= 0 && s[1] <= 0 && s[2] <= 0);
}

// Algorithm 3, by equation (3.5): the meet of two spheres is a real circle.
bool spheres(const float *a, const float *b) {
  const conformal s = round(corner(a, 0), a[3]), t = round(corner(b, 0), b[3]);
  const float st = inner(s, t);
  return inner(s, s) * inner(t, t) - st * st >= 0;
}

struct facet {
  std::array<vec, 3> corners;
  conformal plane;
  std::array<line, 3> edge;
};
facet facet_of(const float *t) {
  const vec a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
  return {{a, b, c}, plane_through(a, b, c), {through(a, b), through(b, c), through(c, a)}};
}

// Algorithm 1.
bool crosses(const vec &p, const vec &q, const facet &t) {
  if (inner(t.plane, round(p, 0)) * inner(t.plane, round(q, 0)) > 0)
    return false;
  const line e = through(p, q);
  return agree({twist(e, t.edge[0]), twist(e, t.edge[1]), twist(e, t.edge[2])});
}
bool segment_and_triangle(const float *s, const float *t) {
  return crosses(corner(s, 0), corner(s, 1), facet_of(t));
}

// Algorithm 2.
bool triangles(const float *a, const float *b) {
  const facet s = facet_of(a), t = facet_of(b);
  for (std::size_t k = 0; k < 3; ++k)
    if (crosses(s.corners.at(k), s.corners.at((k + 1) % 3), t) ||
        crosses(t.corners.at(k), t.corners.at((k + 1) % 3), s))
      return true;
  return false;
}

template <bool (*Test)(const float *, const float *), int FieldsA, int FieldsB>
void decide(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] = Test(a.rows + std::size_t{pairs[i].a} * FieldsA, b.rows + std::size_t{pairs[i].b} * FieldsB) ? answer::yes
                                                                                                          : answer::no;
}

} // namespace

decide_function paper_way(std::string_view predicate) {
  if (predicate == "sphere_sphere")
    return decide<spheres, 4, 4>;
  if (predicate == "segment_triangle")
    return decide<segment_and_triangle, 6, 9>;
  if (predicate == "triangle_triangle")
    return decide<triangles, 9, 9>;
  return nullptr;
}

} // namespace meetc::bench
