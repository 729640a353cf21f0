#include "core/rows.hpp"

#include <cstring>

namespace meetc {
namespace {

// By the bits, so that no compiler flag can take the test away.
bool finite(float v) {
  std::uint32_t b;
  std::memcpy(&b, &v, sizeof b);
  return (b & 0x7f800000) != 0x7f800000;
}

bool all_finite(const float *row, int fields) {
  bool good = true;
  for (int i = 0; i < fields; ++i)
    good &= finite(row[i]);
  return good;
}

bool fetch(const view &v, const kind_info &kind, std::size_t element, float *row) {
  const auto *bytes = reinterpret_cast<const char *>(v.data);
  if (!v.index) {
    std::memcpy(row, bytes + element * v.stride_bytes, static_cast<std::size_t>(kind.fields) * sizeof(float));
    return true;
  }
  const auto points = static_cast<std::size_t>(kind.points);
  for (std::size_t p = 0; p < points; ++p) {
    const std::uint32_t at = v.index[element * points + p];
    if (at >= v.vertices)
      return false;
    std::memcpy(row + 3 * p, bytes + at * v.stride_bytes, 3 * sizeof(float));
  }
  return true;
}

void move(const kind_info &kind, const pose &at, float *row) {
  const double *m = at.m;
  for (int i = 0; i < kind.fields; ++i) {
    if (kind.roles[i] == role::length) {
      row[i] = static_cast<float>(static_cast<double>(row[i]) * at.length_scale);
    } else if (kind.roles[i] == role::x) {
      const bool has_z = i + 2 < kind.fields && kind.roles[i + 2] == role::z;
      const double x = row[i], y = row[i + 1], z = has_z ? row[i + 2] : 0.0f;
      row[i] = static_cast<float>(((m[0] * x + m[1] * y) + m[2] * z) + m[3]);
      row[i + 1] = static_cast<float>(((m[4] * x + m[5] * y) + m[6] * z) + m[7]);
      if (has_z)
        row[i + 2] = static_cast<float>(((m[8] * x + m[9] * y) + m[10] * z) + m[11]);
    }
  }
}

} // namespace

status gather(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
              float *out) {
  const bool moved = !at.identity();
  for (std::size_t e = begin; e < end; ++e, out += kind.fields) {
    if (!fetch(elements, kind, e, out))
      return status::bad_index;
    if (moved)
      move(kind, at, out);
    if (!all_finite(out, kind.fields) || (kind.fault && kind.fault(out)))
      return status::bad_value;
  }
  return status::ok;
}

} // namespace meetc
