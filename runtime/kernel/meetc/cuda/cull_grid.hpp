// Finds the elements of one set that may touch an element of another, by marks on a grid.
//
// Problem: two meshes that reach into each other touch along a curve, and sorting all of their elements takes longer
// than answering. Method: the common part of both sets' boxes is cut into cells. One set marks the cells that its boxes
// meet; the other keeps its elements that meet a marked cell. A number's cell is a monotone function of it, so boxes
// that touch share a cell, whatever is rounded; no bound is needed. An element of any size marks few cells: there are
// three levels of cells, each eight times as wide as the one before, and an element marks cells of the first level on
// which it meets at most eight along each axis. Small elements, those of the first level, are kept if they meet a mark
// of any level; larger ones always. A long element with two points marks the narrowest cells along its line instead,
// slab by slab.
// Limits: numbers are finite, as in box_of_row().
#ifndef MEETC_CUDA_CULL_GRID_HPP
#define MEETC_CUDA_CULL_GRID_HPP

#include <meetc/cuda/joined_box.hpp>

namespace meetc::cuda {

inline constexpr int cull_levels = 3, cull_shift = 3; // bits between two levels

// The cells of a point along the axes, 10 bits each: 0 lies before all cells, 1 is the first cell, and one number more
// than there are cells lies behind them.
struct packed_cells {
  std::uint32_t bits;
  MEETC_HD std::uint32_t at(int axis) const { return bits >> (10 * axis) & 1023; }
};
inline constexpr std::uint32_t no_cells = ~0U; // instead of packed_cells: not a point

// Cells from the first to the last, both included.
struct cell_range {
  std::uint32_t first[3], last[3];

  MEETC_HD cell_range at(int level) const {
    cell_range r = *this;
    for (int k = 0; k < 3; ++k)
      r.first[k] >>= cull_shift * level, r.last[k] >>= cull_shift * level;
    return r;
  }
  // Whether it has at most eight cells of this level along each axis.
  MEETC_HD bool is_short(int level) const {
    bool few = true;
    for (int k = 0; k < 3; ++k)
      few &= (last[k] >> cull_shift * level) - (first[k] >> cull_shift * level) < 8;
    return few;
  }
  MEETC_HD int level() const { return is_short(0) ? 0 : is_short(1) ? 1 : 2; }
};

// 2^bits cells along each axis of the common box of two sets, which may be empty.
struct cull_grid {
  float from[3], to[3];
  double low[3], scale[3];
  int bits;

  cull_grid() = default;
  MEETC_HD cull_grid(const joined_box &a, const joined_box &b, int bits_) : bits(bits_) {
    const tree_box all = common_box(a, b);
    for (int k = 0; k < 3; ++k) {
      from[k] = all.low[k], to[k] = all.high[k];
      const double size = static_cast<double>(to[k]) - static_cast<double>(from[k]);
      low[k] = size > 0 ? from[k] : 0;
      scale[k] = size > 0 ? static_cast<double>(1U << bits) / size : 0;
    }
  }

