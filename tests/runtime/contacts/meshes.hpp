// Small meshes for tests of contacts.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include <meet/core/query/collide.hpp>

namespace meetc::contacts_test {

struct mesh {
  std::vector<float> points;        // x, y, z
  std::vector<std::uint32_t> index; // three for each face, or two for each segment
  std::size_t corners = 3;
  std::size_t elements() const { return index.size() / corners; }
  meetc::view view() const {
    return {.data = points.data(),
            .vertices = points.size() / 3,
            .stride_bytes = 12,
            .index = index.data(),
            .elements = elements()};
  }
  // The row of an element.
  std::vector<float> row(std::size_t i) const;
};

// The points of f over a grid of n x m cells, two triangles each; equal points stay apart.
mesh sheet(int n, int m, const std::function<void(double u, double v, float *at)> &f);
// A box of 12 triangles.
mesh cuboid(float x, float y, float z, float a, float b, float c);
mesh sphere(int n, int m, double radius, double x = 0, double y = 0, double z = 0);
// The second after the first.
void append(mesh &to, const mesh &more);

} // namespace meetc::contacts_test
