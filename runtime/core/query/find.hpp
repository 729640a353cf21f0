// core/query/find.hpp: finds predicates and kinds of a catalogue by their names.
#ifndef MEETC_CORE_QUERY_FIND_HPP
#define MEETC_CORE_QUERY_FIND_HPP

#include "meet/core/views/usage_error.hpp"
#include "meetc/support.hpp"

#include <string>
#include <string_view>

namespace meetc {

// Throws usage_error with the known names where the catalogue has no such predicate.
inline const predicate_info &find_predicate(const catalogue &in, std::string_view name) {
  std::string known;
  for (int i = 0; i < in.predicate_count; ++i) {
    if (in.predicates[i].name == name)
      return in.predicates[i];
    known += std::string(i == 0 ? "" : ", ") + in.predicates[i].name;
  }
  throw usage_error("no predicate '" + std::string(name) + "' in " + in.space +
                    (known.empty() ? "; there is none" : "; there are: " + known));
}

// Likewise of a kind.
inline const kind_info &find_kind(const catalogue &in, std::string_view name) {
  std::string known;
  for (int i = 0; i < in.kind_count; ++i) {
    if (in.kinds[i].name == name)
      return in.kinds[i];
    known += std::string(i == 0 ? "" : ", ") + in.kinds[i].name;
  }
  throw usage_error("no kind '" + std::string(name) + "' in " + in.space +
                    (known.empty() ? "; there is none" : "; there are: " + known));
}

} // namespace meetc

#endif
