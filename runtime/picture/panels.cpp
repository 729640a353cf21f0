// Several panels of one scene in one picture, with captions. See render.hpp.
#include "meet/core/views/nouns.hpp"
#include "meet/core/views/vec.hpp"
#include "meet/picture/projection.hpp"
#include "meet/picture/render.hpp"
#include "meet/picture/text.hpp"

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

constexpr std::size_t most_keys = 8;

std::string counts_of(const shape &s) {
  const char *const kinds[] = {"triangle", "sphere", "segment"};
  const std::size_t n = elements(s) / s.parts, h = hits(s) / s.parts;
  const std::string one = *s.whole ? s.whole : kinds[static_cast<int>(s.what)];
  return grouped(n) + " " + (n == 1 ? one : plural_of(one)) + (s.hit.empty() ? "" : ", " + grouped(h) + " hit");
}

struct canvas {
  image picture;
  int size; // of words, in pixels from line to line

  void paste(const image &from, int x, int y) {
    for (int row = 0; row < from.height && y + row < picture.height; ++row) {
      const auto bytes = static_cast<std::ptrdiff_t>(3 * std::min(from.width, picture.width - x));
      const std::ptrdiff_t source = std::ptrdiff_t{3} * row * from.width;
      const std::ptrdiff_t target = 3 * (static_cast<std::ptrdiff_t>(y + row) * picture.width + x);
      std::copy_n(from.rgb.begin() + source, bytes, picture.rgb.begin() + target);
    }
  }
  void caption(int x, int y, std::string_view words) {
    draw_words(picture, x, y, words, size, palette::ink, palette::paper);
  }
  int square() const { return 2 * size / 3; }
  void fill(int x, int y, colour c) {
    for (int v = y; v < std::min(y + square(), picture.height); ++v)
      for (int u = x; u < std::min(x + square(), picture.width); ++u) {
        const std::size_t i =
            3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(u));
        picture.rgb[i] = c.r, picture.rgb[i + 1] = c.g, picture.rgb[i + 2] = c.b;
      }
  }
  // Draws a square in the shape's colour and, where hits are shown, one in the colour of its hits; then its name, which is
  // shortened to stay within `right`, and its counts.
  void key(int x, int y, int right, const shape &s) {
    for (const colour c : {s.base, s.hit_colour})
      if (c == s.base || !s.hit.empty()) {
        fill(x, y + size / 4, c);
        x += square() + size / 8;
      }
    x += size / 4;
    const std::string counted = counts_of(s);
    const int left = right - x - width_of(counted, size);
    caption(x, y, (s.name.empty() ? "" : shortened(s.name + ":", size, left) + " ") + counted);
  }
};

} // namespace

image render_panels(std::span<const shape> shapes, const camera &from, int width, int height) {
  const int w = std::clamp(width, 16, 8192), h = std::clamp(height, 16, 8192);
  const int size = std::max(12, std::min(w / 72, h / 40)), gap = std::max(2, size / 6), edge = size / 2;
  canvas c{{w, h, {}}, size};
  c.picture.rgb.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3, 255);

  struct panel {
    std::span<const shape> what;
    camera from;
    std::string caption;
  };
  std::vector<panel> side; // beside the main one
  const bool any = std::any_of(shapes.begin(), shapes.end(), [](const shape &s) { return hits(s) > 0; });
  if (any && w >= 320 && h >= 240) {
    camera near = from;
    near.distance = 1;
    if (extent_of(shapes, true).diagonal() < 0.3 * extent_of(shapes, false).diagonal()) {
      near.fit = framing::hits;
      side.push_back({shapes, near, "close up"});
      near.fit = framing::scene;
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(shapes.size(), 2) && shapes.size() > 1; ++i)
      if (hits(shapes[i]) > 0)
        side.push_back({shapes.subspan(i, 1), facing_hits(shapes.subspan(i, 1), near),
                        (shapes[i].name.empty() ? "set " + std::to_string(i + 1) : shapes[i].name) + " alone"});
  }
  const int main_width = side.empty() ? w : static_cast<int>(w * 0.64), line = 5 * size / 4;
  const auto lines = static_cast<int>(std::min<std::size_t>(shapes.size(), most_keys));
  const auto below = [&](camera view, int words, int panel_height) {
    view.top = static_cast<double>(edge + words * line) / panel_height;
    return view;
  };
  c.paste(render(shapes, below(from, lines, h), main_width, h), 0, 0);
  for (int i = 0; i < lines; ++i)
    c.key(edge, edge + i * line, main_width - edge, shapes[static_cast<std::size_t>(i)]);
  if (shapes.size() > most_keys)
    c.caption(edge, edge + lines * line, "and " + grouped(shapes.size() - most_keys) + " more");
  const int n = static_cast<int>(side.size()), x = main_width + gap, side_width = w - x;
  for (int i = 0; i < n; ++i) {
    const int top = i * (h + gap) / n, bottom = (i + 1) * (h + gap) / n - gap;
    const panel &p = side[static_cast<std::size_t>(i)];
    c.paste(render(p.what, below(p.from, 1, bottom - top), side_width, bottom - top), x, top);
    c.caption(x + edge, top + edge, shortened(p.caption, size, side_width - 2 * edge));
  }
  return c.picture;
}

} // namespace meetc::picture
