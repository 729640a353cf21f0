// app/choose.hpp: which predicate answers for two kinds of element.
//
// A predicate is for an ordered pair of kinds; a user gives them in either order. So one that takes them the
// other way about fits too, and is run swapped.
#ifndef MEETC_APP_CHOOSE_HPP
#define MEETC_APP_CHOOSE_HPP

#include "meetc/support.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::app {

struct choice {
  const predicate_info *predicate = nullptr;
  bool swapped = false; // the predicate's a is the user's b
};

// All that fit, in the catalogue's order.
std::vector<choice> fitting(const catalogue &all, const kind_info &a, const kind_info &b);

// The one that is asked for; `mode` picks among several and is "solid" where it is not given. Throws failure,
// which says what there is.
choice choose(const catalogue &all, const kind_info &a, const kind_info &b, const std::optional<std::string> &name,
              const std::optional<std::string> &mode);

// "exact" and so on.
const char *name_of(rung precision);

// Throws failure where this build has no such precision.
rung precision_named(std::string_view name);

} // namespace meetc::app

#endif
