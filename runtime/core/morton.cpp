#include "core/morton.hpp"

#include "core/radix_sort.hpp"
#include "core/threads.hpp"

namespace meetc {
namespace {

constexpr int cells = 1024; // along each axis: ten bits of thirty
constexpr int code_bits = 30;

// Ten bits, each moved to every third position.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 16) & 0x030000ff;
  v = (v | v << 8) & 0x0300f00f;
  v = (v | v << 4) & 0x030c30c3;
  return (v | v << 2) & 0x09249249;
}

std::uint64_t key_of(const centre &c, std::uint32_t element, const centre_extent &e, double scale) {
  std::uint32_t code = 0;
  for (int k = 0; k < 3; ++k) {
    const double cell = (static_cast<double>(c.at[k]) - static_cast<double>(e.lo[k])) * scale;
    code |= spread(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::min(cell, cells - 1.0)))) << k;
  }
  return std::uint64_t{code} << 32 | element;
}

// Sorts n keys by the low `bits` bits of their codes. The result lies in `keys`.
void sort(std::uint64_t *keys, std::uint64_t *scratch, std::size_t n, int bits) {
  if (n < 512)
    std::sort(keys, keys + n);
  else
    radix_sort(keys, scratch, n, bits, [](std::uint64_t key) { return key >> 32; });
}

// Gives runs that share a cell and do not fit into a block a grid of their own. The extent shrinks by about 1024 each
// time, from at most 2^129 to at least 2^-150, so at most some thirty grids are nested.
void refine(const centre *centres, std::uint64_t *keys, std::uint64_t *scratch, std::size_t n) {
  for (std::size_t begin = 0, end; begin < n; begin = end) {
    for (end = begin + 1; end < n && keys[end] >> 32 == keys[begin] >> 32;)
      ++end;
    if (end - begin <= lanes)
      continue;
    centre_extent e;
    for (std::size_t i = begin; i < end; ++i)
      e.add(centres[static_cast<std::uint32_t>(keys[i])]);
    if (!(e.size() > 0))
      continue;
    for (std::size_t i = begin; i < end; ++i) {
      const auto element = static_cast<std::uint32_t>(keys[i]);
      keys[i] = key_of(centres[element], element, e, cells / e.size());
    }
    sort(keys + begin, scratch, end - begin, code_bits);
    refine(centres, keys + begin, scratch, end - begin);
  }
}

// The keys are distributed to buckets by the first bits of their codes, in parts that run in parallel: each part counts
// its keys of each bucket, and later knows where to write them. So keys keep their order within a bucket.
constexpr int bucket_bits = 8;
constexpr std::size_t buckets = std::size_t{1} << bucket_bits, most_parts = 64, least_part = 4096;

struct distribution {
  std::size_t n, part, parts;
  std::uint32_t at[most_parts][buckets] = {}; // first counts, and then places
  std::size_t ends[buckets];

  explicit distribution(std::size_t keys)
      : n(keys), part(std::max(least_part, (keys + most_parts - 1) / most_parts)), parts((keys + part - 1) / part) {}

  static std::size_t bucket(std::uint64_t key) { return key >> (32 + code_bits - bucket_bits); }
  std::size_t end(std::size_t p) const { return std::min(n, (p + 1) * part); }
  void counts_to_places() {
    std::size_t sum = 0;
    for (std::size_t b = 0; b < buckets; ++b) {
      for (std::size_t p = 0; p < parts; ++p) {
        const std::uint32_t count = at[p][b];
        at[p][b] = static_cast<std::uint32_t>(sum);
        sum += count;
      }
      ends[b] = sum;
    }
  }
};

} // namespace

void spatial_order(const centre *centres, const std::uint32_t *list, const centre_extent &all, std::size_t n,
                   std::uint64_t *keys, std::uint64_t *scratch, int threads) {
  const double scale = all.size() > 0 ? cells / all.size() : 0;
  distribution d(n);
  for_chunks(threads, d.parts, 1, [&](int, std::size_t p, std::size_t) {
    for (std::size_t i = p * d.part; i < d.end(p); ++i) {
      const std::uint32_t element = list ? list[i] : static_cast<std::uint32_t>(i);
      scratch[i] = key_of(centres[element], element, all, scale);
      ++d.at[p][distribution::bucket(scratch[i])];
    }
  });
  d.counts_to_places();
  for_chunks(threads, d.parts, 1, [&](int, std::size_t p, std::size_t) {
    for (std::size_t i = p * d.part; i < d.end(p); ++i)
      keys[d.at[p][distribution::bucket(scratch[i])]++] = scratch[i];
  });
  for_chunks(n < least_part ? 1 : threads, buckets, 1, [&](int, std::size_t b, std::size_t) {
    const std::size_t begin = b ? d.ends[b - 1] : 0, size = d.ends[b] - begin;
    sort(keys + begin, scratch + begin, size, code_bits - bucket_bits);
    refine(centres, keys + begin, scratch + begin, size);
  });
}

} // namespace meetc
