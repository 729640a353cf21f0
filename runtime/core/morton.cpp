#include "core/morton.hpp"

#include "core/radix_sort.hpp"
#include "core/threads.hpp"

namespace meetc {
namespace {

constexpr int cells = 1024; // along each axis: ten bits of thirty

double centre(const box &b, int axis) {
  return (static_cast<double>(b.lo[axis]) + static_cast<double>(b.hi[axis])) / 2;
}

struct alignas(64) extent {
  double lo[3], hi[3];

  extent() {
    std::fill_n(lo, 3, std::numeric_limits<double>::infinity());
    std::fill_n(hi, 3, -std::numeric_limits<double>::infinity());
  }
  void add(const box &b) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], centre(b, k));
      hi[k] = std::max(hi[k], centre(b, k));
    }
  }
  void add(const extent &e) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], e.lo[k]);
      hi[k] = std::max(hi[k], e.hi[k]);
    }
  }
  double size() const { return std::max({hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]}); }
};

// Ten bits, each moved to every third position.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 16) & 0x030000ff;
  v = (v | v << 8) & 0x0300f00f;
  v = (v | v << 4) & 0x030c30c3;
  return (v | v << 2) & 0x09249249;
}

std::uint64_t key_of(const box &b, std::uint32_t element, const extent &e, double scale) {
  std::uint32_t code = 0;
  for (int k = 0; k < 3; ++k) {
    const double cell = (centre(b, k) - e.lo[k]) * scale;
    code |= spread(static_cast<std::uint32_t>(std::clamp(cell, 0.0, cells - 1.0))) << k;
  }
  return std::uint64_t{code} << 32 | element;
}

void sort(std::uint64_t *keys, std::uint64_t *scratch, std::size_t n) {
  if (n < 2048)
    std::sort(keys, keys + n);
  else
    radix_sort(keys, scratch, n, 30, [](std::uint64_t key) { return key >> 32; });
}

// Gives runs that share a cell and do not fit into a block a grid of their own. The extent shrinks by about 1024 each
// time, from at most 2^129 to at least 2^-150, so at most some thirty grids are nested.
void refine(const box *boxes, std::uint64_t *keys, std::uint64_t *scratch, std::size_t n) {
  for (std::size_t begin = 0, end; begin < n; begin = end) {
    for (end = begin + 1; end < n && keys[end] >> 32 == keys[begin] >> 32;)
      ++end;
    if (end - begin <= lanes)
      continue;
    extent e;
    for (std::size_t i = begin; i < end; ++i)
      e.add(boxes[static_cast<std::uint32_t>(keys[i])]);
    if (!(e.size() > 0))
      continue;
    for (std::size_t i = begin; i < end; ++i) {
      const auto element = static_cast<std::uint32_t>(keys[i]);
      keys[i] = key_of(boxes[element], element, e, cells / e.size());
    }
    sort(keys + begin, scratch, end - begin);
    refine(boxes, keys + begin, scratch, end - begin);
  }
}

} // namespace

void spatial_order(const box *boxes, std::size_t n, std::uint64_t *keys, std::uint64_t *scratch, int threads) {
  constexpr std::size_t chunk = 4096;
  extent parts[max_threads];
  for_chunks(threads, n, chunk, [&](int worker, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      parts[worker].add(boxes[i]);
  });
  for (int w = 1; w < max_threads; ++w)
    parts[0].add(parts[w]);
  const double scale = parts[0].size() > 0 ? cells / parts[0].size() : 0;
  for_chunks(threads, n, chunk, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      keys[i] = key_of(boxes[i], static_cast<std::uint32_t>(i), parts[0], scale);
  });
  if (n == 0)
    return;
  sort(keys, scratch, n);
  refine(boxes, keys, scratch, n);
}

} // namespace meetc
