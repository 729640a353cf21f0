// picture/camera.hpp: from where a scene is seen.
#ifndef MEETC_PICTURE_CAMERA_HPP
#define MEETC_PICTURE_CAMERA_HPP

#include "picture/scene.hpp"

#include <cstdint>
#include <span>

namespace meetc::picture {

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

// The camera turned, about the upward axis and by up to 30 degrees of elevation, to where the hit triangles
// show the largest area, by their normals and by where they lie on the body; what hides them is not traced.
// Unchanged without hit triangles.
camera facing_hits(std::span<const shape> shapes, camera from);

} // namespace meetc::picture

#endif
