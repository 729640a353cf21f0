// Which elements of one set may touch any of another, by marks on a grid.
//
// Problem: two meshes that reach into each other touch along a curve, and to put all of their elements into order takes longer
// than to answer. Method: the box in which both sets lie is cut into cells. One set marks the cells that its boxes meet, and of
// the other the elements that meet a marked cell are kept. A number's cell is a monotone function of it, so that boxes that
// touch share a cell, whatever is rounded; no bound is needed.
// An element of any size marks few cells: there are three levels of cells, each eight times as wide as the one before, and an
// element marks those of the first level of which it meets at most eight along each axis. A long element with two points marks
// the narrowest cells along its line instead, slab by slab.
// Limits: numbers are finite, as in box_of_row().
#ifndef MEETC_CULL_GRID_HPP
#define MEETC_CULL_GRID_HPP

#include <meetc/tree.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace meetc::cuda {

inline constexpr int cull_levels = 3, cull_shift = 3; // bits between two levels
inline constexpr int least_cull_bits = 3, most_cull_bits = 9;

// The box around some boxes, in numbers that are 0 where there are none and that maxima join.
struct joined_box {
  std::uint32_t below[3], above[3];
};
MEETC_HD inline std::uint32_t above_of(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  return b >> 31 ? ~b : b | 0x80000000U; // in the order of the numbers; no finite one is 0
}
MEETC_HD inline std::uint32_t below_of(float x) {
  return above_of(-x);
}
MEETC_HD inline float from_above(std::uint32_t bits) {
  const std::uint32_t b = bits >> 31 ? bits & 0x7fffffffU : ~bits;
  float x;
  std::memcpy(&x, &b, sizeof x);
  return x;
}
MEETC_HD inline tree_box box_of(const joined_box &of) {
  tree_box b; // empty
  for (int k = 0; k < 3 && of.above[k] != 0; ++k)
    b.low[k] = -from_above(of.below[k]), b.high[k] = from_above(of.above[k]);
  return b;
}

// Cells from the first to the last, both included.
struct cell_range {
  std::uint32_t first[3], last[3];

  MEETC_HD cell_range at(int level) const {
    cell_range r = *this;
    for (int k = 0; k < 3; ++k)
      r.first[k] >>= cull_shift * level, r.last[k] >>= cull_shift * level;
    return r;
  }
};

// 2^bits cells along each axis of the box that two sets have in common.
struct cull_grid {
  tree_box common; // may be empty
  double low[3], scale[3];
  int bits;

  cull_grid() = default;
  MEETC_HD cull_grid(const joined_box &a, const joined_box &b, int bits_) : bits(bits_) {
    const tree_box x = box_of(a), y = box_of(b);
    for (int k = 0; k < 3; ++k) {
      common.low[k] = x.low[k] > y.low[k] ? x.low[k] : y.low[k];
      common.high[k] = x.high[k] < y.high[k] ? x.high[k] : y.high[k];
      const double size = static_cast<double>(common.high[k]) - static_cast<double>(common.low[k]);
      low[k] = size > 0 ? common.low[k] : 0;
      scale[k] = size > 0 ? static_cast<double>(1U << bits) / size : 0;
    }
  }

  MEETC_HD double place(float x, int axis) const { return (static_cast<double>(x) - low[axis]) * scale[axis]; }
  MEETC_HD std::uint32_t cell(double place) const {
    const double last = static_cast<double>((1U << bits) - 1);
    return !(place > 0) ? 0 : static_cast<std::uint32_t>(place < last ? place : last);
  }
  MEETC_HD cell_range range(const tree_box &b) const {
    cell_range r{};
    for (int k = 0; k < 3; ++k)
      r.first[k] = cell(place(b.low[k], k)), r.last[k] = cell(place(b.high[k], k));
    return r;
  }
  // The level whose cells an element with these cells marks.
  MEETC_HD static int level_of(const cell_range &r) {
    int level = 0;
    for (; level + 1 < cull_levels; ++level) {
      const cell_range here = r.at(level);
      bool few = true;
      for (int k = 0; k < 3; ++k)
        few &= here.last[k] - here.first[k] < 8;
      if (few)
        break;
    }
    return level;
  }
};

// The marks of one set. For each level, `any` has the cells that its elements of this level and of those before meet, and `own`
// those that its elements of this level alone meet; of level 0 the two are one.
struct cull_marks {
  std::uint32_t *words;
  int bits; // of a cell along an axis, on level 0

  MEETC_HD static constexpr int bits_at(int bits, int level) {
    return bits > cull_shift * level ? bits - cull_shift * level : 0;
  }
  MEETC_HD static constexpr std::size_t words_at(int bits, int level) {
    const int cells = 3 * bits_at(bits, level);
    return cells > 5 ? std::size_t{1} << (cells - 5) : 1;
  }
  MEETC_HD static constexpr std::size_t words_for(int bits) {
    std::size_t all = words_at(bits, 0);
    for (int level = 1; level < cull_levels; ++level)
      all += 2 * words_at(bits, level);
    return all;
  }
  MEETC_HD std::uint32_t *any(int level) const {
    std::uint32_t *at = words;
    for (int before = 0; before < level; ++before)
      at += (before == 0 ? 1 : 2) * words_at(bits, before);
    return at;
  }
  MEETC_HD std::uint32_t *own(int level) const { return any(level) + (level == 0 ? 0 : words_at(bits, level)); }

