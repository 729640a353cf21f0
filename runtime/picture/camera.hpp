// picture/camera.hpp: the point from which a scene is seen.
#ifndef MEETC_PICTURE_CAMERA_HPP
#define MEETC_PICTURE_CAMERA_HPP

#include "meet/core/views/vec.hpp"
#include "meet/picture/scene.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace meetc::picture {

enum class framing : std::uint8_t { scene, hits };

// An eye in the world, which sees 30 degrees of height. `up` is not along its way to the target.
struct viewpoint {
  vec eye, target, up;
};

struct camera {
  double azimuth = 28;             // degrees about the upward axis, from the front (+z; with z up: -y)
  double elevation = 16;           // degrees above the horizon
  bool z_up = false;               // otherwise y points up
  bool perspective = true;         // mild
  double distance = 1;             // 1: the fitted shapes fill the picture; 2: they are half as large
  std::optional<viewpoint> stands; // in place of the angles; with framing::scene nothing is fitted
  framing fit = framing::scene;
  double margin = 0.05;     // share of the smaller side that is left free around the fitted shapes
  double top = 0;           // share of the height that is left free above, for words
  int supersample = 2;      // samples along each axis of a pixel, 1..4
  double see_through = 0.6; // how strongly hidden hits shine through, 0..1
  bool smooth = true;       // smooth normals where the surface is smooth
};

// The camera turned about the upward axis, and by up to 30 degrees of elevation, to where the hit triangles show the
// largest area. It considers their normals and their places on the body, but not the shapes that hide them. Without hit
// triangles it stays as it is. A viewpoint becomes angles.
camera facing_hits(std::span<const shape> shapes, camera from);

} // namespace meetc::picture

#endif
