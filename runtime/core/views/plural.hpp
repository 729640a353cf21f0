// core/views/plural.hpp: the names of kinds in sentences.
#ifndef MEETC_CORE_VIEWS_PLURAL_HPP
#define MEETC_CORE_VIEWS_PLURAL_HPP

#include <string>
#include <string_view>

namespace meetc {

// "boxes", "spheres"
inline std::string plural(std::string_view noun) {
  for (const std::string_view hiss : {"s", "x", "z", "ch", "sh"})
    if (noun.size() >= hiss.size() && noun.substr(noun.size() - hiss.size()) == hiss)
      return std::string(noun) + "es";
  return std::string(noun) + "s";
}

} // namespace meetc

#endif
