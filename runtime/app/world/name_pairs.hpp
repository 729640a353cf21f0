// app/world/name_pairs.hpp: pairs of bodies by their names.
#ifndef MEETC_APP_WORLD_NAME_PAIRS_HPP
#define MEETC_APP_WORLD_NAME_PAIRS_HPP

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meetc::app {

// Two names, each of a body, or * for every one.
struct name_pair {
  std::string first, second;
  std::string where; // for messages

  bool holds(std::string_view a, std::string_view b) const {
    return (fits(first, a) && fits(second, b)) || (fits(first, b) && fits(second, a));
  }

private:
  static bool fits(std::string_view pattern, std::string_view name) { return pattern == "*" || pattern == name; }
};

// The pair in 'arm,tool'. Throws failure that names the option.
name_pair name_pair_of(const char *option, const std::string &text);

// Throws failure for a name that none of the bodies has, with the nearest one.
void require_names(const std::vector<name_pair> &pairs, const std::vector<std::string> &names);

} // namespace meetc::app

#endif
