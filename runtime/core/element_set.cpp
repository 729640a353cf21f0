#include "core/element_set.hpp"

#include "core/morton.hpp"
#include "core/rows.hpp"
#include "core/threads.hpp"

#include <atomic>
#include <cstring>
#include <limits>
#include <mutex>

namespace meetc {
namespace {

// The largest |v| of every stride-th number, found by the bits: finite numbers are in the order of their magnitudes'
// bits, and comparisons of integers are vectorised.
float largest(const float *v, std::size_t n, std::size_t stride) {
  std::uint32_t most = 0;
  for (std::size_t i = 0; i < n; i += stride) {
    std::uint32_t bits;
    std::memcpy(&bits, v + i, sizeof bits);
    most = std::max(most, bits & 0x7fffffff);
  }
  float value;
  std::memcpy(&value, &most, sizeof value);
  return value;
}

// Widens set.reach and set.longest by these rows.
void widen(element_set &set, const float *rows, std::size_t count, std::mutex &lock) {
  const kind_info &kind = *set.kind;
  const auto fields = static_cast<std::size_t>(kind.fields);
  const std::size_t n = count * fields, stride = kind.points > 0 ? 1 : fields; // such kinds have coordinates only
  for (std::size_t f = 0; f < stride; ++f) {
    const float most =
        kind.roles[f] == role::other ? std::numeric_limits<float>::infinity() : largest(rows + f, n - f, stride);
    const std::scoped_lock hold(lock);
    float &all = kind.roles[f] == role::length ? set.longest : set.reach;
    all = std::max(all, most);
  }
}

} // namespace

element_set take_set(bump_allocator &from, const kind_info &kind, std::size_t elements) {
  element_set s;
  s.kind = &kind;
  s.elements = elements;
  s.rows = from.take<float>(elements * static_cast<std::size_t>(kind.fields));
  s.order = from.take<std::uint32_t>(elements);
  s.boxes = take_hierarchy(from, elements);
  return s;
}

set_scratch take_scratch(bump_allocator &from, const kind_info &kind, std::size_t elements) {
  set_scratch s;
  s.rows = from.take<float>(elements * static_cast<std::size_t>(kind.fields));
  s.boxes = from.take<box>(elements);
  s.keys = from.take<std::uint64_t>(elements);
  s.more_keys = from.take<std::uint64_t>(elements);
  return s;
}

status fill(element_set &set, const view &elements, const pose &at, const set_scratch &scratch, int threads) {
  const kind_info &kind = *set.kind;
  const auto fields = static_cast<std::size_t>(kind.fields);
  if (!at.identity() && !can_move(kind))
    return status::cannot_move;

  constexpr std::size_t chunk = 2048;
  std::atomic<status> outcome{status::ok};
  std::mutex lock;
  set.reach = set.longest = 0;
  for_chunks(threads, set.elements, chunk, [&](int, std::size_t begin, std::size_t end) {
    float *rows = scratch.rows + begin * fields;
    const status s = gather(elements, kind, at, begin, end, rows);
    if (s != status::ok) {
      outcome.store(s, std::memory_order_relaxed);
      return;
    }
    widen(set, rows, end - begin, lock);
    for (std::size_t e = begin; e < end; ++e, rows += fields) {
      kind.box(rows, scratch.boxes[e].lo, scratch.boxes[e].hi);
      scratch.boxes[e] = sanitised(scratch.boxes[e]);
    }
  });
  if (outcome != status::ok)
    return outcome;

  spatial_order(scratch.boxes, set.elements, scratch.keys, scratch.more_keys, threads);
  const level &leaves = set.boxes.levels[0];
  for_chunks(threads, leaves.count(), chunk / lanes, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      leaves.blocks[block].clear();
      for (std::size_t slot = block * lanes; slot < std::min(set.elements, (block + 1) * lanes); ++slot) {
        const auto element = static_cast<std::uint32_t>(scratch.keys[slot]);
        set.order[slot] = element;
        std::memcpy(set.rows + slot * fields, scratch.rows + element * fields, fields * sizeof(float));
        leaves.blocks[block].set(static_cast<int>(slot % lanes), scratch.boxes[element]);
      }
    }
  });
  enclose(set.boxes, threads);
  return status::ok;
}

} // namespace meetc
