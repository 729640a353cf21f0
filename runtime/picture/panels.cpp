// Several panels of one scene in one picture, with captions. See render.hpp.
#include "meet/core/views/nouns.hpp"
#include "meet/core/views/vec.hpp"
#include "meet/picture/projection.hpp"
#include "meet/picture/render.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace meetc::picture {
namespace {

using namespace detail;

struct extent {
  vec low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  double diagonal() const { return low.x <= high.x ? std::sqrt(dot(high - low, high - low)) : 0; }
};

extent extent_of(std::span<const shape> shapes, bool only_hits) {
  extent e;
  for (const shape &s : shapes)
    for (std::size_t i = 0, n = elements(s); i < n; ++i) {
      if (only_hits && !is_hit(s, i))
        continue;
      const element at = element_at(s, i);
      for (std::size_t k = 0; k < static_cast<std::size_t>(at.n); ++k) {
        const vec &p = at.point[k], r{at.radius, at.radius, at.radius}, a = p - r, b = p + r;
        e.low = {std::min(e.low.x, a.x), std::min(e.low.y, a.y), std::min(e.low.z, a.z)};
        e.high = {std::max(e.high.x, b.x), std::max(e.high.y, b.y), std::max(e.high.z, b.z)};
      }
    }
  return e;
}

std::string grouped(std::size_t n) { // 345944 as 345,944
  std::string s = std::to_string(n);
  for (std::size_t at = s.size(); at > 3; at -= 3)
    s.insert(at - 3, 1, ',');
  return s;
}

std::string describe(const shape &s) {
  const char *const kinds[] = {"triangle", "sphere", "segment"};
  const std::size_t n = elements(s) / s.parts, h = hits(s) / s.parts;
  const std::string one = *s.whole ? s.whole : kinds[static_cast<int>(s.what)];
  return (s.name.empty() ? "" : s.name + ": ") + grouped(n) + " " + (n == 1 ? one : plural_of(one)) +
         (s.hit.empty() ? "" : ", " + grouped(h) + " hit");
}

struct canvas {
  image picture;
  int scale; // of the font

  void paste(const image &from, int x, int y) {
    for (int row = 0; row < from.height && y + row < picture.height; ++row) {
      const auto bytes = static_cast<std::ptrdiff_t>(3 * std::min(from.width, picture.width - x));
      const std::ptrdiff_t source = std::ptrdiff_t{3} * row * from.width;
      const std::ptrdiff_t target = 3 * (static_cast<std::ptrdiff_t>(y + row) * picture.width + x);
      std::copy_n(from.rgb.begin() + source, bytes, picture.rgb.begin() + target);
    }
  }
  // Writes a caption on a light rim, so that it can be read on any background.
  void caption(int x, int y, std::string_view words) {
    for (int i = 0; i < 9; ++i)
      draw_text(picture, x + (i % 3 - 1) * scale, y + (i / 3 - 1) * scale, words, scale, {247, 248, 248});
    draw_text(picture, x, y, words, scale, palette::ink);
  }
  // Draws a square in the shape's colour and, where hits are shown, one in the colour of its hits; then the caption.
  void key(int x, int y, const shape &s, std::string_view words) {
    for (int square = 0; square < (s.hit.empty() ? 1 : 2); ++square) {
      const colour c = square == 0 ? s.base : s.hit_colour;
      for (int v = 0; v < 7 * scale; ++v)
        for (int u = 0; u < 7 * scale; ++u)
          if (x + u < picture.width && y + v < picture.height) {
            const auto i =
                static_cast<std::ptrdiff_t>(3 * (static_cast<std::ptrdiff_t>(y + v) * picture.width + x + u));
            std::copy_n(&c.r, 1, picture.rgb.begin() + i);
            std::copy_n(&c.g, 1, picture.rgb.begin() + i + 1);
            std::copy_n(&c.b, 1, picture.rgb.begin() + i + 2);
          }
      x += 8 * scale;
    }
    caption(x + 3 * scale, y, words);
  }
};

} // namespace

image render_panels(std::span<const shape> shapes, const camera &from, int width, int height) {
  const int w = std::clamp(width, 16, 8192), h = std::clamp(height, 16, 8192);
  const int scale = std::max(1, std::min(w / 800, h / 450)), gap = 2 * scale;
  canvas c{{w, h, {}}, scale};
  c.picture.rgb.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3, 255);

  struct panel {
    std::span<const shape> what;
    camera from;
    std::string caption;
  };
  std::vector<panel> side; // beside the main one
  const bool any = std::any_of(shapes.begin(), shapes.end(), [](const shape &s) { return hits(s) > 0; });
  if (any && w >= 320 && h >= 240) {
    if (extent_of(shapes, true).diagonal() < 0.3 * extent_of(shapes, false).diagonal()) {
      camera close = from;
      close.fit = framing::hits;
      side.push_back({shapes, close, "close up"});
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(shapes.size(), 2) && shapes.size() > 1; ++i)
      if (hits(shapes[i]) > 0)
        side.push_back({shapes.subspan(i, 1), facing_hits(shapes.subspan(i, 1), from),
                        (shapes[i].name.empty() ? "set " + std::to_string(i + 1) : shapes[i].name) + " alone"});
  }
  const int main_width = side.empty() ? w : static_cast<int>(w * 0.64);
  camera whole = from;
  whole.margin = std::max(whole.margin, 0.08); // leaves room for captions
  c.paste(render(shapes, whole, main_width, h), 0, 0);
  for (std::size_t i = 0; i < shapes.size() && i < 8; ++i)
    c.key(6 * scale, 6 * scale + static_cast<int>(i) * 11 * scale, shapes[i], describe(shapes[i]));
  const int n = static_cast<int>(side.size()), x = main_width + gap, side_width = w - x;
  for (int i = 0; i < n; ++i) {
    const int top = i * (h + gap) / n, bottom = (i + 1) * (h + gap) / n - gap;
    const panel &p = side[static_cast<std::size_t>(i)];
    camera v = p.from;
    v.margin = std::max(v.margin, 0.08);
    c.paste(render(p.what, v, side_width, bottom - top), x, top);
    c.caption(x + 6 * scale, top + 6 * scale, p.caption);
  }
  return c.picture;
}

} // namespace meetc::picture
