// Pictures of a collision: which triangles, spheres and segments touch, seen at a glance.
//
// Problem: touching triangles form a thin curve on a large mesh, partly hidden behind the other one; a plain
// rendering shows next to nothing of them.
// Method: a software renderer. Every shape is drawn twice into depth buffers of samples: the surfaces in calm
// colours, and the hit elements alone. A hit sample in front of (or barely behind) the surface is drawn in
// full, widened and outlined, so that even one triangle smaller than a pixel is seen; a hit sample behind a
// surface shines through it faintly.
// Limits: at most 63 shapes; hit elements are drawn up to a pixel or two wider than they are; occlusion
// within a pixel or two of the intersection curve is decided in favour of the hits. Elements with NaN or
// infinite coordinates or indices out of range are left out.
#ifndef MEETC_PICTURE_PICTURE_HPP
#define MEETC_PICTURE_PICTURE_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::picture {

struct colour {
  std::uint8_t r, g, b;
  friend bool operator==(const colour &, const colour &) = default;
};

namespace palette {
inline constexpr colour green{150, 176, 158}; // calm colours of the two sets
inline constexpr colour blue{146, 164, 190};
inline constexpr colour red{196, 152, 146};
inline constexpr colour yellow{255, 214, 0}; // hit elements of the first set
inline constexpr colour pink{255, 20, 137};  // hit elements of the second
inline constexpr colour orange{255, 128, 0}; // hit spheres
inline constexpr colour ink{44, 48, 54};
} // namespace palette

enum class form : std::uint8_t {
  triangles, // rows: x y z of vertices; three indices a triangle, or no index: nine floats a triangle
  spheres,   // rows: x y z r
  segments   // rows: x0 y0 z0 x1 y1 z1
};

// One set of elements of a scene. The spans must outlive the call.
struct shape {
  form what = form::triangles;
  std::span<const float> rows;
  std::span<const std::uint32_t> index;
  std::span<const std::uint8_t> hit; // one an element, non-zero: hit; missing ones count as not hit
  colour base = palette::green;
  colour hit_colour = palette::yellow;
  std::string name; // for captions
};

std::size_t elements(const shape &s);
std::size_t hits(const shape &s);

enum class framing : std::uint8_t { scene, hits };

struct camera {
  double azimuth = 28;     // degrees about the upward axis, from the front (+z; with z up: -y)
  double elevation = 16;   // degrees above the horizon
  bool z_up = false;       // otherwise y points up
  bool perspective = true; // a mild one
  framing fit = framing::scene;
  double margin = 0.05;     // of the smaller side, left free around what is fitted
  int supersample = 2;      // samples a pixel along each axis, 1..4
  double see_through = 0.6; // how strongly hidden hits shine through, 0..1
  bool smooth = true;       // smooth normals where the surface is
};

struct image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb; // rows from the top, three bytes a pixel
  colour at(int x, int y) const {
    const std::size_t i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

// The view turned, about the upward axis and by up to 30 degrees of elevation, to where the hit triangles
// show the largest area, by their normals and by where they lie on the body; what hides them is not traced.
// Unchanged without hit triangles.
camera facing_hits(std::span<const shape> shapes, camera from);

// One view of the scene. Sizes are clamped to 16..8192.
image render(std::span<const shape> shapes, const camera &from, int width, int height);

// The scene in one large panel with a caption; beside it, when there are hits, the scene close up where the
// hits lie in a small part of it, and (for two shapes or more) the first two alone, each facing its hits.
image render_panels(std::span<const shape> shapes, const camera &from, int width, int height);

// Text in a 5 by 7 bitmap font, `scale` pixels a dot, its upper left corner at (x, y); ASCII, clipped. A line
// takes 8 * scale pixels, a character 6 * scale.
void draw_text(image &into, int x, int y, std::string_view text, int scale, colour ink);

// A PNG file in memory. Throws std::runtime_error when libpng fails or the image is malformed or empty.
std::vector<std::uint8_t> encode_png(const image &picture);

} // namespace meetc::picture

#endif
