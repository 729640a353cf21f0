#include "core/rows.hpp"

#include <cstring>

namespace meetc {
namespace {

// Tests bits, so that no compiler flag can remove the test, and all of them, so that the loop is vectorised.
bool all_finite(const float *numbers, std::size_t n) {
  std::uint32_t bad = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint32_t b;
    std::memcpy(&b, numbers + i, sizeof b);
    bad |= (b & 0x7f800000) == 0x7f800000 ? 1u : 0u;
  }
  return bad == 0;
}

// Fetches `points` points for each element, where the number is known to the compiler or, with 0, is kind.points.
// Returns the first element with an index beyond the vertices, or end.
template <std::size_t Points>
std::size_t fetch_indexed(const view &v, const kind_info &kind, std::size_t begin, std::size_t end, float *out) {
  const auto *bytes = reinterpret_cast<const char *>(v.data);
  const std::size_t points = Points > 0 ? Points : static_cast<std::size_t>(kind.points);
  for (std::size_t e = begin; e < end; ++e)
    for (std::size_t p = 0; p < points; ++p, out += 3) {
      const std::uint32_t at = v.index[e * points + p];
      if (at >= v.vertices)
        return e;
      std::memcpy(out, bytes + at * v.stride_bytes, 3 * sizeof(float));
    }
  return end;
}

void fetch_rows(const view &v, std::size_t row_bytes, std::size_t begin, std::size_t end, float *out) {
  const auto *bytes = reinterpret_cast<const char *>(v.data);
  auto *to = reinterpret_cast<char *>(out);
  if (v.stride_bytes == row_bytes && begin < end) {
    std::memcpy(to, bytes + begin * row_bytes, (end - begin) * row_bytes);
    return;
  }
  for (std::size_t e = begin; e < end; ++e, to += row_bytes)
    std::memcpy(to, bytes + e * v.stride_bytes, row_bytes);
}

} // namespace

const float *rows_in_place(const view &elements, const kind_info &kind, const pose &at) {
  const bool packed = !elements.index &&
                      elements.stride_bytes == static_cast<std::size_t>(kind.fields) * sizeof(float) &&
                      reinterpret_cast<std::uintptr_t>(elements.data) % alignof(float) == 0;
  return packed && at.identity() ? elements.data : nullptr;
}

status check_rows(const kind_info &kind, const float *rows, std::size_t count) {
  const auto fields = static_cast<std::size_t>(kind.fields);
  if (!all_finite(rows, count * fields))
    return status::bad_value;
  if (kind.fault)
    for (std::size_t i = 0; i < count; ++i)
      if (kind.fault(rows + i * fields))
        return status::bad_value;
  return status::ok;
}

status gather(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
              float *out) {
  const auto fields = static_cast<std::size_t>(kind.fields);
  std::size_t fetched = end;
  if (!elements.index)
    fetch_rows(elements, fields * sizeof(float), begin, end, out);
  else if (kind.points == 3)
    fetched = fetch_indexed<3>(elements, kind, begin, end, out);
  else
    fetched = fetch_indexed<0>(elements, kind, begin, end, out);
  if (!at.identity())
    for (std::size_t i = 0; i < fetched - begin; ++i)
      move_row(kind, at, out + i * fields);
  const status s = check_rows(kind, out, fetched - begin);
  return s == status::ok && fetched < end ? status::bad_index : s;
}

} // namespace meetc
