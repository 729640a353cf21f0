// report/drawn_side.hpp: a set of elements as a shape of a picture or a page.
#ifndef MEETC_REPORT_DRAWN_SIDE_HPP
#define MEETC_REPORT_DRAWN_SIDE_HPP

#include "meet/io/elements/element_set.hpp"
#include "meet/picture/scene.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace meetc::report {

// One side of a picture.
struct painted {
  const io::element_set &set;
  const std::vector<std::uint8_t> &hit; // one for each item; empty: hits are not shown
  std::string name;
  picture::colour base, hit_colour;
};

// A side as it is drawn, and the memory that this refers to beside the set's own. Throws
// io::error for a kind that cannot be drawn.
struct drawn_side {
  explicit drawn_side(const painted &side);
  drawn_side(const drawn_side &) = delete;
  drawn_side &operator=(const drawn_side &) = delete;
  picture::shape shape;
  std::vector<std::uint32_t> owner; // the item of each drawn element; empty: they are one to one

private:
  std::vector<std::uint8_t> hit_; // one for each element
  std::vector<float> rows_;       // to draw, if they are not the set's own
};

} // namespace meetc::report

#endif
