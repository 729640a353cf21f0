#include "io/mesh_builder.hpp"

#include "io/error.hpp"

#include <fmt/format.h>

#include <numeric>
#include <utility>
#include <vector>

namespace meetc::io {

void mesh_builder::reserve(std::size_t vertices, std::size_t faces) {
  set_.data.reserve(3 * vertices);
  set_.index.reserve(3 * faces);
}

bool mesh_builder::add_face(std::span<const std::uint32_t> corners) {
  const std::size_t before = set_.index.size() / 3;
  const std::size_t added = corners.size() - 2;
  if (before + added > most_elements)
    return false;
  // Most meshes consist of triangles only, so owners are written from the first polygon on.
  if (added > 1 && set_.owner.empty()) {
    set_.owner.resize(before);
    std::iota(set_.owner.begin(), set_.owner.end(), 0U);
  }
  for (std::size_t i = 2; i < corners.size(); ++i)
    set_.index.insert(set_.index.end(), {corners[0], corners[i - 1], corners[i]});
  if (added > 1 || !set_.owner.empty())
    set_.owner.resize(before + added, static_cast<std::uint32_t>(set_.items));
  ++set_.items;
  return true;
}

element_set mesh_builder::finish(const std::string &file) {
  set_.vertices = vertices();
  set_.elements = set_.index.size() / 3;
  check_rules(set_, file, "face");
  return std::move(set_);
}

void check_rules(const element_set &set, const std::string &file, const char *item) {
  if (!set.kind->fault)
    return;
  std::vector<float> row(static_cast<std::size_t>(set.kind->fields));
  for (std::size_t i = 0; i < set.elements; ++i) {
    set.row(i, row.data());
    if (const char *const fault = set.kind->fault(row.data()))
      throw error(fmt::format("{}: {} {}: {}", file, item, set.owner_of(i), fault));
  }
}

} // namespace meetc::io
