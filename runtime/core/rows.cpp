#include "core/rows.hpp"

#include <cstring>

namespace meetc {
namespace {

// Tests bits, so that no compiler flag can remove the test.
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

} // namespace

status gather(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
              float *out) {
  const bool moved = !at.identity();
  for (std::size_t e = begin; e < end; ++e, out += kind.fields) {
    if (!fetch(elements, kind, e, out))
      return status::bad_index;
    if (moved)
      move_row(kind, at, out);
    if (!all_finite(out, kind.fields) || (kind.fault && kind.fault(out)))
      return status::bad_value;
  }
  return status::ok;
}

} // namespace meetc
