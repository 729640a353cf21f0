// bodies/mesh.hpp: a triangle mesh in memory.
#ifndef MEETC_BODIES_MESH_HPP
#define MEETC_BODIES_MESH_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meetc::bodies {

struct mesh {
  std::vector<float> xyz;           // x y z of each vertex
  std::vector<std::uint32_t> index; // three vertices for each triangle
  std::size_t vertices() const { return xyz.size() / 3; }
  std::size_t triangles() const { return index.size() / 3; }
};

} // namespace meetc::bodies

#endif
