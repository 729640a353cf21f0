// picture/raster.hpp: depth buffers of samples, and drawing shapes into them.
#ifndef MEETC_PICTURE_RASTER_HPP
#define MEETC_PICTURE_RASTER_HPP

#include "meet/core/views/vec.hpp"
#include "meet/picture/camera.hpp"
#include "meet/picture/projection.hpp"
#include "meet/picture/scene.hpp"

#include <cstdint>
#include <vector>

namespace meetc::picture::detail {

// A sample: the nearness of the surface (larger is nearer), its normal and its shape, and a bit for an edge of a mesh.
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

// Draws the whole shape into `surface` and its hit elements into `marked` as well. `pixel` is the number of samples
// across a pixel.
void draw(const shape &s, std::size_t number, const projection &p, const camera &from, double pixel, layer &surface,
          layer &marked);

} // namespace meetc::picture::detail

#endif
