#include "meet/io/elements/words.hpp"

#include "meet/core/views/nouns.hpp"

#include <fmt/format.h>

namespace meetc::io {

std::string grouped(std::uint64_t n) {
  std::string s = std::to_string(n);
  for (std::size_t at = s.size(); at > 3; at -= 3)
    s.insert(at - 3, 1, ',');
  return s;
}

std::string counted(const element_set &set, std::uint64_t n) {
  const char *const one = is_mesh(set) ? "face" : set.owner.empty() ? set.kind->name : "line";
  return grouped(n) + " " + (n == 1 ? one : plural_of(one));
}

std::string counted(const element_set &set) {
  const std::string items = counted(set, set.items);
  return set.items == set.elements ? items
                                   : fmt::format("{} ({} {})", items, grouped(set.elements), plural_of(set.kind->name));
}

std::string in_words(const rounded_numbers &moved, std::string_view of) {
  return fmt::format("{} number{}{} moved, by {:.3g} at most", grouped(moved.numbers), moved.numbers == 1 ? "" : "s",
                     of, moved.largest);
}

} // namespace meetc::io
