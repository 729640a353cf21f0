// core/hierarchy/box.hpp: closed boxes, and the test of one box against sixteen.
//
// Two boxes are apart only where a comparison says so; a NaN on either side therefore makes a candidate. Boxes are
// stored in blocks of sixteen, coordinate by coordinate, and the test is a plain loop over the lanes that every
// compiler in use vectorises. Sanitised boxes are finite, which loses no candidate (clamping is monotone). An empty
// lane, from +inf to -inf, touches none of them.
#ifndef MEETC_CORE_HIERARCHY_BOX_HPP
#define MEETC_CORE_HIERARCHY_BOX_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace meetc {

struct box {
  float lo[3], hi[3];
};

// Whether a comparison says so.
inline bool apart(const box &x, const box &y) {
  bool found = false;
  for (int k = 0; k < 3; ++k)
    found |= (x.hi[k] < y.lo[k]) | (y.hi[k] < x.lo[k]);
  return found;
}

// Widens an interval to one that is finite; NaN becomes an end of float32.
inline void make_finite(float &lo, float &hi) {
  constexpr float most = std::numeric_limits<float>::max();
  lo = lo > -most ? lo : -most;
  lo = lo < most ? lo : most;
  hi = hi < most ? hi : most;
  hi = hi > -most ? hi : -most;
}

inline constexpr int lanes = 16;

struct alignas(64) box_block {
  float lo[3][lanes], hi[3][lanes];

  // Empties the lanes from `lane` on.
  void clear(int lane = 0) {
    for (int k = 0; k < 3; ++k) {
      std::fill(lo[k] + lane, lo[k] + lanes, std::numeric_limits<float>::infinity());
      std::fill(hi[k] + lane, hi[k] + lanes, -std::numeric_limits<float>::infinity());
    }
  }
  // Makes the boxes of the first lanes finite, and the others empty.
  void sanitise(int filled) {
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < lanes; ++i)
        make_finite(lo[k][i], hi[k][i]);
    clear(filled);
  }
  // Turns the ends lo[3] and hi[3] of four boxes into the lanes from `lane` on.
  void turn(const float *ends, int lane) {
    typedef float four __attribute__((vector_size(16)));
    const auto columns = [](const float *at, float *const(&to)[4]) {
      four r[4];
      for (int i = 0; i < 4; ++i)
        std::memcpy(&r[i], at + std::ptrdiff_t{6} * i, sizeof r[i]);
      const four x = __builtin_shufflevector(r[0], r[1], 0, 4, 1, 5),
                 y = __builtin_shufflevector(r[2], r[3], 0, 4, 1, 5),
                 z = __builtin_shufflevector(r[0], r[1], 2, 6, 3, 7),
                 w = __builtin_shufflevector(r[2], r[3], 2, 6, 3, 7);
      const four out[4] = {__builtin_shufflevector(x, y, 0, 1, 4, 5), __builtin_shufflevector(x, y, 2, 3, 6, 7),
                           __builtin_shufflevector(z, w, 0, 1, 4, 5), __builtin_shufflevector(z, w, 2, 3, 6, 7)};
      for (int k = 0; k < 4; ++k)
        std::memcpy(to[k], &out[k], sizeof out[k]);
    };
    columns(ends, {lo[0] + lane, lo[1] + lane, lo[2] + lane, hi[0] + lane});
    columns(ends + 2, {lo[2] + lane, hi[0] + lane, hi[1] + lane, hi[2] + lane});
  }
  // Takes the ends lo[3] and hi[3] of one box after another into the first lanes, and makes them finite; the others become
  // empty.
  void take(const float *ends, int filled) {
    constexpr std::ptrdiff_t sides = 6;
    if (filled == lanes)
      for (int i = 0; i < lanes; i += 4)
        turn(ends + sides * i, i);
    else
      for (int i = 0; i < filled; ++i, ends += sides)
        set(i, {{ends[0], ends[1], ends[2]}, {ends[3], ends[4], ends[5]}});
    sanitise(filled);
  }
  void set(int lane, const box &b) {
    for (int k = 0; k < 3; ++k) {
      lo[k][lane] = b.lo[k];
      hi[k][lane] = b.hi[k];
    }
  }
  box get(int lane) const { return {{lo[0][lane], lo[1][lane], lo[2][lane]}, {hi[0][lane], hi[1][lane], hi[2][lane]}}; }
  // The box around all lanes: halves of the lanes are compared, then halves of those, in loops without a dependence.
  box around() const {
    box b;
    for (int k = 0; k < 3; ++k) {
      float least[lanes], most[lanes];
      std::copy_n(lo[k], lanes, least);
      std::copy_n(hi[k], lanes, most);
      for (int half = lanes / 2; half > 0; half /= 2)
        for (int i = 0; i < half; ++i) {
          least[i] = least[i + half] < least[i] ? least[i + half] : least[i];
          most[i] = most[i] < most[i + half] ? most[i + half] : most[i];
        }
      b.lo[k] = least[0], b.hi[k] = most[0];
    }
    return b;
  }
};

// A finite box that is no smaller; NaN becomes the widest box.
inline box sanitised(box b) {
  for (int k = 0; k < 3; ++k)
    make_finite(b.lo[k], b.hi[k]);
  return b;
}

inline constexpr std::uint32_t lane_bit[lanes] = {1,      2,      4,       8,       1 << 4,  1 << 5,  1 << 6,  1 << 7,
                                                  1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};

// Bit i is set where lane i of the block may touch q.
inline std::uint32_t touching(const box_block &block, const box &q) {
  std::uint32_t mask = 0;
  for (int i = 0; i < lanes; ++i) {
    const bool apart = (q.hi[0] < block.lo[0][i]) | (block.hi[0][i] < q.lo[0]) | (q.hi[1] < block.lo[1][i]) |
                       (block.hi[1][i] < q.lo[1]) | (q.hi[2] < block.lo[2][i]) | (block.hi[2][i] < q.lo[2]);
    mask |= apart ? 0 : lane_bit[i];
  }
  return mask;
}

} // namespace meetc

#endif
