// report/scene.hpp: the content of a report.
#ifndef MEETC_REPORT_SCENE_HPP
#define MEETC_REPORT_SCENE_HPP

#include "meet/picture/scene.hpp"
#include "meetc/table/table.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meetc::report {

// The elements of one set, and the file's item that each of them belongs to: ascending numbers, or none where element i is
// item i. The spans must outlive the call.
struct shape {
  picture::shape drawn;
  std::span<const std::uint32_t> owner;
  std::size_t items = 0;
  std::string counted; // "345,280 triangles"

  std::uint32_t item_of(std::size_t element) const {
    return owner.empty() ? static_cast<std::uint32_t>(element) : owner[element];
  }
};

struct body {
  std::string name;
  std::size_t shape = 0; // its number
  std::array<double, 12> pose = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  std::optional<picture::colour> base = {}; // where it touches nothing; none: that of its shape
};

// Where the pairs meet; the numbers are those of points.
struct contact_lines {
  std::vector<double> points;           // x, y, z
  std::vector<std::uint32_t> pieces;    // two for each segment
  std::vector<std::uint32_t> triangles; // three for each triangle of a patch
  std::vector<std::uint32_t> single;    // points on neither
};

// The bodies that a frame moves, and the bodies that touch in it, or lie in one another, with how they do: "3 pairs", "inside".
struct frame {
  std::string name;
  std::vector<std::pair<std::uint32_t, std::array<double, 12>>> moved;
  struct touch {
    std::uint32_t a, b;
    std::string how;
  };
  std::vector<touch> touching;
};

struct scene {
  std::string title;
  std::vector<shape> shapes;
  std::vector<body> bodies;
  std::vector<std::pair<std::string, std::string>> facts; // what was decided, and how
  std::vector<std::string> notes;

  // Either the pairs of two shapes, or of one with itself, which stand as they are,
  std::span<const index_pair> pairs = {}; // of items of the first shape and of the last one
  contact_lines contacts = {};
  // or many bodies.
  std::vector<frame> frames = {};
};

// The most that a report holds. The pairs that are listed are the first ones, as long as the items in them are not too many.
struct limits {
  std::size_t pairs = 100'000;
  std::size_t items = 60'000; // of each shape
};

} // namespace meetc::report

#endif
