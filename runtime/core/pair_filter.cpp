#include "core/pair_filter.hpp"

#include "core/threads.hpp"

#include <mutex>

namespace meetc {
namespace {

static_assert(filter_tile == lanes, "a tile is a block of boxes");
constexpr std::size_t chunk = 4096;

// The extent of all rows.
filter_extent extent_of(const kind_filter &filter, const element_set &set, int threads) {
  filter_extent all;
  std::mutex lock;
  for_chunks(threads, set.elements, chunk, [&](int, std::size_t begin, std::size_t end) {
    filter_extent mine;
    filter.widen(set.rows + begin * static_cast<std::size_t>(set.kind->fields), end - begin, mine);
    const std::scoped_lock hold(lock);
    for (int k = 0; k < 3; ++k)
      all.lo[k] = std::min(all.lo[k], mine.lo[k]), all.hi[k] = std::max(all.hi[k], mine.hi[k]);
  });
  return all;
}

// The numbers of the objects that `size` rows make, with room for a whole last tile.
owned_memory numbers(void (*of)(const filter_extent &, const float *, std::size_t, float *), const filter_extent &frame,
                     const element_set &set, std::size_t size, std::size_t floats, int threads) {
  static_assert(chunk / filter_tile % filter_tile == 0 && chunk % filter_tile == 0,
                "a tile of groups is not split between threads");
  owned_memory out = allocate((set.elements / size + 1 + filter_tile) * floats * sizeof(float));
  for_chunks(threads, set.elements, chunk, [&](int, std::size_t begin, std::size_t end) {
    of(frame, set.rows + begin * static_cast<std::size_t>(set.kind->fields), end - begin,
       static_cast<float *>(out.get()) + begin / size * floats);
  });
  return out;
}

} // namespace

// Making the numbers of an element costs about as much as testing a hundred boxes without a filter.
bool pair_filter::pays(const predicate_info &predicate, const element_set &a, const element_set &b) {
  return predicate.a->filter && predicate.b->filter && std::min(a.elements, b.elements) >= 128;
}

pair_filter::pair_filter(const predicate_info &predicate, const element_set &a, const element_set &b, int threads)
    : floats_(static_cast<std::size_t>(predicate.a->filter->floats)), near_(predicate.a->filter->near) {
  const kind_filter &of_a = *predicate.a->filter, &of_b = *predicate.b->filter;
  const filter_extent frame = b.elements < a.elements ? extent_of(of_a, a, threads) : extent_of(of_b, b, threads);
  singles_ = numbers(of_a.singles, frame, a, 1, floats_, threads);
  tiles_ = numbers(of_b.tiles, frame, b, 1, floats_, threads);
  groups_ = numbers(of_b.groups, frame, b, filter_tile, floats_, threads);
}

} // namespace meetc
