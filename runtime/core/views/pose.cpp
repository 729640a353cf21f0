#include "meet/core/views/pose.hpp"

#include "meet/core/views/moved_coordinate.hpp"
#include "meetc/decide/tolerant.hpp"

#include <cmath>
#include <cstring>

namespace meetc {

namespace {

bool is_power(double grid) {
  int exponent = 0;
  return grid == 0 || (grid >= 0x1p-149 && grid <= 0x1p127 && std::frexp(grid, &exponent) == 0.5);
}

double moved_by(const predicate_info &predicate, double grid) {
  const bool surface = std::strcmp(predicate.mode, "surface") == 0;
  double steps = 0;
  for (const kind_info *const k : {predicate.a, predicate.b}) {
    if (k->hull == 0 || (surface && k->hull > 1) || !can_move(*k))
      return 0;
    bool has_z = false;
    for (int i = 0; i < k->fields; ++i)
      has_z |= k->roles[i] == role::z;
    steps += has_z ? 0.8660255 : 0.7071068; // half of the root of 3 and of 2, rounded up
    steps += k->pad >= 0 ? 0.5 : 0;
  }
  return steps * grid;
}

double largest_within(const predicate_info &predicate, double tolerance) {
  const double steps = moved_by(predicate, 1);
  if (steps == 0 || !(tolerance > 0) || !(tolerance <= 0x1p127))
    return 0;
  double grid = std::ldexp(1.0, std::ilogb(tolerance / steps));
  if (moved_by(predicate, grid) > tolerance) // the quotient was rounded up to a power of two
    grid /= 2;
  return grid >= 0x1p-149 ? grid : 0;
}

bool lie_within(const pose &at, const float lo[3], const float hi[3], double longest, double least[3],
                double greatest[3]) {
  constexpr double finite = 0x1p126;
  const double reach = longest * std::abs(at.length_scale) * (1 + 0x1p-22) + at.grid + 0x1p-140;
  for (std::ptrdiff_t k = 0; k < 3; ++k) {
    const double *const m = at.m + 4 * k;
    double low = m[3], high = m[3], magnitude = std::abs(m[3]);
    for (int j = 0; j < 3; ++j) {
      const double x = m[j] * static_cast<double>(lo[j]), y = m[j] * static_cast<double>(hi[j]);
      low += std::fmin(x, y), high += std::fmax(x, y);
      magnitude += std::fmax(std::abs(x), std::abs(y));
    }
    const double slack = 0x1p-22 * magnitude + at.grid + 0x1p-140;
    if (!(magnitude + reach + slack <= finite))
      return false;
    least[k] = low - slack - reach, greatest[k] = high + slack + reach;
  }
  return true;
}

bool lies_apart(const pose &at, const float lo[3], const float hi[3], double longest, const float from[3],
                const float to[3]) {
  double least[3], greatest[3];
  if (!lie_within(at, lo, hi, longest, least, greatest))
    return false;
  bool apart = false;
  for (int k = 0; k < 3; ++k)
    apart = apart || least[k] > static_cast<double>(to[k]) || greatest[k] < static_cast<double>(from[k]);
  return apart;
}

void move(const kind_info &kind, const pose &at, float *row) {
  for (int i = 0; i < kind.fields; ++i) {
    if (kind.roles[i] == role::length) {
      row[i] = static_cast<float>(static_cast<double>(row[i]) * at.length_scale);
    } else if (kind.roles[i] == role::x) {
      const bool has_z = i + 2 < kind.fields && kind.roles[i + 2] == role::z;
      const double x = row[i], y = row[i + 1], z = has_z ? row[i + 2] : 0.0f;
      const double *of_coordinate = at.m; // a row of the matrix
      for (int k = 0; k < (has_z ? 3 : 2); ++k, of_coordinate += 4)
        row[i + k] = static_cast<float>(moved_coordinate(of_coordinate, x, y, z));
    }
  }
  if (at.grid != 0)
    for (int i = 0; i < kind.fields; ++i)
      row[i] = nearest_multiple(row[i], std::ilogb(at.grid));
}

} // namespace

bool pose::identity() const {
  return under_standard_word([&] {
    const pose none;
    bool same = length_scale == 1 && grid == 0;
    for (int i = 0; i < 12; ++i)
      same &= m[i] == none.m[i];
    return same;
  });
}

bool is_grid(double grid) {
  return under_standard_word([&] { return is_power(grid); });
}

double moved_by_grid(const predicate_info &predicate, double grid) {
  return under_standard_word([&] { return moved_by(predicate, grid); });
}

double grid_within(const predicate_info &predicate, double tolerance) {
  return under_standard_word([&] { return largest_within(predicate, tolerance); });
}

bool can_move(const kind_info &kind) {
  for (int i = 0; i < kind.fields; ++i) {
    if (kind.roles[i] == role::length)
      continue;
    if (kind.roles[i] != role::x || i + 1 >= kind.fields || kind.roles[i + 1] != role::y)
      return false;
    i += i + 2 < kind.fields && kind.roles[i + 2] == role::z ? 2 : 1;
  }
  return true;
}

bool lies_along_axes(const kind_info &kind) {
  for (std::ptrdiff_t p = 0; p < kind.hull; ++p) {
    const int *const at = kind.hull_fields + 3 * p;
    if (at[1] != at[0] + 1 || (at[2] >= 0 && at[2] != at[0] + 2))
      return true;
  }
  return false;
}

bool keeps_axes(const double *matrix) {
  return under_standard_word([&] {
    bool keeps = true;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        keeps = keeps && (i == k ? matrix[4 * i + k] >= 0 : matrix[4 * i + k] == 0);
    return keeps;
  });
}

bool ends_in(const pose &at, const float lo[3], const float hi[3], double longest, double least[3],
             double greatest[3]) {
  return under_standard_word([&] { return lie_within(at, lo, hi, longest, least, greatest); });
}

bool proved_apart(const pose &at, const float lo[3], const float hi[3], double longest, const float from[3],
                  const float to[3]) {
  return under_standard_word([&] { return lies_apart(at, lo, hi, longest, from, to); });
}

status movable(const kind_info &kind, const pose &at) {
  if (!at.identity() && !can_move(kind))
    return status::cannot_move;
  if (lies_along_axes(kind) && !keeps_axes(at.m))
    return status::turns_axes;
  return is_grid(at.grid) ? status::ok : status::bad_grid;
}

void move_rows(const kind_info &kind, const pose &at, float *rows, std::size_t n) {
  under_standard_word([&] {
    for (std::size_t i = 0; i < n; ++i)
      move(kind, at, rows + i * static_cast<std::size_t>(kind.fields));
  });
}

} // namespace meetc
