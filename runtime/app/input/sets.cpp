#include "meet/app/input/sets.hpp"

namespace meetc::app {

prepared prepare(const io::element_set &set, int threads, const prepared *counterpart, double grid) {
  pose at;
  at.grid = grid;
  return meetc::prepare(view_of(set), *set.kind, at, threads, counterpart);
}

} // namespace meetc::app
