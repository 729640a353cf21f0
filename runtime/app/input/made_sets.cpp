#include "meet/app/input/made_sets.hpp"

#include "meet/app/input/failure.hpp"

#include <fmt/format.h>

#include <utility>

namespace meetc::app {

static const kind_info &kind_named(const catalogue &all, std::string_view name) {
  for (int i = 0; i < all.kind_count; ++i)
    if (all.kinds[i].name == name)
      return all.kinds[i];
  throw failure(fmt::format("this build has no kind '{}'", name));
}

io::element_set of_mesh(const catalogue &all, bodies::mesh m, const io::transform &move) {
  for (std::size_t v = 0; move.any() && v < m.xyz.size(); v += 3) {
    const auto p = io::round_point(move, {m.xyz[v], m.xyz[v + 1], m.xyz[v + 2]});
    m.xyz[v] = p[0];
    m.xyz[v + 1] = p[1];
    m.xyz[v + 2] = p[2];
  }
  io::element_set set;
  set.kind = &kind_named(all, "triangle");
  set.vertices = m.vertices();
  set.elements = set.items = m.triangles();
  set.data = std::move(m.xyz);
  set.index = std::move(m.index);
  return set;
}

io::element_set of_rows(const catalogue &all, std::string_view kind, std::vector<float> rows) {
  io::element_set set;
  set.kind = &kind_named(all, kind);
  set.elements = set.items = rows.size() / static_cast<std::size_t>(set.kind->fields);
  set.data = std::move(rows);
  return set;
}

} // namespace meetc::app
