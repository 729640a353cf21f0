// report/bodies_page.hpp: many bodies, and which of them touch in each frame, as a page.
#ifndef MEETC_REPORT_BODIES_PAGE_HPP
#define MEETC_REPORT_BODIES_PAGE_HPP

#include "meet/core/world/world.hpp"
#include "meet/io/elements/element_set.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meetc::report {

// A body where it is before the first frame. Bodies of one set have one shape.
struct page_body {
  std::string name;
  const io::element_set &set;
  pose at;
};

// The bodies that a frame moves, by their numbers, and its answer.
struct page_frame {
  std::string name;
  std::span<const std::pair<std::uint32_t, pose>> moved;
  const world_answer &found;
};

// "1 pair of bodies", "1,234 pairs of bodies"
std::string pairs_of_bodies(std::size_t n);

// "Unknown whether A or B is inside the other: why." of the first eight two bodies, with the first reason and the number of
// frames, and how many more there are.
std::vector<std::string> unknown_in_lines(std::span<const std::string> names,
                                          std::span<const world_answer *const> frames);

// notes: those of other files than the bodies'. The bytes depend on the arguments alone. Throws io::error for a kind that
// cannot be drawn.
std::string page_of_bodies(std::span<const page_body> bodies, std::span<const page_frame> frames, rung precision,
                           const char *precision_name, std::span<const std::string> notes);

} // namespace meetc::report

#endif
