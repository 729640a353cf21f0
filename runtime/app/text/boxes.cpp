#include "meet/app/text/boxes.hpp"

namespace meetc::app {

bool is_empty(const box &b) {
  return b.lo[0] > b.hi[0];
}

bool disjoint(const box &x, const box &y) {
  bool apart = false;
  for (int k = 0; k < 3; ++k)
    apart = apart || x.hi[k] < y.lo[k] || y.hi[k] < x.lo[k];
  return apart && !is_empty(x) && !is_empty(y);
}

bool inside(const box &inner, const box &outer) {
  bool in = !is_empty(inner) && !is_empty(outer);
  for (int k = 0; k < 3; ++k)
    in = in && outer.lo[k] <= inner.lo[k] && inner.hi[k] <= outer.hi[k];
  return in;
}

} // namespace meetc::app
