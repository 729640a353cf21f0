// The geometry of a picture: elements as points, the projection, fitting, and a camera that faces the hits.
#include "meet/picture/projection.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace meetc::picture {

namespace detail {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

std::array<vec, 3> axes(const camera &from) {
  if (from.stands) {
    const vec back = normal(from.stands->eye - from.stands->target), right = normal(cross(from.stands->up, back));
    return {right, cross(back, right), back};
  }
  const double a = from.azimuth * degree, e = from.elevation * degree;
  const vec right{std::cos(a), 0, -std::sin(a)};
  const vec back{std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
  std::array<vec, 3> axis{right, cross(back, right), back};
  if (from.z_up)
    for (vec &v : axis)
      v = {v.x, -v.z, v.y};
  return axis;
}

struct box {
  vec low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  bool empty() const { return !(low.x <= high.x); }
  void add(const vec &p, double r) {
    low = {std::min(low.x, p.x - r), std::min(low.y, p.y - r), std::min(low.z, p.z - r)};
    high = {std::max(high.x, p.x + r), std::max(high.y, p.y + r), std::max(high.z, p.z + r)};
  }
};

// Calls f(point, radius) for every point of all elements, or only of the hit ones.
template <class F> void each_point(std::span<const shape> shapes, bool only_hits, F f) {
  for (const shape &s : shapes)
    for (std::size_t i = 0, n = elements(s); i < n; ++i) {
      if (only_hits && !is_hit(s, i))
        continue;
      const element e = element_at(s, i);
      for (int k = 0; k < e.n; ++k)
        f(e.point[static_cast<std::size_t>(k)], e.radius);
    }
}

} // namespace

projection look(std::span<const shape> shapes, const camera &from, int width, int height) {
  projection p;
  const double free_above = std::clamp(from.top, 0.0, 0.45) * height;
  p.half_width = width / 2.0;
  p.half_height = (height + free_above) / 2;
  p.perspective = from.perspective;
  if (from.stands && from.fit == framing::scene) {
    constexpr double half_angle = 15 * degree;
    const vec way = from.stands->eye - from.stands->target;
    p.axis = axes(from);
    p.centre = from.stands->target;
    p.unit = 1 / std::sqrt(dot(way, way));
    p.perspective = true;
    p.eye = p.focus = 1;
    p.half_height = height / 2.0;
    p.zoom = p.half_height / std::tan(half_angle);
    return p;
  }
  box all;
  each_point(shapes, false, [&](const vec &v, double r) { all.add(v, r); });
  if (!all.empty()) {
    p.centre = 0.5 * (all.low + all.high);
    const vec d = all.high - all.low;
    const double half_diagonal = 0.5 * std::sqrt(dot(d, d));
    p.unit = half_diagonal > 0 ? 1 / half_diagonal : 1;
  }
  p.axis = axes(from);

  const bool close_up = from.fit == framing::hits &&
                        std::any_of(shapes.begin(), shapes.end(), [](const shape &s) { return hits(s) > 0; });
  if (close_up) {
    box touched;
    each_point(shapes, true, [&](const vec &v, double r) { touched.add(v, r); });
    if (!touched.empty())
      p.target = p.to_camera(0.5 * (touched.low + touched.high));
  }
  p.eye = p.target.z + p.focus;

  double u0 = 1e300, u1 = -1e300, v0 = 1e300, v1 = -1e300;
  each_point(shapes, close_up, [&](const vec &point, double radius) {
    const vec c = p.to_camera(point);
    const auto [u, v] = p.flatten(c);
    const double r = radius * p.unit * p.shrink(c.z + radius * p.unit) * 1.02;
    u0 = std::min(u0, u - r);
    u1 = std::max(u1, u + r);
    v0 = std::min(v0, v - r);
    v1 = std::max(v1, v + r);
  });
  if (u0 <= u1) {
    p.u0 = (u0 + u1) / 2;
    p.v0 = (v0 + v1) / 2;
  } else {
    u0 = v0 = -1;
    u1 = v1 = 1;
  }
  // A close-up includes some surroundings, and never shows less than float32 coordinates can resolve.
  const double around = close_up ? 1.15 : 1, least = close_up ? 1e-4 : 1e-6;
  const double left = 1 - 2 * std::clamp(from.margin, 0.0, 0.45);
  p.zoom = left / from.distance *
           std::min(width / std::max(around * (u1 - u0), least),
                    (height - free_above) / std::max(around * (v1 - v0), least));
  return p;
}

vec projection::to_camera(const vec &world) const {
  const vec d = unit * (world - centre);
  return {dot(axis[0], d), dot(axis[1], d), dot(axis[2], d)};
}

std::array<double, 2> projection::flatten(const vec &c) const {
  const double s = shrink(c.z);
  return {(c.x - target.x) * s, (c.y - target.y) * s};
}

screen_point projection::to_screen(const vec &c) const {
  const auto [u, v] = flatten(c);
  return {(u - u0) * zoom + half_width, half_height - (v - v0) * zoom, nearness(c.z)};
}

element element_at(const shape &s, std::size_t i) {
  element e{{}, 0, 0};
  const auto point = [&](std::size_t first) { return vec{s.rows[first], s.rows[first + 1], s.rows[first + 2]}; };
  if (s.what == form::spheres) {
    e.point[0] = point(4 * i);
    e.radius = std::abs(static_cast<double>(s.rows[4 * i + 3]));
    e.n = 1;
  } else if (s.what == form::segments) {
    e.point = {point(6 * i), point(6 * i + 3), vec{}};
    e.n = 2;
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = s.index.empty() ? 3 * i + k : s.index[3 * i + k];
      if (v >= s.rows.size() / 3)
        return e;
      e.point[k] = point(3 * v);
    }
    e.n = 3;
  }
  double sum = e.radius;
  for (const vec &v : e.point)
    sum += std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  if (!std::isfinite(sum))
    e.n = 0;
  return e;
}

} // namespace detail

