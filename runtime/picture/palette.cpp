#include "meet/picture/palette.hpp"

namespace meetc::picture {

std::string hexadecimal(colour c) {
  constexpr const char *digits = "0123456789abcdef";
  std::string out = "#";
  for (const std::uint8_t v : {c.r, c.g, c.b})
    out += digits[v >> 4], out += digits[v & 15];
  return out;
}

} // namespace meetc::picture
