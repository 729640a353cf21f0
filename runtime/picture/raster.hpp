// The renderer's inner part: a projection, depth buffers of samples, and the drawing of shapes into them.
// Camera space: x right, y up, z towards the viewer, the scene's box centred and scaled to half diagonal 1.
#ifndef MEETC_APP_PICTURE_RASTER_HPP
#define MEETC_APP_PICTURE_RASTER_HPP

#include "bodies/vec.hpp"
#include "picture/picture.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace meetc::app::detail {

// A sample: how near the surface is (larger: nearer), and its normal, shape and whether a mesh edge runs
// here.
struct sample {
  float near;
  std::uint32_t bits; // normal x, y: 12 bits each; edge: 1; shape + 1: 6. 0: nothing
  bool empty() const { return bits == 0; }
  bool edge() const { return (bits >> 6 & 1) != 0; }
  std::size_t shape() const { return (bits & 63) - 1; }
  vec direction() const; // the normal, towards the viewer
};

struct layer {
  int width, height;
  std::vector<sample> at; // rows from the top
  layer(int w, int h)
      : width(w), height(h), at(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), sample{-1e30f, 0}) {}
};

struct screen_point {
  double x, y; // in samples from the upper left corner
  double near;
};

// World to camera space to samples.
struct projection {
  vec centre{}; // of the scene's box, in the world
  double unit = 1;
  std::array<vec, 3> axis{}; // camera axes in the world
  bool perspective = false;
  vec target{};                           // camera space; the eye looks along z through it
  double eye = 5;                         // the eye's z, and its
  double focus = 5;                       // distance from the target
  double zoom = 1, u0 = 0, v0 = 0;        // samples a unit; what lies in the middle of the picture
  double half_width = 0, half_height = 0; // samples

  vec to_camera(const vec &world) const;
  double shrink(double z) const { return perspective ? focus / (eye - z) : 1; }
  double nearness(double z) const { return perspective ? focus * shrink(z) : z; } // slope 1 at the target
  std::array<double, 2> flatten(const vec &c) const;                              // before zoom and shift
  screen_point to_screen(const vec &c) const;
};

// The finite part of an element: its points and a radius about them (0 but for spheres). n = 0: left out.
struct element {
  std::array<vec, 3> point;
  double radius;
  int n;
};
element element_at(const shape &s, std::size_t i);
inline bool is_hit(const shape &s, std::size_t i) {
  return i < s.hit.size() && s.hit[i] != 0;
}

// The projection that fits the shapes, or their hits, into a picture of so many samples.
projection look(std::span<const shape> shapes, const view &from, int width, int height);

// Draws the whole shape into `surface` and its hit elements into `marked` also. `pixel` is the size of a
// pixel in samples.
void draw(const shape &s, std::size_t number, const projection &p, const view &from, double pixel, layer &surface,
          layer &marked);

} // namespace meetc::app::detail

#endif
