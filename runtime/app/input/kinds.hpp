// app/input/kinds.hpp: the kinds of a catalogue as the list that readers take.
#ifndef MEETC_APP_INPUT_KINDS_HPP
#define MEETC_APP_INPUT_KINDS_HPP

#include "meetc/support.hpp"

#include <vector>

namespace meetc::app {

inline std::vector<const kind_info *> kinds_of(const catalogue &all) {
  std::vector<const kind_info *> out;
  for (int i = 0; i < all.kind_count; ++i)
    out.push_back(&all.kinds[i]);
  return out;
}

} // namespace meetc::app

#endif
