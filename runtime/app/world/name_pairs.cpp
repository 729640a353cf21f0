#include "meet/app/world/name_pairs.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/text/nearest.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meetc::app {

name_pair name_pair_of(const char *option, const std::string &text) {
  const std::size_t comma = text.find(',');
  name_pair p{std::string(io::trim(text.substr(0, comma))), "", fmt::format("{} {}", option, io::quote(text))};
  if (comma != std::string::npos)
    p.second = io::trim(std::string_view(text).substr(comma + 1));
  if (p.first.empty() || p.second.empty() || p.second.find(',') != std::string::npos)
    throw failure(
        fmt::format("{}: two names with a comma between them are expected, such as 'arm,tool' or 'floor,*'", p.where));
  return p;
}

void require_names(const std::vector<name_pair> &pairs, const std::vector<std::string> &names) {
  for (const name_pair &p : pairs)
    for (const std::string &name : {p.first, p.second})
      if (name != "*" && std::ranges::find(names, name) == names.end())
        throw failure(fmt::format("{}: no body is named {}{}", p.where, io::quote(name), nearest(name, names)));
}

} // namespace meetc::app
