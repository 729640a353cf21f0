// app/nearest.hpp: what a user may have meant by a name that is not known.
#ifndef MEETC_APP_NEAREST_HPP
#define MEETC_APP_NEAREST_HPP

#include <string>
#include <string_view>
#include <vector>

namespace meetc::app {

// "; did you mean '--pairs'?" for the known name that the fewest changed letters make of `name`, or "" where none is near.
std::string nearest(std::string_view name, const std::vector<std::string> &known);

} // namespace meetc::app

#endif
