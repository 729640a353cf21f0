#include "meet/picture/scene.hpp"

#include <algorithm>

namespace meetc::picture {

std::size_t elements(const shape &s) {
  switch (s.what) {
  case form::spheres:
    return s.rows.size() / 4;
  case form::segments:
    return s.rows.size() / 6;
  default:
    return s.index.empty() ? s.rows.size() / 9 : s.index.size() / 3;
  }
}

std::size_t hits(const shape &s) {
  const auto seen = static_cast<std::ptrdiff_t>(std::min(s.hit.size(), elements(s)));
  return static_cast<std::size_t>(
      std::count_if(s.hit.begin(), s.hit.begin() + seen, [](std::uint8_t h) { return h != 0; }));
}

} // namespace meetc::picture
