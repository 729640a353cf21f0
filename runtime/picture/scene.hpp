// picture/scene.hpp: the content of a picture, sets of elements with colours and hits.
#ifndef MEETC_PICTURE_SCENE_HPP
#define MEETC_PICTURE_SCENE_HPP

#include "meet/picture/palette.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace meetc::picture {

enum class form : std::uint8_t {
  triangles, // rows: x y z of vertices; three indices for each triangle, or no index and nine floats for each
  spheres,   // rows: x y z r
  segments   // rows: x0 y0 z0 x1 y1 z1
};

// One set of elements of a scene. The spans must outlive the call.
struct shape {
  form what = form::triangles;
  std::span<const float> rows;
  std::span<const std::uint32_t> index;
  std::span<const std::uint8_t> hit; // one for each element, non-zero where it is hit; missing ones are not hit
  colour base = palette::calm[0];
  colour hit_colour = palette::yellow;
  std::string name; // for captions
  // For captions: the name of `parts` elements together, such as a box of twelve triangles; empty: each stands alone.
  const char *whole = "";
  std::size_t parts = 1;
};

std::size_t elements(const shape &s);
std::size_t hits(const shape &s);

} // namespace meetc::picture

#endif
