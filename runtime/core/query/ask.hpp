// core/query/ask.hpp: one question about two sets, whichever order a predicate takes their kinds in.
#ifndef MEETC_CORE_QUERY_ASK_HPP
#define MEETC_CORE_QUERY_ASK_HPP

#include "meet/core/query/collide.hpp"
#include "meet/core/query/fitting.hpp"

#include <string_view>

namespace meetc {

struct how {
  std::string_view mode = "solid"; // or "surface", of spheres
  std::string_view predicate = {}; // its name; empty: the first that fits the kinds and the mode
  rung precision = rung::certified;
  collide_options with = {}; // `want` and `first_met` are the question's own
};

// The predicate of these kinds. Throws usage_error, with those that there are, where none fits.
choice chosen(const catalogue &all, const kind_info &a, const kind_info &b, const how &asked);

// collide() with that predicate, about a and b in this order. Throws what collide() throws, and usage_error where no predicate
// fits, or what is met first is asked of a set of the predicate's second kind.
result ask(const catalogue &all, const prepared &a, const prepared &b, const how &asked);

} // namespace meetc

#endif
