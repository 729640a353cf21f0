#include "meet/app/inspect/inspection.hpp"

#include "meet/core/views/collinear.hpp"
#include "meet/core/views/pose.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace meetc::app {

namespace {

// The least height of a triangle, the length of a segment, or the least side of a box; 0 for other kinds.
double size_of(const kind_info &kind, const float *row) {
  if (lies_along_axes(kind)) {
    float lo[3], hi[3];
    kind.box(row, lo, hi);
    double least = HUGE_VAL;
    for (int k = 0; k < 3; ++k)
      least = std::min(least, static_cast<double>(hi[k]) - static_cast<double>(lo[k]));
    return least;
  }
  double edge[3][3] = {}; // from each point to the next one
  for (int p = 0; p < kind.points; ++p)
    for (int k = 0; k < 3; ++k)
      edge[p][k] = static_cast<double>(row[3 * ((p + 1) % kind.points) + k]) - static_cast<double>(row[3 * p + k]);
  const auto length = [](const double *v) { return std::hypot(v[0], v[1], v[2]); };
  if (kind.points < 3)
    return kind.points == 2 ? length(edge[0]) : 0;
  const double longest = std::max({length(edge[0]), length(edge[1]), length(edge[2])});
  if (longest == 0)
    return 0;
  double area[3], *const x = edge[0], *const y = edge[1]; // twice the area, relative to the longest edge
  for (int k = 0; k < 3; ++k)
    area[k] = x[(k + 1) % 3] / longest * y[(k + 2) % 3] - x[(k + 2) % 3] / longest * y[(k + 1) % 3];
  return length(area);
}

void widen(box &b, const float lo[3], const float hi[3]) {
  const bool first = b.lo[0] > b.hi[0];
  for (int k = 0; k < 3; ++k) {
    b.lo[k] = first ? lo[k] : std::min(b.lo[k], lo[k]);
    b.hi[k] = first ? hi[k] : std::max(b.hi[k], hi[k]);
  }
}

// Counts items among elements. The elements of one item follow each other.
class item_counter {
public:
  explicit item_counter(const io::element_set &set) : set_(set) {}
  void add(std::size_t element) {
    const std::size_t item = set_.owner_of(element);
    count_ += !any_ || item != last_;
    last_ = item;
    any_ = true;
  }
  std::size_t count() const { return count_; }

private:
  const io::element_set &set_;
  std::size_t count_ = 0, last_ = 0;
  bool any_ = false;
};

// The row with its points sorted and without negative zeros, so that equal elements have equal rows.
std::array<float, 9> canonical(const io::element_set &set, std::size_t i) {
  std::array<float, 9> row{};
  set.row(i, row.data());
  for (float &v : row)
    v = v == 0 ? 0.0f : v;
  const int points = set.kind->points;
  std::array<std::array<float, 3>, 3> p{};
  for (std::size_t k = 0; k < 9; ++k)
    p[k / 3][k % 3] = row[k];
  if (points > 1 && p[1] < p[0])
    std::swap(p[0], p[1]);
  if (points > 2) {
    if (p[2] < p[1])
      std::swap(p[1], p[2]);
    if (p[1] < p[0])
      std::swap(p[0], p[1]);
  }
  for (std::size_t k = 0; k < 9; ++k)
    row[k] = p[k / 3][k % 3];
  return row;
}

std::size_t duplicates(const io::element_set &set) {
  struct entry {
    std::array<float, 9> row;
    std::size_t element;
    bool operator<(const entry &o) const { return row != o.row ? row < o.row : element < o.element; }
  };
  std::vector<entry> all(set.elements);
  for (std::size_t i = 0; i < set.elements; ++i)
    all[i] = {canonical(set, i), i};
  std::sort(all.begin(), all.end());
  std::vector<std::size_t> repeats;
  for (std::size_t i = 1, first = 0; i < all.size(); ++i) {
    if (all[i].row != all[first].row)
      first = i;
    else if (set.owner_of(all[i].element) != set.owner_of(all[first].element))
      repeats.push_back(all[i].element);
  }
  std::sort(repeats.begin(), repeats.end());
  item_counter count(set);
  for (const std::size_t e : repeats)
    count.add(e);
  return count.count();
}

std::size_t unused_vertices(const io::element_set &set) {
  if (set.vertices == 0 || (set.index.empty() && set.elements > 0))
    return 0;
  std::vector<bool> used(set.vertices);
  for (const std::uint32_t v : set.index)
    used[v] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

} // namespace

inspection inspection_of(const io::element_set &set) {
  inspection f;
  const kind_info &kind = *set.kind;
  item_counter areas(set), lengths(set), radii(set), flat(set);
  std::array<float, 9> row{};
  for (std::size_t i = 0; i < set.elements; ++i) {
    set.row(i, row.data());
    float lo[3], hi[3];
    kind.box(row.data(), lo, hi);
    widen(f.bounds, lo, hi);
    for (int p = 0; p + 2 < kind.fields; ++p)
      if (kind.roles[p] == role::x)
        widen(f.points, &row[static_cast<std::size_t>(p)], &row[static_cast<std::size_t>(p)]);
    f.numbers = around(f.numbers, grid_of(row.data(), kind.fields));
    if (kind.points == 3 && collinear(row.data()))
      areas.add(i);
    if (kind.points == 2 && std::equal(row.begin(), row.begin() + 3, row.begin() + 3))
      lengths.add(i);
    if (const double size = size_of(kind, row.data()); size > 0)
      f.least_size = std::min(f.least_size, size);
    else if (lies_along_axes(kind))
      flat.add(i);
    for (int k = 0; k < kind.fields; ++k) {
      const double v = std::abs(row[static_cast<std::size_t>(k)]);
      const bool is_length = kind.roles[k] == role::length;
      f.reach = std::max(f.reach, is_length ? v / 2 : v);
      if (is_length && v == 0)
        radii.add(i);
      if (is_length && v > 0)
        f.least_size = std::min(f.least_size, v);
    }
  }
  f.zero_area = areas.count();
  f.zero_length = lengths.count();
  f.zero_radius = radii.count();
  f.flat = flat.count();
  f.duplicates = duplicates(set);
  f.unused_vertices = unused_vertices(set);
  return f;
}

std::optional<int> difference_bits(const box &points, const grid &numbers) {
  if (points.lo[0] > points.hi[0])
    return std::nullopt;
  double most = 0;
  for (int k = 0; k < 3; ++k)
    most = std::max(most, static_cast<double>(points.hi[k]) - static_cast<double>(points.lo[k]));
  if (most == 0 || numbers.bits() == 0)
    return 0;
  // In double the difference is exact below 2^53 steps. Above that, rounding cannot cross a power of two.
  int exponent = 0;
  const double fraction = std::frexp(most, &exponent);
  return std::max(0, (fraction == 0.5 ? exponent - 1 : exponent) - numbers.low);
}

double box_for(const inspection &x, const inspection &y) {
  int exponent = 0;
  const double reach = std::max(x.reach, y.reach), fraction = std::frexp(reach, &exponent);
  if (reach == 0 || exponent > 127)
    return 0;
  return std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
}

box around(const box &x, const box &y) {
  if (y.lo[0] > y.hi[0])
    return x;
  box out = x;
  widen(out, y.lo, y.hi);
  return out;
}

grid around(const grid &x, const grid &y) {
  return {std::min(x.low, y.low), std::max(x.high, y.high)};
}

} // namespace meetc::app
