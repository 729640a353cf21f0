// Which triangles of two meshes touch, for meshes that are arrays in memory.
#include <cga/cga_runtime.hpp>
#include <cstdio>
#include <meet/core/query/collide.hpp>
#include <meet/core/query/find.hpp>

int main() {
  // A square floor of two triangles, and a spike of one triangle whose tip is on the floor's diagonal.
  const float floor[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, spike[] = {0.3F, 0.3F, 0, 0, 1, 5, 1, 0, 5};
  const std::uint32_t floor_faces[] = {0, 1, 2, 0, 2, 3}, spike_faces[] = {0, 1, 2};

  const meetc::predicate_info &touch = meetc::find_predicate(cga::catalogue(), "triangle_triangle");
  const meetc::prepared a =
      meetc::prepare({.data = floor, .vertices = 4, .stride_bytes = 12, .index = floor_faces, .elements = 2}, *touch.a);
  for (const double height : {0.0, 1e-30}) {
    meetc::pose pose; // row-major 3x4: the identity, lifted
    pose.m[11] = height;
    const meetc::prepared b = meetc::prepare(
        {.data = spike, .vertices = 3, .stride_bytes = 12, .index = spike_faces, .elements = 1}, *touch.b, pose);
    const meetc::result found = meetc::collide(a, b, touch, meetc::rung::certified);
    std::printf("%zu pairs at height %g\n", found.pairs.size(), height);
    for (const meetc::index_pair &pair : found.pairs)
      std::printf("  floor triangle %u, spike triangle %u\n", pair.a, pair.b);
  }
}
