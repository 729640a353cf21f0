#include "meet/core/views/rows.hpp"

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

std::size_t row_bytes(const view &v, const kind_info &kind) {
  return (v.index ? 3 : static_cast<std::size_t>(kind.fields)) * sizeof(float);
}
std::size_t stride(const view &v, const kind_info &kind) {
  return v.stride_bytes == 0 ? row_bytes(v, kind) : v.stride_bytes;
}

// Tells the processor that this will be read soon.
void expect([[maybe_unused]] const char *bytes) {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(bytes);
#endif
}

// Fetches `points` points for each element, where the number is known to the compiler or, with 0, is kind.points.
// Returns the first element with an index beyond the vertices, or end.
template <std::size_t Points>
std::size_t fetch_indexed(const view &v, const kind_info &kind, std::size_t begin, std::size_t end, float *out) {
  const auto *bytes = reinterpret_cast<const char *>(v.data);
  const std::size_t points = Points > 0 ? Points : static_cast<std::size_t>(kind.points), apart = stride(v, kind);
  for (std::size_t e = begin; e < end; ++e) {
    if constexpr (Points == 1) { // a list of points, which may lie anywhere
      constexpr std::size_t ahead = 32;
      if (e + ahead < end)
        expect(bytes + v.index[e + ahead] * apart);
    }
    for (std::size_t p = 0; p < points; ++p, out += 3) {
      const std::uint32_t at = v.index[e * points + p];
      if (at >= v.vertices)
        return e;
      std::memcpy(out, bytes + at * apart, 3 * sizeof(float));
    }
  }
  return end;
}

void fetch_rows(const view &v, const kind_info &kind, std::size_t begin, std::size_t end, float *out,
                const std::uint32_t *list) {
  const std::size_t row = row_bytes(v, kind), apart = stride(v, kind);
  const auto *bytes = reinterpret_cast<const char *>(v.data);
  auto *to = reinterpret_cast<char *>(out);
  if (list) {
    for (std::size_t i = begin; i < end; ++i, to += row)
      std::memcpy(to, bytes + list[i] * apart, row);
    return;
  }
  if (apart == row && begin < end) {
    std::memcpy(to, bytes + begin * row, (end - begin) * row);
    return;
  }
  for (std::size_t e = begin; e < end; ++e, to += row)
    std::memcpy(to, bytes + e * apart, row);
}

} // namespace

const char *wrong_with(const view &elements, const kind_info &kind) {
  if (elements.elements == 0)
    return nullptr;
  if (elements.index && kind.fields != 3 * kind.points)
    return "elements of this kind have no index";
  if (!elements.data && (!elements.index || elements.vertices > 0))
    return "the data is null";
  if (elements.stride_bytes != 0 && elements.stride_bytes < row_bytes(elements, kind))
    return elements.index ? "the stride is shorter than a point" : "the stride is shorter than a row";
  return nullptr;
}

view with_stride(view elements, const kind_info &kind) {
  elements.stride_bytes = stride(elements, kind);
  return elements;
}

const float *rows_in_place(const view &elements, const kind_info &kind, const pose &at) {
  const bool packed = !elements.index && stride(elements, kind) == row_bytes(elements, kind) &&
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

std::size_t fetch(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
                  float *out, const std::uint32_t *list) {
  std::size_t fetched = end;
  if (!elements.index)
    fetch_rows(elements, kind, begin, end, out, list);
  else if (kind.points == 3)
    fetched = fetch_indexed<3>(elements, kind, begin, end, out);
  else if (kind.points == 1)
    fetched = fetch_indexed<1>(elements, kind, begin, end, out);
  else
    fetched = fetch_indexed<0>(elements, kind, begin, end, out);
  if (!at.identity())
    move_rows(kind, at, out, fetched - begin);
  return fetched;
}

status gather(const view &elements, const kind_info &kind, const pose &at, std::size_t begin, std::size_t end,
              float *out, const std::uint32_t *list) {
  const std::size_t fetched = fetch(elements, kind, at, begin, end, out, list);
  const status s = check_rows(kind, out, fetched - begin);
  return s == status::ok && fetched < end ? status::bad_index : s;
}

} // namespace meetc
