// Which triangles of two meshes touch, for meshes that are arrays in memory.
#include <cstdio>
#include <meet/meet.hpp>

int main() {
  // A square floor of two triangles, and a spike of one triangle whose tip is on the floor's diagonal.
  const std::vector<std::array<float, 3>> floor_points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::array<std::uint32_t, 3>> floor_faces = {{0, 1, 2}, {0, 2, 3}};
  const float spike_points[] = {0.3F, 0.3F, 0, 0, 1, 5, 1, 0, 5};

  const meet::prepared floor = meet::prepare(meet::triangles(floor_points, floor_faces));
  for (const double height : {0.0, 1e-30}) {
    meet::pose pose; // row-major 3x4: the identity, lifted
    pose.m[11] = height;
    const meet::prepared spike = meet::prepare(meet::triangles(spike_points), pose);
    const std::vector<meet::index_pair> pairs = meet::pairs(floor, spike);
    std::printf("%zu pairs at height %g\n", pairs.size(), height);
    for (const auto &[a, b] : pairs)
      std::printf("  floor triangle %u, spike triangle %u\n", a, b);
  }
}
