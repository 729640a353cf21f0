#include "meet/app/text/words.hpp"

#include "meet/app/text/boxes.hpp"

#include <fmt/format.h>

namespace meetc::app {

std::string in_words(const box &b) {
  if (is_empty(b))
    return "empty";
  return fmt::format("[{}, {}, {}] to [{}, {}, {}]", b.lo[0], b.lo[1], b.lo[2], b.hi[0], b.hi[1], b.hi[2]);
}

} // namespace meetc::app
