// core/views/nouns.hpp: the names of kinds in sentences.
#ifndef MEETC_CORE_VIEWS_NOUNS_HPP
#define MEETC_CORE_VIEWS_NOUNS_HPP

#include <string>
#include <string_view>

namespace meetc {

// "boxes", "spheres"
inline std::string plural_of(std::string_view noun) {
  for (const std::string_view hiss : {"s", "x", "z", "ch", "sh"})
    if (noun.ends_with(hiss))
      return std::string(noun) + "es";
  return std::string(noun) + "s";
}

} // namespace meetc

#endif