  MEETC_HD double place(float x, int axis) const { return (static_cast<double>(x) - low[axis]) * scale[axis]; }
  // The cell nearest to a place.
  MEETC_HD std::uint32_t cell(double place) const {
    const double last = static_cast<double>((1U << bits) - 1);
    return !(place > 0) ? 0 : static_cast<std::uint32_t>(place < last ? place : last);
  }
  // The number of a cell in packed_cells.
  MEETC_HD std::uint32_t packed(float x, int axis) const {
    return x < from[axis] ? 0 : x > to[axis] ? (1U << bits) + 1 : cell(place(x, axis)) + 1;
  }
  MEETC_HD packed_cells cells_of(const float *point) const {
    packed_cells c{0};
    for (int k = 0; k < 3; ++k)
      c.bits |= packed(point[k], k) << (10 * k);
    return c;
  }
  // The cells that a box with these cells at its ends meets. Returns false if it lies beside all cells.
  MEETC_HD bool range(const std::uint32_t (&least)[3], const std::uint32_t (&greatest)[3], cell_range &out) const {
    const std::uint32_t last = 1U << bits;
    bool meets = true;
    for (int k = 0; k < 3; ++k) {
      meets &= (greatest[k] >= 1) & (least[k] <= last);
      out.first[k] = (least[k] > 1 ? least[k] : 1) - 1, out.last[k] = (greatest[k] < last ? greatest[k] : last) - 1;
    }
    return meets;
  }
  MEETC_HD bool range(const tree_box &b, cell_range &out) const {
    std::uint32_t least[3], greatest[3];
    for (int k = 0; k < 3; ++k)
      least[k] = packed(b.low[k], k), greatest[k] = packed(b.high[k], k);
    return range(least, greatest, out);
  }
};

// The marks of one set: for each level the cells that its elements of this level meet. A word follows with a bit for
// each level that has marks.
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
    return words_at(bits, 0) + words_at(bits, 1) + words_at(bits, 2) + 1;
  }
  MEETC_HD std::uint32_t *levels() const { return words + words_for(bits) - 1; }
  MEETC_HD std::uint32_t *of(int level) const {
    return words + (level > 0 ? words_at(bits, 0) : 0) + (level > 1 ? words_at(bits, 1) : 0);
  }

  // Calls take(word, mask) for the cells of a range of this level, up to some twenty along x, until it returns true. Returns
  // whether it has.
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
  // Marks the cells of an element of this level; set(word, mask) sets bits of a word.
  template <class Set> MEETC_HD void mark(const cell_range &r, int level, Set &&set) const {
    std::uint32_t *const marks = of(level);
    each(r.at(level), level, [&](std::uint32_t word, std::uint32_t mask) {
      set(marks + word, mask);
      return false;
    });
    set(levels(), 1U << level);
  }
  // Whether an element of level 0 with these cells may touch one that has marked its own. `some` is *levels().
  MEETC_HD bool meets(const cell_range &r, std::uint32_t some) const {
    for (int level = 0; level < cull_levels; ++level) {
      const std::uint32_t *const marks = of(level);
      if ((some >> level & 1) != 0 &&
          each(r.at(level), level, [&](std::uint32_t word, std::uint32_t mask) { return (marks[word] & mask) != 0; }))
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

// A segment with a radius, in the units of the cells. It marks a cell if it meets the cell widened by `width` on all
// sides. For each axis `width` is the radius and a margin: 2^-20 of a cell, and 2^-45 of the largest number in the
// computation. A place is a difference of two float32 numbers times a factor, and some ten operations in double follow,
// so the error of each number is below 2^-48 of the largest one. The largest is a number of the line, which the second
// term of the margin covers, or the number of a cell or a place of the other box, which is at most 2^9, and which the
// first term covers.
struct cull_line {
  double from[3], way[3], width[3], // the first point, and the way from it to the second
      per;                          // 1 / way[along], or 0 if that way is short
  int along;                        // the axis of the longest way

  MEETC_HD cull_line(const cull_grid &g, const line_ends &of) : along(0) {
    double largest = 0, longest = -1;
    for (int k = 0; k < 3; ++k) {
      const double to = g.place(of.to[k], k);
      from[k] = g.place(of.from[k], k), way[k] = to - from[k], width[k] = static_cast<double>(of.radius) * g.scale[k];
      const double all = std::fabs(from[k]) + std::fabs(to) + width[k], side = std::fabs(way[k]);
      largest = all > largest ? all : largest;
      if (side > longest)
        longest = side, along = k;
    }
    per = longest > 0x1p-20 ? 1 / way[along] : 0;
    for (double &w : width)
      w += 0x1p-20 + 0x1p-45 * largest;
  }
  // Whether its slabs have few cells each.
  MEETC_HD bool is_thin(double most = 2) const { return width[0] < most && width[1] < most && width[2] < most; }

  // The first and the last slab, cells with one number on the axis `along`.
  MEETC_HD std::uint32_t first_slab(const cull_grid &g) const {
    return g.cell((way[along] < 0 ? from[along] + way[along] : from[along]) - width[along]);
  }
  MEETC_HD std::uint32_t last_slab(const cull_grid &g) const {
    return g.cell((way[along] < 0 ? from[along] : from[along] + way[along]) + width[along]);
  }
  // The cells that it meets in a slab. Parts outside the grid count for the outermost cells, since they touch nothing.
  MEETC_HD cell_range in_slab(const cull_grid &g, std::uint32_t slab) const {
    double begin = 0, end = 1;
    if (per != 0) {
      const double low = (slab - width[along] - from[along]) * per,
                   high = (slab + 1 + width[along] - from[along]) * per, enter = per < 0 ? high : low,
                   leave = per < 0 ? low : high;
      begin = enter > 0 ? (enter < 1 ? enter : 1) : 0;
      end = leave < 1 ? (leave > 0 ? leave : 0) : 1;
    }
    cell_range r{};
    for (int k = 0; k < 3; ++k) {
      const double x = from[k] + begin * way[k], y = from[k] + end * way[k];
      r.first[k] = k == along ? slab : g.cell((x < y ? x : y) - width[k]);
      r.last[k] = k == along ? slab : g.cell((x < y ? y : x) + width[k]);
    }
    return r;
  }
};

} // namespace meetc::cuda

#endif
