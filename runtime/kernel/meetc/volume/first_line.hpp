// A segment on its way down a hierarchy, no farther than the nearest element that it is proved to meet.
//
// Problem: of all that a long segment meets only the first is asked. Method: the nearest boxes first, and none that the segment
// enters later than it has left the box of an element that it is proved to meet. Both are said by parameters t of the points
// p + t (q - p), computed and compared as in meetc/volume/two_points.hpp: an element is left out only if
//   max(0, entries of one box around it) >
//     fl(fl(min(1, exits of that box, exits of the boxes of proved hits) * (1 + 5 * 2^-23)) + 2^-126).
//
// Theorem. It then meets nothing, or strictly later than one of these hits.
// Proof. Let the element be met first at t, and one of these hits at u, and let t <= u. (If p = q, let t = u = 0.) The point of
// t lies in each box around the element, and that of u in the box of the hit. So the true entries are at most t, and the
// true exits of both boxes at least t, and 0 <= t <= 1. The theorem of two_points.hpp compares an entry and an exit of
// which it uses no more than that: the entry is at most t <= 1 and the exit at least t >= 0. Thus no computed entry exceeds the
// right side for any of these exits, nor for their minimum, since its rounded operations are monotone. A hit that is met at
// the same point, whose number may be the lesser one, therefore stays.
//
// Where |q - p| along an axis has no reciprocal in float32 (it lies between 0 and 2^-126, or exceeds 2^126), the axis is that
// of a box: `per` is infinite, and a side that lies beyond both ends gives an infinity of the sign that separates; any other
// gives NaN or an infinity that does not. So every axis tells something, and an empty box is left out by each.
#ifndef MEETC_VOLUME_FIRST_LINE_HPP
#define MEETC_VOLUME_FIRST_LINE_HPP

#include <meetc/volume/fours.hpp>
#include <meetc/volume/two_points.hpp>

namespace meetc::cuda {

// A key is the number at which a child of a node is entered, but for its two lowest bits, which are the child. Those of
// children that are left out exceed all others.
inline constexpr std::uint32_t left_out = ~std::uint32_t{0};

class first_line {
public:
  first_line() = default;
  // Rows: p and q, finite.
  MEETC_HD explicit first_line(const float *row) : line_(two_points_of({{0, 1, 2, 3, 4, 5}, -1}, row)) {
    for (int k = 0; k < 3; ++k)
      if (!(line_.per[k] == line_.per[k])) {
        line_.enter[k] = most_of(row[k], row[3 + k]), line_.leave[k] = least_of(row[k], row[3 + k]);
        line_.per[k] = HUGE_VALF;
      }
  }

  // The keys of the four children.
  MEETC_HD void enter(const four_boxes &node, std::uint32_t (&keys)[4]) const {
    float in[4] = {0, 0, 0, 0}, out[4] = {end_, end_, end_, end_};
    for (int k = 0; k < 3; ++k) {
      const bool down = line_.per[k] < 0;
      const four_ends first = node.of[k][down], last = node.of[k][!down];
      for (int c = 0; c < 4; ++c) { // NaN is the lesser and the greater of no two numbers
        in[c] = fmaxf(in[c], (first.of[c] - line_.enter[k]) * line_.per[k]);
        out[c] = fminf(out[c], (last.of[c] - line_.leave[k]) * line_.per[k]);
      }
    }
    for (unsigned c = 0; c < 4; ++c)
      keys[c] = in[c] > bound_of(out[c]) ? left_out : (bits_of(in[c]) & ~3U) | c;
  }
  // The element in the box of this lane is proved to be met.
  MEETC_HD void meets(const four_boxes &node, unsigned lane) {
    float out = end_;
    for (int k = 0; k < 3; ++k)
      out = fminf(out, (node.of[k][!(line_.per[k] < 0)].of[lane] - line_.leave[k]) * line_.per[k]);
    end_ = out;
  }

private:
  MEETC_HD static float bound_of(float exit) { return exit * parameter_margin().factor + parameter_margin().term; }
  MEETC_HD static std::uint32_t bits_of(float x) {
    std::uint32_t b;
    std::memcpy(&b, &x, sizeof b);
    return b;
  }

  two_points line_;
  float end_ = 1; // the least exit of a box of a proved hit, or 1
};

// Puts keys into their order, the least first.
MEETC_HD inline void order_keys(std::uint32_t (&keys)[4]) {
  const auto order = [&keys](int i, int j) {
    const std::uint32_t x = keys[i], y = keys[j];
    keys[i] = x < y ? x : y, keys[j] = x < y ? y : x;
  };
  order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
}

} // namespace meetc::cuda

#endif
