#include "meet/core/views/check.hpp"

#include "meet/core/views/rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

namespace meetc {

namespace {

fault first_fault(const view &elements, const kind_info &kind, const pose &at) {
  if (const char *const wrong = wrong_with(elements, kind)) {
    fault f;
    f.kind = fault_kind::view;
    f.rule = wrong;
    return f;
  }
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
    if (at.grid != 0) {
      pose unrounded = at;
      unrounded.grid = 0;
      gather(elements, kind, unrounded, e, e + 1, row.data());
      if (first_bad() == kind.fields)
        f.kind = fault_kind::rounded, f.grid = at.grid;
    }
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

std::string one_line(const fault &f, const kind_info &kind) {
  const std::string where = "element " + std::to_string(f.element) + ": ";
  std::string_view names = kind.csv;
  for (int i = 0; i < f.field && f.kind != fault_kind::index; ++i)
    names.remove_prefix(std::min(names.find(','), names.size() - 1) + 1);
  const std::string name(names.substr(0, names.find(',')));
  char digits[32]; // by std::to_chars, as the C library's printf rounds by the x87's word
  const std::string value(digits, std::to_chars(digits, std::end(digits), f.value, std::chars_format::general, 6).ptr);
  switch (f.kind) {
  case fault_kind::none:
    break;
  case fault_kind::view:
    return f.rule;
  case fault_kind::index:
    return where + "index " + std::to_string(f.index) + " of point " + std::to_string(f.field) +
           " lies beyond the vertices";
  case fault_kind::value:
    return where + name + " is " + value;
  case fault_kind::moved:
    return where + name + " becomes " + value + " under the pose";
  case fault_kind::rounded:
    return where + name + " becomes " + value + ", rounded to a multiple of 2^" + std::to_string(std::ilogb(f.grid));
  case fault_kind::rule:
    return where + "breaks the rule " + f.rule;
  case fault_kind::unheld:
    return where + name + " is " + value + " as a float32, and was given otherwise";
  }
  return "no fault";
}

} // namespace

fault check(const view &elements, const kind_info &kind, const pose &at) {
  return under_standard_word([&] { return first_fault(elements, kind, at); });
}

std::string describe(const fault &f, const kind_info &kind) {
  return under_standard_word([&] { return one_line(f, kind); });
}

} // namespace meetc
