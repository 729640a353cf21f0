// app/text/nearest.hpp: suggests a known name for one that is not.
#ifndef MEETC_APP_TEXT_NEAREST_HPP
#define MEETC_APP_TEXT_NEAREST_HPP

#include <string>
#include <string_view>
#include <vector>

namespace meetc::app {

// "; did you mean '--pairs'?" with the known name that the fewest changed letters make of `name`; "" if all of them
// need half of the letters changed or more.
std::string nearest(std::string_view name, const std::vector<std::string> &known);

} // namespace meetc::app

#endif
