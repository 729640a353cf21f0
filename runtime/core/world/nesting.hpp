// core/world/nesting.hpp: whether one of two bodies that do not touch lies inside the other.
//
// A surface that goes around a point once, by its winding number, holds it. Bodies that do not touch lie on one side of each
// other part by part, so one point of each connected part tells all. The signs are exact, in every pose.
#ifndef MEETC_CORE_WORLD_NESTING_HPP
#define MEETC_CORE_WORLD_NESTING_HPP

#include "meet/core/threads/threads.hpp"
#include "meet/core/world/world.hpp"

#include <optional>
#include <span>
#include <string>

namespace meetc {

// A body as it stands. Its kind has a hull, and its numbers are finite in the pose.
struct standing_body {
  const std::string &name;
  const prepared &shape;
  const pose &at;
  std::span<const std::uint32_t> owners; // as collide_options::owner_a, for reasons
  // predicate_info::winding; null: it holds nothing.
  int (*winding)(const float *point, const float *rows, std::size_t n);
};

struct nesting_found {
  nesting how;
  std::string why; // of unknown
};

// None: they are apart. The bodies do not touch. Throws `cancelled`.
std::optional<nesting_found> nesting_of(const standing_body &a, const standing_body &b, const execution &on);

} // namespace meetc

#endif
