#include "core/check.hpp"

#include "core/control_word.hpp"
#include "core/rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

namespace meetc {

fault check(const view &elements, const kind_info &kind, const pose &at) {
  const control_word_guard guard;
  std::vector<float> row(static_cast<std::size_t>(kind.fields));
  const auto first_bad = [&] {
    int i = 0;
    while (i < kind.fields && std::isfinite(row[static_cast<std::size_t>(i)]))
      ++i;
    return i;
  };
  for (std::size_t e = 0; e < elements.elements; ++e) {
    const status s = gather(elements, kind, at, e, e + 1, row.data());
    if (s == status::ok)
      continue;
    fault f;
    f.element = e;
    if (s == status::bad_index) {
      const std::uint32_t *index = elements.index + e * static_cast<std::size_t>(kind.points);
      f.kind = fault_kind::index;
      while (index[f.field] < elements.vertices)
        ++f.field;
      f.index = index[f.field];
      return f;
    }
    if (first_bad() == kind.fields) {
      f.kind = fault_kind::rule;
      f.rule = kind.fault(row.data());
      return f;
    }
    // The fault is in the stored value, or else in the value that the pose made.
    f.kind = fault_kind::moved;
    f.field = first_bad();
    f.value = row[static_cast<std::size_t>(f.field)];
    gather(elements, kind, {}, e, e + 1, row.data());
    if (const int i = first_bad(); i < kind.fields) {
      f.kind = fault_kind::value;
      f.field = i;
      f.value = row[static_cast<std::size_t>(i)];
    }
    return f;
  }
  return {};
}

std::string describe(const fault &f, const kind_info &kind) {
  const std::string where = "element " + std::to_string(f.element) + ": ";
  std::string_view names = kind.csv;
  for (int i = 0; i < f.field && f.kind != fault_kind::index; ++i)
    names.remove_prefix(std::min(names.find(','), names.size() - 1) + 1);
  const std::string name(names.substr(0, names.find(',')));
  char value[32];
  std::snprintf(value, sizeof value, "%g", static_cast<double>(f.value));
  switch (f.kind) {
  case fault_kind::none:
    break;
  case fault_kind::index:
    return where + "index " + std::to_string(f.index) + " of point " + std::to_string(f.field) +
           " lies beyond the vertices";
  case fault_kind::value:
    return where + name + " is " + value;
  case fault_kind::moved:
    return where + name + " becomes " + value + " under the pose";
  case fault_kind::rule:
    return where + "breaks the rule " + f.rule;
  }
  return "no fault";
}

} // namespace meetc
