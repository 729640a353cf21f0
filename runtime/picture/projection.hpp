// picture/projection.hpp: elements as points, and their projection to the screen. In camera space x points right, y up
// and z towards the viewer; the scene's box is centred and scaled to half diagonal 1.
#ifndef MEETC_PICTURE_PROJECTION_HPP
#define MEETC_PICTURE_PROJECTION_HPP

#include "meet/core/views/vec.hpp"
#include "meet/picture/camera.hpp"
#include "meet/picture/scene.hpp"

#include <array>
#include <span>

namespace meetc::picture::detail {

struct screen_point {
  double x, y; // in samples from the upper left corner
  double near;
};

// Maps world space to camera space and camera space to samples.
struct projection {
  vec centre{}; // of the scene's box, in the world
  double unit = 1;
  std::array<vec, 3> axis{}; // camera axes in the world
  bool perspective = false;
  vec target{};                           // in camera space; the eye looks along z through it
  double eye = 5;                         // the z of the eye
  double focus = 5;                       // the distance of the eye from the target
  double zoom = 1, u0 = 0, v0 = 0;        // samples per unit; the point in the middle of the picture
  double half_width = 0, half_height = 0; // samples

  vec to_camera(const vec &world) const;
  double shrink(double z) const { return perspective ? focus / (eye - z) : 1; }
  double nearest() const { return eye - 0.01 * focus; } // what lies beyond, about the eye or behind it, is not seen
  double nearness(double z) const { return perspective ? focus * shrink(z) : z; } // slope 1 at the target
  std::array<double, 2> flatten(const vec &c) const;                              // before zoom and shift
  screen_point to_screen(const vec &c) const;
};

// The points of an element and a radius around them (0 unless it is a sphere). n = 0: not finite, and left out.
struct element {
  std::array<vec, 3> point;
  double radius;
  int n;
};
element element_at(const shape &s, std::size_t i);
inline bool is_hit(const shape &s, std::size_t i) {
  return i < s.hit.size() && s.hit[i] != 0;
}

// The projection that fits the shapes, or their hits, into a picture of this many samples.
projection look(std::span<const shape> shapes, const camera &from, int width, int height);

} // namespace meetc::picture::detail

#endif
