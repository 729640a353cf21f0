// Triangles are drawn by edge functions, spheres by one ray for each sample, segments as lines shaded like tubes. All
// arithmetic is in double, and is clipped before any conversion to int.
#include "meet/picture/raster.hpp"

#include <algorithm>
#include <cmath>

namespace meetc::picture::detail {
namespace {

std::uint32_t pack(const vec &n, std::size_t number, bool edge) {
  const auto twelve = [](double v) {
    return static_cast<std::uint32_t>(std::clamp((v + 1) * 2047.5 + 0.5, 0.0, 4095.0));
  };
  return twelve(n.x) << 20 | twelve(n.y) << 8 | static_cast<std::uint32_t>(edge) << 6 |
         static_cast<std::uint32_t>(number + 1);
}

// Tested before shading, which takes most of the time.
bool nearer(const layer &l, int x, int y, double near) {
  return static_cast<float>(near) >
         l.at[static_cast<std::size_t>(y) * static_cast<std::size_t>(l.width) + static_cast<std::size_t>(x)].near;
}

void put_nearer(layer &l, int x, int y, double near, std::uint32_t bits) {
  sample &s = l.at[static_cast<std::size_t>(y) * static_cast<std::size_t>(l.width) + static_cast<std::size_t>(x)];
  if (static_cast<float>(near) > s.near)
    s = {static_cast<float>(near), bits};
}

// Finds the samples whose centres (i + 1/2) lie in [low, high], clipped to 0..size-1. Returns false where there are
// none.
bool covered(double low, double high, int size, int &first, int &last) {
  if (!(high >= 0 && low <= size))
    return false;
  first = static_cast<int>(std::max(std::ceil(low - 0.5), 0.0));
  last = static_cast<int>(std::min(std::floor(high - 0.5), size - 1.0));
  return first <= last;
}

struct corner {
  screen_point at;
  vec normal;
};

void fill(layer &l, const std::array<corner, 3> &c, std::size_t number, double pixel, bool wire) {
  const screen_point &a = c[0].at, &b = c[1].at, &d = c[2].at;
  const double area = (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x);
  int x0, x1, y0, y1;
  if (area == 0 || !std::isfinite(1 / area) ||
      !covered(std::min({a.x, b.x, d.x}), std::max({a.x, b.x, d.x}), l.width, x0, x1) ||
      !covered(std::min({a.y, b.y, d.y}), std::max({a.y, b.y, d.y}), l.height, y0, y1))
    return;
  // The weight of each corner at a sample, and the height of each corner in samples above the opposite edge.
  std::array<double, 3> dx, dy, start, height;
  double least = 1e300;
  for (std::size_t i = 0; i < 3; ++i) {
    const screen_point &p = c[(i + 1) % 3].at, &q = c[(i + 2) % 3].at;
    dx[i] = (p.y - q.y) / area;
    dy[i] = (q.x - p.x) / area;
    start[i] = (x0 + 0.5 - p.x) * dx[i] + (y0 + 0.5 - p.y) * dy[i];
    height[i] = 1 / std::sqrt(dx[i] * dx[i] + dy[i] * dy[i]);
    least = std::min(least, height[i]);
  }
  const bool edges = wire && least > 3 * pixel;
  for (int y = y0; y <= y1; ++y) {
    // The part of the row in which all weights can be positive, widened by one sample, so that slivers cost only their
    // own area.
    double low = x0, high = x1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double zero = x0 - (start[i] + (y - y0) * dy[i]) / dx[i];
      if (dx[i] > 0)
        low = std::max(low, zero - 1);
      else if (dx[i] < 0)
        high = std::min(high, zero + 1);
    }
    if (!(low <= high))
      continue;
    const int row_end = static_cast<int>(std::floor(high));
    for (int x = static_cast<int>(std::ceil(low)); x <= row_end; ++x) {
      std::array<double, 3> w;
      for (std::size_t i = 0; i < 3; ++i)
        w[i] = start[i] + (x - x0) * dx[i] + (y - y0) * dy[i];
      if (!(w[0] >= 0 && w[1] >= 0 && w[2] >= 0))
        continue;
      const double near = w[0] * a.near + w[1] * b.near + w[2] * d.near;
      if (!nearer(l, x, y, near))
        continue;
      const vec n = w[0] * c[0].normal + w[1] * c[1].normal + w[2] * c[2].normal;
      const double length = std::sqrt(dot(n, n));
      const bool edge = edges && std::min({w[0] * height[0], w[1] * height[1], w[2] * height[2]}) < 0.5 * pixel;
      put_nearer(l, x, y, near, pack((1 / std::max(length, 1e-30)) * n, number, edge));
    }
  }
}

// A line that extends `half` samples to each side. round: it is shaded as a tube, otherwise with the normal n.
void line(layer &l, const screen_point &a, const screen_point &b, double half, std::size_t number, bool round,
          const vec &n) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  const bool steep = std::abs(dy) > std::abs(dx);
  // Steps along the major axis p, with spans across along the minor axis q.
  const double p0 = steep ? a.y : a.x, p1 = steep ? b.y : b.x, q0 = steep ? a.x : a.y, q1 = steep ? b.x : b.y;
  const double across = length > 0 ? half * length / std::max(std::abs(dx), std::abs(dy)) : half;
  int first, last;
  if (!std::isfinite(length) ||
      !covered(std::min(p0, p1) - half, std::max(p0, p1) + half, steep ? l.height : l.width, first, last))
    return;
  for (int p = first; p <= last; ++p) {
    const double t = p1 != p0 ? std::clamp((p + 0.5 - p0) / (p1 - p0), 0.0, 1.0) : 0;
    const double q = q0 + t * (q1 - q0), near = a.near + t * (b.near - a.near);
    int low, high;
    if (!covered(q - across, q + across, steep ? l.width : l.height, low, high))
      continue;
    for (int i = low; i <= high; ++i) {
      vec normal_here = n;
      if (round && length > 0) {
        const double sense = steep ? (dy > 0 ? -1 : 1) : (dx > 0 ? 1 : -1); // 1: i grows to the right of a to b
        const double s = sense * std::clamp((i + 0.5 - q) / across, -1.0, 1.0);
        normal_here = {-s * dy / length, -s * dx / length, 0};
      }
      put_nearer(l, steep ? i : p, steep ? p : i, near, pack(normal_here, number, false));
    }
  }
}

