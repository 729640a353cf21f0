// report/detail.hpp: the elements of a report that are shown with their own float32 numbers.
//
// These are the items of the listed pairs and, of a mesh, the faces that have a corner in common with them; all elements of
// a set that is no mesh. Numbers are taken relative to a centre and divided by a power of two, each rounded once.
#ifndef MEETC_REPORT_DETAIL_HPP
#define MEETC_REPORT_DETAIL_HPP

#include "meet/report/scene.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace meetc::report {

// The first pairs, as many as the limits admit, and 1 for each item of each shape that is in one of them.
struct listed_pairs {
  std::size_t count = 0;
  std::vector<std::vector<std::uint8_t>> named;
};
listed_pairs list_pairs(const scene &s, const limits &most);

// 1 for each element that is shown in detail. named: 1 for each item of a listed pair; empty: there are none.
std::vector<std::uint8_t> detailed(const shape &s, std::span<const std::uint8_t> named);

struct placing {
  std::array<double, 3> centre = {};
  double unit = 1; // a power of two
  float length(double x) const { return static_cast<float>(x / unit); }
  float coordinate(double x, std::size_t axis) const { return length(x - centre[axis]); }
};

struct detail {
  std::vector<std::uint32_t> elements; // ascending
  std::vector<float> numbers;          // of a mesh three for each point, else those of each element's row
  std::vector<std::uint32_t> index;    // of a mesh
  std::vector<std::uint32_t> items;    // of each element
  std::vector<std::uint8_t> hit;       // of each element
};
detail detail_of(const shape &s, std::span<const std::uint8_t> chosen, const placing &at);

} // namespace meetc::report

#endif