camera facing_hits(std::span<const shape> shapes, camera from) {
  using namespace detail;
  const vec given = axes(from)[2];
  from.stands.reset();
  std::vector<vec> facets; // normals; their length is twice the area, in the scene scaled to diagonal 1
  box all, touched;
  each_point(shapes, false, [&](const vec &v, double r) { all.add(v, r); });
  each_point(shapes, true, [&](const vec &v, double r) { touched.add(v, r); });
  const vec extent = all.high - all.low;
  const double size = std::sqrt(dot(extent, extent));
  if (all.empty() || touched.empty() || !(size > 0))
    return from;
  for (const shape &s : shapes)
    for (std::size_t i = 0; i < elements(s); ++i)
      if (const element e = element_at(s, i); is_hit(s, i) && e.n == 3)
        facets.push_back(cross((1 / size) * (e.point[1] - e.point[0]), (1 / size) * (e.point[2] - e.point[0])));
  // A body hides the hits on its far side, so the camera prefers the side on which the hits lie.
  vec side = (0.5 / size) * (touched.low + touched.high - all.low - all.high);
  const double aside = std::sqrt(dot(side, side));
  side = aside > 0.05 ? (0.5 / aside) * side : vec{};
  camera best = from;
  double most = 0;
  for (const double elevation : {from.elevation, from.elevation - 30, from.elevation + 30})
    for (int turned = 0; turned < 360; turned += 15) {
      camera v = from;
      v.azimuth += turned;
      v.elevation = std::clamp(elevation, -40.0, 70.0);
      const vec to_eye = axes(v)[2];
      double seen = 0;
      for (const vec &f : facets)
        seen += std::max(0.0, dot(f, to_eye));
      seen *= 1 + dot(side, to_eye) + 0.15 * dot(given, to_eye); // prefers the smaller turn
      if (seen > most) {
        most = seen;
        best = v;
      }
    }
  return best;
}

} // namespace meetc::picture