void ball(layer &l, const projection &p, const vec &c, double r, std::size_t number) {
  const double near_shrink = p.shrink(c.z + r), far_shrink = p.shrink(c.z - r);
  const auto range = [&](double v, double &low, double &high) {
    low = std::min((v - r) * near_shrink, (v - r) * far_shrink);
    high = std::max((v + r) * near_shrink, (v + r) * far_shrink);
  };
  double u0, u1, v0, v1;
  range(c.x - p.target.x, u0, u1);
  range(c.y - p.target.y, v0, v1);
  int x0, x1, y0, y1;
  if (!covered((u0 - p.u0) * p.zoom + p.half_width - 1, (u1 - p.u0) * p.zoom + p.half_width + 1, l.width, x0, x1) ||
      !covered(p.half_height - (v1 - p.v0) * p.zoom - 1, p.half_height - (v0 - p.v0) * p.zoom + 1, l.height, y0, y1))
    return;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const double u = (x + 0.5 - p.half_width) / p.zoom + p.u0, v = (p.half_height - y - 0.5) / p.zoom + p.v0;
      // A ray from the eye, or parallel to z from a plane in front of everything.
      const vec from = p.perspective ? vec{p.target.x, p.target.y, p.eye} : vec{p.target.x + u, p.target.y + v, p.eye};
      const vec way = p.perspective ? normal({u, v, -p.focus}) : vec{0, 0, -1};
      const vec m = c - from;
      const double along = dot(m, way);
      const vec off = m - along * way; // from the point of the ray nearest to the centre
      const double rest = r * r - dot(off, off);
      if (rest < 0)
        continue;
      const vec hit_point = from + (along - std::sqrt(rest)) * way;
      put_nearer(l, x, y, p.nearness(hit_point.z), pack((1 / r) * (hit_point - c), number, false));
    }
}

