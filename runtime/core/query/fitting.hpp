// core/query/fitting.hpp: which predicates decide two kinds of element.
//
// A predicate takes an ordered pair of kinds, and a caller has them in either order. A predicate that takes them in the other
// order therefore fits as well, and runs swapped.
#ifndef MEETC_CORE_QUERY_FITTING_HPP
#define MEETC_CORE_QUERY_FITTING_HPP

#include "meet/core/answers/answers.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace meetc {

struct choice {
  const predicate_info *predicate = nullptr;
  bool swapped = false; // the predicate's a is the caller's b
};

// All predicates that fit, in the catalogue's order.
std::vector<choice> fitting(const catalogue &all, const kind_info &a, const kind_info &b);

// The first of these that answers for the mode, "solid" or "surface", or for both alike; nothing: there is none.
std::optional<choice> first_for(std::span<const choice> fit, std::string_view mode);

// An answer about b and a, as one about a and b.
result turned(result found);

} // namespace meetc

#endif
