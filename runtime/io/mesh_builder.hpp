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

// The largest number of elements, items or vertices in a set, since indices have 32 bits.
inline constexpr std::size_t most_elements = 0xffffffff;

// Moves a point, rounds it, and calls fail(message) if a coordinate is then not finite.
template <class Fail>
std::array<float, 3> move_point(const transform &move, const std::array<double, 3> &read, const Fail &fail);

class mesh_builder {
public:
  mesh_builder(const kind_info &triangle, const transform &move) : move_(move) { set_.kind = &triangle; }

  void reserve(std::size_t vertices, std::size_t faces);

  // `fail` takes a message and throws; it knows the place in the file.
  template <class Fail> void add_vertex(const std::array<double, 3> &read, const Fail &fail) {
    const std::array<float, 3> p = move_point(move_, read, fail);
    set_.data.insert(set_.data.end(), p.begin(), p.end());
  }
  std::size_t vertices() const { return set_.data.size() / 3; }

  // Fans a face of at least 3 corners from the first: a, b, c, d -> (a, b, c), (a, c, d). Returns false where the
  // number of triangles would exceed 32 bits.
  bool add_face(std::span<const std::uint32_t> corners);
  std::size_t faces() const { return set_.items; }

  // Returns the set after testing each triangle against the rule of its kind. Throws io::error `FILE: face N: rule`.
  element_set finish(const std::string &file);

private:
  transform move_;
  element_set set_;
};

// Tests each element against the rule of the triangle kind; `item` is "face" or "facet".
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