// Normals of faces and of corners. A corner's is the mean over the faces around the vertex that lie within 40 degrees,
// so that creases stay sharp. Without an index every triangle stands alone.
class normals {
public:
  normals(const shape &s, const projection &p, bool smooth) : index_(s.index), faces_(elements(s), vec{}) {
    if (smooth)
      first_.resize(s.index.empty() ? 0 : s.rows.size() / 3 + 1);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const element e = element_at(s, i);
      if (e.n == 0)
        continue;
      const vec a = p.to_camera(e.point[0]);
      const vec face = cross(p.to_camera(e.point[1]) - a, p.to_camera(e.point[2]) - a);
      faces_[i] = (1 / std::max(std::sqrt(dot(face, face)), 1e-150)) * face;
      for (std::size_t k = 0; k < 3 && !first_.empty(); ++k)
        ++first_[index_[3 * i + k]];
    }
    if (first_.empty())
      return;
    std::uint32_t sum = 0; // counting sort of the faces by vertex; afterwards the faces of v begin at first_[v]
    for (std::uint32_t &n : first_)
      n = sum += n;
    around_.resize(sum);
    for (std::size_t i = faces_.size(); i-- > 0;)
      for (std::size_t k = 0; k < 3 && element_at(s, i).n != 0; ++k)
        around_[--first_[index_[3 * i + k]]] = static_cast<std::uint32_t>(i);
  }
  const vec &face(std::size_t i) const { return faces_[i]; }
  vec corner(std::size_t i, std::size_t k) const {
    if (first_.empty())
      return faces_[i];
    // A vertex with very many faces is the tip of a cone, which has no normal, and the sum would be computed for each
    // face.
    if (first_[index_[3 * i + k] + std::size_t{1}] - first_[index_[3 * i + k]] > 64)
      return faces_[i];
    vec sum{};
    for (std::size_t at = first_[index_[3 * i + k]]; at < first_[index_[3 * i + k] + std::size_t{1}]; ++at)
      if (dot(faces_[around_[at]], faces_[i]) > 0.766)
        sum = sum + faces_[around_[at]];
    return (1 / std::max(std::sqrt(dot(sum, sum)), 1e-150)) * sum;
  }

private:
  std::span<const std::uint32_t> index_;
  std::vector<vec> faces_;
  std::vector<std::uint32_t> first_, around_;
};

// Whether the triangles are large enough in the picture, at 150 square pixels, for their edges to be drawn.
bool large_triangles(const shape &s, const projection &p, double pixel) {
  double sum = 0;
  for (std::size_t i = 0; i < elements(s); ++i) {
    const element e = element_at(s, i);
    const vec a = p.to_camera(e.point[0]), n = cross(p.to_camera(e.point[1]) - a, p.to_camera(e.point[2]) - a);
    sum += e.n == 0 ? 0 : std::sqrt(dot(n, n)) / 2;
  }
  return sum * p.zoom * p.zoom > 150 * pixel * pixel * static_cast<double>(elements(s));
}

// A triangle's part before the eye, as a convex polygon.
struct part {
  std::array<corner, 4> at;
  std::size_t n = 0;
};

part before_eye(const projection &p, const std::array<vec, 3> &point, const std::array<vec, 3> &normal) {
  part out;
  const double limit = p.nearest();
  for (std::size_t k = 0; k < 3; ++k) {
    const vec &a = point[k], &b = point[(k + 1) % 3];
    if (a.z <= limit)
      out.at[out.n++] = {p.to_screen(a), normal[k]};
    if ((a.z <= limit) != (b.z <= limit)) {
      const double t = (limit - a.z) / (b.z - a.z);
      out.at[out.n++] = {p.to_screen({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), limit}),
                         (1 - t) * normal[k] + t * normal[(k + 1) % 3]};
    }
  }
  return out;
}

