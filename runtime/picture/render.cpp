// The light, and the composition of surfaces and hits in one picture. See render.hpp.
#include "meet/picture/render.hpp"

#include "meet/picture/raster.hpp"

#include <algorithm>
#include <cmath>

namespace meetc::picture {
namespace {

using namespace detail;

struct light {
  double r, g, b;
};
light operator*(double s, const light &c) {
  return {s * c.r, s * c.g, s * c.b};
}
light mix(const light &a, const light &b, double t) {
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}
light light_of(colour c) {
  return {double(c.r), double(c.g), double(c.b)};
}

// A soft key light from the upper left, a weak fill light from the right, and a sky that is brighter than the ground.
light shade(const sample &s, colour c, bool bright) {
  static const vec key = normal({-0.45, 0.62, 0.65}), fill = normal({0.8, 0.05, 0.45}),
                   glance = normal({-0.45, 0.62, 1.65});
  const vec n = s.direction();
  const double diffuse = 0.60 * std::max(0.0, dot(n, key)) + 0.20 * std::max(0.0, dot(n, fill));
  const double sky = 0.36 + 0.08 * n.y;
  const double gloss = std::pow(std::max(0.0, dot(n, glance)), 24) * 0.14;
  // Hits keep the brightness of their colours, which matter more than their shading.
  const double lit = bright ? 0.60 + 0.45 * (diffuse + sky) : diffuse + sky;
  light v = mix(lit * light_of(c), {255, 255, 255}, bright ? gloss / 2 : gloss);
  if (s.edge())
    v = (bright ? 0.62 : 0.86) * v;
  return v;
}

// Whether there is a step in depth between a sample and its right or lower neighbour, or a sharp valley. Such samples
// are drawn darker, which separates spheres and limbs of one colour.
bool step_at(const layer &l, std::size_t i, std::size_t other, double unit) {
  const sample &a = l.at[i], &b = l.at[other];
  if (a.empty() || b.empty())
    return a.empty() != b.empty();
  const vec m = a.direction(), n = b.direction();
  return dot(m, n) < 0.6 || std::abs(a.near - b.near) > 3 * unit / std::max(0.2, std::min(m.z, n.z));
}

// For each sample, the nearest drawn hit sample within `reach`. Squared distance 255: there is none.
struct neighbourhood {
  std::vector<std::uint8_t> squared;
  std::vector<std::uint32_t> source;
};

neighbourhood widen(const std::vector<std::uint8_t> &drawn, int width, int height, int reach) {
  neighbourhood near{std::vector<std::uint8_t>(drawn.size(), 255), std::vector<std::uint32_t>(drawn.size())};
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (!drawn[at(x, y)])
        continue;
      near.squared[at(x, y)] = 0;
      near.source[at(x, y)] = static_cast<std::uint32_t>(at(x, y));
      if (x > 0 && y > 0 && x + 1 < width && y + 1 < height && drawn[at(x - 1, y)] && drawn[at(x + 1, y)] &&
          drawn[at(x, y - 1)] && drawn[at(x, y + 1)])
        continue; // inside the area there is nothing to widen
      for (int v = std::max(0, y - reach); v <= std::min(height - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(width - 1, x + reach); ++u) {
          const int d = (u - x) * (u - x) + (v - y) * (v - y);
          if (d <= reach * reach && d < near.squared[at(u, v)]) {
            near.squared[at(u, v)] = static_cast<std::uint8_t>(d);
            near.source[at(u, v)] = static_cast<std::uint32_t>(at(x, y));
          }
        }
    }
  return near;
}

} // namespace

image render(std::span<const shape> all_shapes, const camera &from, int width, int height) {
  const std::span<const shape> shapes = all_shapes.first(std::min<std::size_t>(all_shapes.size(), 63));
  image out{std::clamp(width, 16, 8192), std::clamp(height, 16, 8192), {}};
  const int k = std::clamp(from.supersample, 1, 4), w = out.width * k, h = out.height * k;
  const projection p = look(shapes, from, w, h);
  layer surface(w, h), marked(w, h);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    draw(shapes[i], i, p, from, k, surface, marked);

  // A hit lies on a surface. At a crossing of two surfaces it may lie slightly behind the other one, and still counts
  // as visible.
  const double forgiven = 2.5 * k / p.zoom;
  std::vector<std::uint8_t> drawn(surface.at.size());
  for (std::size_t i = 0; i < drawn.size(); ++i)
    drawn[i] = !marked.at[i].empty() && marked.at[i].near >= surface.at[i].near - forgiven;
  // In larger pictures a hit is widened by a pixel or more, its outline by as much again, and a hidden hit by half of
  // that.
  const double grow = k * std::clamp(std::min(out.width, out.height) / 600.0, 1.25, 3.0);
  const int core = static_cast<int>(std::lround(grow)), reach = static_cast<int>(std::lround(grow + k));
  const neighbourhood near = widen(drawn, w, h, reach);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    drawn[i] = !marked.at[i].empty() && drawn[i] == 0;
  const neighbourhood behind = widen(drawn, w, h, std::max(1, core / 2));

  const auto colour_of = [&](const sample &s, bool hit) {
    const shape &of = shapes[s.shape()];
    return shade(s, hit ? of.hit_colour : of.base, hit);
  };
  // Spheres fill areas, not curves. If many of them shone through, they would hide the shapes in front.
  std::vector<double> through;
  for (const shape &of : shapes)
    through.push_back((of.what == form::spheres ? 0.25 : 1) * std::clamp(from.see_through, 0.0, 1.0));
  out.rgb.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 3);
  std::size_t byte = 0;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      light sum{0, 0, 0};
      for (int v = 0; v < k; ++v)
        for (int u = 0; u < k; ++u) {
          const std::size_t i =
              static_cast<std::size_t>(y * k + v) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x * k + u);
          const double down = static_cast<double>(y) / out.height;
          light c = mix({250, 250, 249}, {228, 231, 234}, down);
          const auto outlined = [&](const layer &l) {
            const auto row = static_cast<std::size_t>(w);
            return (x * k + u + 1 < w && step_at(l, i, i + 1, 1 / p.zoom)) ||
                   (y * k + v + 1 < h && step_at(l, i, i + row, 1 / p.zoom));
          };
          if (!surface.at[i].empty())
            c = (outlined(surface) ? 0.7 : 1.0) * colour_of(surface.at[i], false);
          if (near.squared[i] == 0)
            c = (outlined(marked) ? 0.6 : 1.0) * colour_of(marked.at[i], true);
          else if (near.squared[i] <= core * core)
            c = colour_of(marked.at[near.source[i]], true);
          else if (near.squared[i] != 255)
            c = mix(c, light_of(palette::ink), 0.75);
          else if (behind.squared[i] != 255)
            c = mix(c, colour_of(marked.at[behind.source[i]], true), through[marked.at[behind.source[i]].shape()]);
          sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
        }
      for (const double v : {sum.r, sum.g, sum.b})
        out.rgb[byte++] = static_cast<std::uint8_t>(std::clamp(v / (k * k) + 0.5, 0.0, 255.0));
    }
  return out;
}

} // namespace meetc::picture