  // Calls take(word, mask) for the cells of a range of this level, up to eight along x, until it returns true. Returns whether
  // it has.
  template <class Take> MEETC_HD bool each(const cell_range &r, int level, Take &&take) const {
    const int width = bits_at(bits, level);
    const std::uint64_t row = (std::uint64_t{2} << (r.last[0] - r.first[0])) - 1;
    for (std::uint32_t z = r.first[2]; z <= r.last[2]; ++z)
      for (std::uint32_t y = r.first[1]; y <= r.last[1]; ++y) {
        const std::uint32_t bit = ((z << width | y) << width) + r.first[0];
        const std::uint64_t mask = row << (bit & 31);
        if (take(bit >> 5, static_cast<std::uint32_t>(mask)) ||
            (mask >> 32 != 0 && take((bit >> 5) + 1, static_cast<std::uint32_t>(mask >> 32))))
          return true;
      }
    return false;
  }

  // Marks what an element with these cells meets; set(word, mask) sets bits of a word.
  template <class Set> MEETC_HD void mark(const cell_range &r, int level, Set &&set) const {
    for (int l = level; l < cull_levels; ++l) {
      const cell_range here = r.at(l);
      const auto put = [&](std::uint32_t *marks) {
        each(here, l, [&](std::uint32_t word, std::uint32_t mask) {
          set(marks + word, mask);
          return false;
        });
      };
      put(any(l));
      if (l == level && l > 0)
        put(own(l));
    }
  }
  // Whether an element with these cells may touch one that has marked its own.
  MEETC_HD bool meets(const cell_range &r, int level) const {
    for (int l = level; l < cull_levels; ++l) {
      const std::uint32_t *const marks = l == level ? any(l) : own(l);
      if (each(r.at(l), l, [&](std::uint32_t word, std::uint32_t mask) { return (marks[word] & mask) != 0; }))
        return true;
    }
    return false;
  }
};

// An element with two points.
struct line_ends {
  float from[3], to[3], radius;
};
template <class Shape> MEETC_HD inline line_ends ends_of_line(const float *row) {
  line_ends e{};
  for (int k = 0; k < 3; ++k) {
    const int from = Shape::coordinate(0, k), to = Shape::coordinate(1, k);
    e.from[k] = from >= 0 ? row[from] : 0, e.to[k] = to >= 0 ? row[to] : 0;
  }
  if constexpr (Shape::pad >= 0)
    e.radius = row[Shape::pad];
  return e;
}

// A segment with a radius, in the units of the cells. Its cells are those of which it meets what lies less than `width` around
// them. For each axis `width` is the radius and a margin: 2^-20 of a cell, and 2^-45 of the largest number that is computed
// with. A place is a difference of two float32 numbers times a factor, and all else here is some ten operations in double, so
// that the error of each number is below 2^-48 of the largest one.
struct cull_line {
  double from[3], to[3], width[3];
  int along; // the axis of its longest side

  MEETC_HD cull_line(const cull_grid &g, const line_ends &of) : along(0) {
    double largest = 0, longest = -1;
    for (int k = 0; k < 3; ++k) {
      from[k] = g.place(of.from[k], k), to[k] = g.place(of.to[k], k);
      width[k] = static_cast<double>(of.radius) * g.scale[k];
      const double all = std::fabs(from[k]) + std::fabs(to[k]) + width[k], side = std::fabs(to[k] - from[k]);
      largest = all > largest ? all : largest;
      if (side > longest)
        longest = side, along = k;
    }
    for (double &w : width)
      w += 0x1p-20 + 0x1p-45 * largest;
  }
  // Whether its slabs have few cells each.
  MEETC_HD bool is_thin() const { return width[0] < 2 && width[1] < 2 && width[2] < 2; }

  // The first and the last slab, cells with one number on the axis `along`.
  MEETC_HD std::uint32_t first_slab(const cull_grid &g) const {
    return g.cell((from[along] < to[along] ? from[along] : to[along]) - width[along]);
  }
  MEETC_HD std::uint32_t last_slab(const cull_grid &g) const {
    return g.cell((from[along] < to[along] ? to[along] : from[along]) + width[along]);
  }
  // The cells of a slab that it meets. Of the outermost slabs and cells all that lies beyond them is a part.
  MEETC_HD cell_range in_slab(const cull_grid &g, std::uint32_t slab) const {
    double begin = 0, end = 1;
    const double way = to[along] - from[along], all = way < 0 ? -way : way;
    if (all > 0x1p-20) {
      const double low = slab - width[along] - from[along], high = slab + 1 + width[along] - from[along];
      const double enter = (way < 0 ? high : low) / way, leave = (way < 0 ? low : high) / way;
      const bool outer_low = slab == 0, outer_high = slab == (1U << g.bits) - 1;
      begin = enter > 0 && !(way < 0 ? outer_high : outer_low) ? (enter < 1 ? enter : 1) : 0;
      end = leave < 1 && !(way < 0 ? outer_low : outer_high) ? (leave > 0 ? leave : 0) : 1;
    }
    cell_range r{};
    for (int k = 0; k < 3; ++k) {
      const double x = from[k] + begin * (to[k] - from[k]), y = from[k] + end * (to[k] - from[k]);
      r.first[k] = k == along ? slab : g.cell((x < y ? x : y) - width[k]);
      r.last[k] = k == along ? slab : g.cell((x < y ? y : x) + width[k]);
    }
    return r;
  }
};

} // namespace meetc::cuda

#endif
