#include "meet/app/input/sets.hpp"

namespace meetc::app {

meetc::view view_of(const io::element_set &set) {
  meetc::view v;
  v.data = set.data.data();
  v.elements = set.elements;
  if (set.index.empty()) {
    v.stride_bytes = static_cast<std::size_t>(set.kind->fields) * sizeof(float);
    return v;
  }
  v.vertices = set.data.size() / 3;
  v.stride_bytes = 3 * sizeof(float);
  v.index = set.index.data();
  return v;
}

prepared prepare(const io::element_set &set, int threads, const prepared *counterpart, double grid) {
  pose at;
  at.grid = grid;
  return meetc::prepare(view_of(set), *set.kind, at, threads, counterpart);
}

} // namespace meetc::app
