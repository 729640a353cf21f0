// Collects vertices and polygons into an element_set of triangles.
#ifndef MEETC_IO_MESH_BUILDER_HPP
#define MEETC_IO_MESH_BUILDER_HPP

#include "io/element_set.hpp"
#include "io/transform.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace meetc::io {

// The most elements, items or vertices of a set: indices have 32 bits.
inline constexpr std::size_t most_elements = 0xffffffff;

// Moves a point, rounds it, and calls fail(message) where a coordinate is not finite then.
template <class Fail>
std::array<float, 3> move_point(const transform &move, const std::array<double, 3> &read, const Fail &fail);

class mesh_builder {
public:
  mesh_builder(const kind_info &triangle, const transform &move) : move_(move) { set_.kind = &triangle; }

  void reserve(std::size_t vertices, std::size_t faces);

  // `fail` takes a message and throws; it knows the place.
  template <class Fail> void add_vertex(const std::array<double, 3> &read, const Fail &fail) {
    const std::array<float, 3> p = move_point(move_, read, fail);
    set_.data.insert(set_.data.end(), p.begin(), p.end());
  }
  std::size_t vertices() const { return set_.data.size() / 3; }

  // Fans a face from its first corner: a, b, c, d -> (a, b, c), (a, c, d). At least 3 corners. False when
  // that would be more triangles than 32 bits can count.
  bool add_face(std::span<const std::uint32_t> corners);
  std::size_t faces() const { return set_.items; }

  // The set, once the kind's own rule has accepted each triangle; throws io::error `FILE: face N: rule`.
  element_set finish(const std::string &file);

private:
  transform move_;
  element_set set_;
};

// The triangle's own rule on each element; `item` is "face" or "facet".
void check_rules(const element_set &set, const std::string &file, const char *item);

template <class Fail>
std::array<float, 3> move_point(const transform &move, const std::array<double, 3> &read, const Fail &fail) {
  const std::array<float, 3> p = round_point(move, read);
  for (std::size_t c = 0; c < 3; ++c)
    if (!std::isfinite(p[c]))
      fail(describe_non_finite(std::string_view("xyz").substr(c, 1), read[c], p[c], move));
  return p;
}

} // namespace meetc::io

#endif
