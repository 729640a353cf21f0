#include "core/pose.hpp"

namespace meetc {

bool pose::identity() const {
  const pose none;
  bool same = length_scale == 1;
  for (int i = 0; i < 12; ++i)
    same &= m[i] == none.m[i];
  return same;
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

void move_row(const kind_info &kind, const pose &at, float *row) {
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
}

} // namespace meetc