// Moves the end that is not seen to where the segment is. Returns false where none of it is.
bool clip(const projection &p, vec &a, vec &b) {
  const double limit = p.nearest();
  for (vec *const end : {&a, &b})
    if (const vec &other = end == &a ? b : a; end->z > limit) {
      if (other.z > limit)
        return false;
      *end = *end + ((limit - end->z) / (other.z - end->z)) * (other - *end);
      end->z = limit;
    }
  return true;
}

void draw_triangles(const shape &s, std::size_t number, const projection &p, bool smooth, double pixel, layer &surface,
                    layer &marked) {
  const normals normal_of(s, p, smooth);
  const bool wire = large_triangles(s, p, pixel);
  for (std::size_t i = 0; i < elements(s); ++i) {
    const element e = element_at(s, i);
    if (e.n == 0)
      continue;
    std::array<vec, 3> point, normal;
    for (std::size_t k = 0; k < 3; ++k)
      point[k] = p.to_camera(e.point[k]);
    part seen = before_eye(p, point, {});
    double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
    for (std::size_t k = 0; k < seen.n; ++k) {
      low_x = std::min(low_x, seen.at[k].at.x), high_x = std::max(high_x, seen.at[k].at.x);
      low_y = std::min(low_y, seen.at[k].at.y), high_y = std::max(high_y, seen.at[k].at.y);
    }
    if (!(high_x >= -1 && low_x <= surface.width + 1 && high_y >= -1 && low_y <= surface.height + 1))
      continue;
    const auto [q, r, t] = std::array{seen.at[0].at, seen.at[1].at, seen.at[2].at};
    const bool away = (r.x - q.x) * (t.y - q.y) - (r.y - q.y) * (t.x - q.x) > 0;
    for (std::size_t k = 0; k < 3; ++k) // both sides are lit
      normal[k] = (away ? -1.0 : 1.0) * normal_of.corner(i, k);
    seen = before_eye(p, point, normal);
    for (std::size_t k = 2; k < seen.n; ++k) {
      const std::array<corner, 3> c{seen.at[0], seen.at[k - 1], seen.at[k]};
      fill(surface, c, number, pixel, wire);
      if (is_hit(s, i))
        fill(marked, c, number, pixel, wire);
    }
    for (std::size_t k = 0; is_hit(s, i) && k < seen.n;
         ++k) // needles and triangles between two samples leave a mark as well
      line(marked, seen.at[k].at, seen.at[(k + 1) % seen.n].at, 0.5, number, false, seen.at[k].normal);
  }
}

} // namespace

vec sample::direction() const {
  const double x = (bits >> 20) / 2047.5 - 1, y = (bits >> 8 & 4095) / 2047.5 - 1;
  return {x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))};
}

void draw(const shape &s, std::size_t number, const projection &p, const camera &from, double pixel, layer &surface,
          layer &marked) {
  if (s.what == form::triangles) {
    draw_triangles(s, number, p, from.smooth, pixel, surface, marked);
    return;
  }
  const std::size_t n = elements(s);
  for (std::size_t i = 0; i < n; ++i) {
    const element e = element_at(s, i);
    if (e.n == 0)
      continue;
    vec a = p.to_camera(e.point[0]), b = p.to_camera(e.point[s.what == form::segments ? 1 : 0]);
    if (s.what == form::segments ? !clip(p, a, b) : a.z + e.radius * p.unit > p.nearest())
      continue;
    for (layer *l : {&surface, &marked}) {
      if (l == &marked && !is_hit(s, i))
        continue;
      if (s.what == form::segments) {
        line(*l, p.to_screen(a), p.to_screen(b), 1.1 * pixel, number, true, {0, 0, 1});
        continue;
      }
      // A ball smaller than a pixel is drawn with that size, so that it does not fall between samples.
      ball(*l, p, a, std::max(e.radius * p.unit, 0.6 * pixel / (p.zoom * p.shrink(a.z))), number);
    }
  }
}

} // namespace meetc::picture::detail
