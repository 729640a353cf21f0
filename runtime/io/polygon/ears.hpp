// Cuts a polygon of any shape into triangles, by exact signs of its projection.
//
// The winding number of a point is the number of triangles that cover it, if every triangle turns left, whatever their
// order: their boundaries add up to the polygon's. A triangle without area is the two edges that it takes. So if no
// triangle turns right, their closed union is the polygon's inside with all of its edges, which also holds for a bridge
// to a hole, for repeated corners and for spikes. Only this is tested; the choice of ears decides only whether all are
// found.
#ifndef MEETC_IO_POLYGON_EARS_HPP
#define MEETC_IO_POLYGON_EARS_HPP

#include "meet/io/polygon/plane.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace meetc::io {

class ear_cutter {
public:
  // Writes n - 2 triangles, 3 numbers of corners each, for n >= 3 corners with the inside to their left. If the fan
  // from the first corner turns right nowhere, as for every convex polygon, it is taken. If no ear is left, because the
  // polygon crosses itself, the rest is fanned, and the result is false.
  bool cut(std::span<const projected> corners, std::uint32_t *triangles);

private:
  int turn_at(std::uint32_t b) { return turn(p_[prev_[b]], p_[b], p_[next_[b]], room_); }
  bool fan();
  bool is_spike(std::uint32_t b);
  bool blocks(std::uint32_t edge, std::uint32_t b, bool strict);
  bool is_ear(std::uint32_t b, bool strict);
  bool find(std::uint32_t &b);
  void clip(std::uint32_t b);
  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  std::span<const projected> p_;
  std::vector<std::uint32_t> prev_, next_, blocker_, spikes_;
  std::vector<char> alive_;
  std::size_t left_ = 0;
  std::uint32_t *out_ = nullptr;
  exact_sum room_;
};

} // namespace meetc::io

#endif
