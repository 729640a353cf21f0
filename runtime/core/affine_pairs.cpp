#include "core/affine_pairs.hpp"

#include "core/threads.hpp"

#include <algorithm>
#include <atomic>

namespace meetc {
namespace {

constexpr std::size_t chunk = 1024;
static_assert(chunk % filter_tile == 0, "a tile is not split between threads");

// Where the numbers of some rows lie; 0 to 0 where there is no row.
void find_ranges(const float *rows, std::size_t n, std::size_t fields, double *lo, double *hi) {
  std::fill_n(lo, fields, n > 0 ? HUGE_VAL : 0.0);
  std::fill_n(hi, fields, n > 0 ? -HUGE_VAL : 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < fields; ++k) {
      const auto x = static_cast<double>(rows[i * fields + k]);
      lo[k] = std::min(lo[k], x), hi[k] = std::max(hi[k], x);
    }
}

std::size_t fields_of(const kind_info &kind) {
  return static_cast<std::size_t>(kind.fields);
}

} // namespace

near_tile *every_tile(std::size_t count, near_tile *out) {
  for (std::size_t t = 0; t < count; ++t)
    *out++ = {static_cast<std::uint32_t>(t), (1U << filter_tile) - 1};
  return out;
}

// Making the numbers of an element costs about as much as ruling out a thousand pairs.
bool affine_pairs::pays(const predicate_info &predicate, std::size_t a, std::size_t b) {
  return predicate.affine && std::min(a, b) >= 1024;
}

affine_pairs::affine_pairs(const predicate_info &predicate, const float *rows_a, std::size_t count_a,
                           const float *rows_b, std::size_t count_b, int threads)
    : filter_(*predicate.affine),
      singles_(allocate((count_a + 1) * static_cast<std::size_t>(filter_.of_a) * sizeof(float))),
      tiles_(allocate((count_b + filter_tile) * static_cast<std::size_t>(filter_.of_b) * sizeof(float))) {
  field_ranges a{}, b{};
  find_ranges(rows_a, count_a, fields_of(*predicate.a), a.lo, a.hi);
  find_ranges(rows_b, count_b, fields_of(*predicate.b), b.lo, b.hi);
  std::atomic<bool> usable{true};
  const auto make = [&](auto of, const float *rows, std::size_t count, const kind_info &kind, int floats,
                        const owned_memory &to) {
    for_chunks(threads, count, chunk, [&](int, std::size_t begin, std::size_t end) {
      if (!of(a, b, rows + begin * fields_of(kind), end - begin,
              static_cast<float *>(to.get()) + begin * static_cast<std::size_t>(floats)))
        usable = false;
    });
  };
  make(filter_.singles, rows_a, count_a, *predicate.a, filter_.of_a, singles_);
  make(filter_.tiles, rows_b, count_b, *predicate.b, filter_.of_b, tiles_);
  usable_ = usable;
}

near_tile *affine_pairs::near(std::size_t i, std::size_t first, std::size_t count, near_tile *out) const {
  if (usable_)
    return filter_.near(static_cast<const float *>(singles_.get()) + i * static_cast<std::size_t>(filter_.of_a),
                        static_cast<const float *>(tiles_.get()) +
                            first * filter_tile * static_cast<std::size_t>(filter_.of_b),
                        count, out);
  return every_tile(count, out);
}

void affine_pairs::elements(std::size_t i, std::size_t first, std::size_t count, std::uint32_t *out) const {
  near_tile tiles[most_tiles];
  std::fill_n(out, count, 0U);
  const near_tile *const end = near(i, first, count, tiles);
  for (const near_tile *t = tiles; t < end; ++t)
    out[t->index] = t->elements;
}

} // namespace meetc
