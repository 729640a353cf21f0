#include "meet/core/sets/element_set.hpp"

#include "meet/core/views/rows.hpp"

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <new>
#include <optional>

namespace meetc {
namespace {

// The largest |v| of every stride-th number, found by the bits: finite numbers are in the order of their magnitudes'
// bits, and comparisons of integers are vectorised. Infinite if one of them is not finite.
float largest(const float *v, std::size_t n, std::size_t stride) {
  const auto bits = [v](std::size_t i) {
    std::int32_t b;
    std::memcpy(&b, v + i, sizeof b);
    return b & 0x7fffffff;
  };
  std::int32_t most = 0;
  if (stride == 1)
    for (std::size_t i = 0; i < n; ++i)
      most = bits(i) > most ? bits(i) : most;
  else
    for (std::size_t i = 0; i < n; i += stride)
      most = bits(i) > most ? bits(i) : most;
  constexpr std::int32_t infinite = 0x7f800000;
  most = std::min(most, infinite);
  float value;
  std::memcpy(&value, &most, sizeof value);
  return value;
}

constexpr box nothing{{1, 1, 1}, {-1, -1, -1}};

// Which boxes may touch an element of a set.
class counterpart_boxes {
public:
  counterpart_boxes(const element_set &to, std::size_t elements) {
    const hierarchy &h = to.boxes;
    if (h.depth == 0)
      return;
    around_ = h.top().blocks[0].around();
    if (to.elements <= elements / lanes) // the highest level of several boxes, which are one block
      boxes_ = h.levels[h.top().boxes > 1 ? h.depth - 1 : h.depth - 2].blocks;
  }

  bool holds(const box &b) const {
    bool touches = true;
    for (int k = 0; k < 3; ++k)
      touches &= !(b.hi[k] < around_.lo[k]) & !(around_.hi[k] < b.lo[k]);
    return touches && (!boxes_ || touching(*boxes_, b) != 0);
  }

private:
  box around_ = nothing;
  const box_block *boxes_ = nullptr; // null: not worth testing
};

// The extent of the elements before they are ordered, of a chunk or of all.
struct survey {
  centre_extent centres; // of those that are kept
  box around{{HUGE_VALF, HUGE_VALF, HUGE_VALF}, {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}};

  void add(const box &b) {
    for (int k = 0; k < 3; ++k) {
      around.lo[k] = b.lo[k] < around.lo[k] ? b.lo[k] : around.lo[k];
      around.hi[k] = around.hi[k] < b.hi[k] ? b.hi[k] : around.hi[k];
    }
  }
  void add(const survey &s) {
    centres.add(s.centres);
    add(s.around);
  }
};

// Lists the elements that are kept, in ascending order, and returns their number.
std::size_t list_kept(const std::uint8_t *kept, std::size_t n, std::uint32_t *list, const execution &on) {
  std::size_t count = 0;
  for_strips(on, n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      list[count] = static_cast<std::uint32_t>(e);
      count += kept[e];
    }
  });
  return count;
}

// The boxes of a few rows, which may be infinite.
class row_boxes {
public:
  static constexpr std::size_t most = 4 * lanes;
  row_boxes(const kind_info &kind, const float *rows, std::size_t n) { kind.boxes(rows, n, ends_); }
  box operator[](std::size_t i) const {
    const float *const e = ends_ + 6 * i;
    return {{e[0], e[1], e[2]}, {e[3], e[4], e[5]}};
  }
  // The boxes of `filled` rows from `first` on, finite, in the first lanes; the others become empty.
  void block(std::size_t first, std::size_t filled, box_block &out) const {
    out.take(ends_ + 6 * first, static_cast<int>(filled));
  }

private:
  float ends_[6 * most];
};

// Copies one row. The sizes of most kinds are cases, in which the compiler knows how much to copy.
void copy_row(float *to, const float *from, std::size_t fields) {
  switch (fields) {
  case 3:
    std::memcpy(to, from, 3 * sizeof(float));
    break;
  case 4:
    std::memcpy(to, from, 4 * sizeof(float));
    break;
  case 6:
    std::memcpy(to, from, 6 * sizeof(float));
    break;
  case 9:
    std::memcpy(to, from, 9 * sizeof(float));
    break;
  default:
    std::memcpy(to, from, fields * sizeof(float));
  }
}

// Tells the processor that a row will be read soon. Rows in spatial order lie anywhere in memory.
void expect_row(const float *row, std::size_t fields) {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(row);
  __builtin_prefetch(row + fields - 1);
#else
  static_cast<void>(row), static_cast<void>(fields);
#endif
}

// Writes the rows and boxes of the blocks from `begin` on in the order of the keys.
void fill_blocks(element_set &set, const float *rows, const std::uint64_t *keys, std::size_t begin, std::size_t end) {
  constexpr std::size_t ahead = 16;
  const auto fields = static_cast<std::size_t>(set.kind->fields);
  const level &leaves = set.boxes.levels[0];
  for (std::size_t block = begin; block < end; ++block) {
    const std::size_t first = block * lanes, filled = leaves.filled(block);
    for (std::size_t slot = first; slot < first + filled; ++slot) {
      if (slot + ahead < set.elements)
        expect_row(rows + static_cast<std::uint32_t>(keys[slot + ahead]) * fields, fields);
      const auto element = static_cast<std::uint32_t>(keys[slot]);
      const float *const row = rows + element * fields;
      set.order[slot] = element;
      copy_row(set.rows + slot * fields, row, fields);
    }
    box_rows(*set.kind, set.rows + first * fields, filled, leaves.blocks + block);
  }
}

} // namespace

magnitudes magnitudes_of(const kind_info &kind, const float *rows, std::size_t count) {
  const auto fields = static_cast<std::size_t>(kind.fields);
  const std::size_t n = count * fields, stride = kind.points > 0 ? 1 : fields; // such kinds have coordinates only
  magnitudes all;
  for (std::size_t f = 0; f < stride; ++f) {
    const float most =
        kind.roles[f] == role::other ? std::numeric_limits<float>::infinity() : largest(rows + f, n - f, stride);
    all.add(kind.roles[f] == role::length ? magnitudes{0, most} : magnitudes{most, 0});
  }
  return all;
}

void box_rows(const kind_info &kind, const float *rows, std::size_t count, box_block *out) {
  const auto fields = static_cast<std::size_t>(kind.fields);
  for (std::size_t first = 0; first < count; first += row_boxes::most) {
    const std::size_t some = std::min(row_boxes::most, count - first);
    const row_boxes all(kind, rows + first * fields, some);
    for (std::size_t i = 0; i < some; i += lanes)
      all.block(i, std::min<std::size_t>(lanes, some - i), *out++);
  }
}

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
  s.centres = from.take<centre>(elements);
  s.kept = from.take<std::uint8_t>(elements);
  s.keys = from.take<std::uint64_t>(elements);
  s.more_keys = from.take<std::uint64_t>(elements);
  return s;
}

status fill(element_set &set, const view &elements, const pose &at, const set_scratch &scratch, const execution &on,
            const element_set *counterpart) {
  const kind_info &kind = *set.kind;
  const auto fields = static_cast<std::size_t>(kind.fields);
  const std::size_t given = elements.elements;
  if (wrong_with(elements, kind))
    return status::bad_view;
  if (const status s = movable(kind, at); s != status::ok)
    return s;

  constexpr std::size_t chunk = 2048;
  const float *const in_place = rows_in_place(elements, kind, at);
  const float *const rows = in_place ? in_place : scratch.rows;
  const std::optional<counterpart_boxes> keep =
      counterpart ? std::optional<counterpart_boxes>(std::in_place, *counterpart, given) : std::nullopt;
  std::atomic<status> outcome{status::ok};
  std::mutex lock;
  survey all;
  magnitudes most;
  set.grid = at.grid;
  for_chunks(on, given, chunk, [&](int, std::size_t begin, std::size_t end) {
    const status s = in_place ? check_rows(kind, rows + begin * fields, end - begin)
                              : gather(elements, kind, at, begin, end, scratch.rows + begin * fields);
    if (s != status::ok) {
      outcome.store(s, std::memory_order_relaxed);
      return;
    }
    const magnitudes of_mine = magnitudes_of(kind, rows + begin * fields, end - begin);
    survey mine;
    for (std::size_t first = begin; first < end; first += row_boxes::most) {
      const std::size_t count = std::min(row_boxes::most, end - first);
      const row_boxes boxes(kind, rows + first * fields, count);
      for (std::size_t i = 0; i < count; ++i) {
        const box b = sanitised(boxes[i]);
        mine.add(b);
        if (keep) {
          scratch.kept[first + i] = keep->holds(b);
          if (!scratch.kept[first + i])
            continue;
        }
        mine.centres.add(*new (scratch.centres + first + i) centre(b));
      }
    }
    const std::scoped_lock hold(lock);
    all.add(mine);
    most.add(of_mine);
  });
  if (outcome != status::ok)
    return outcome;
  set.reach = most.reach, set.longest = most.longest;

  set.around = given > 0 ? all.around : nothing;
  set.elements = given;
  if (keep)
    set.elements = list_kept(scratch.kept, given, set.order, on); // which the order replaces below
  resize(set.boxes, set.elements);
  spatial_order(scratch.centres, keep ? set.order : nullptr, all.centres, set.elements, scratch.keys, scratch.more_keys,
                on);
  for_chunks(on, set.boxes.levels[0].count(), chunk / lanes,
             [&](int, std::size_t begin, std::size_t end) { fill_blocks(set, rows, scratch.keys, begin, end); });
  enclose(set.boxes, on);
  return status::ok;
}

status refit(element_set &set, const element_set &ordered, const view &slots, const pose &at,
             const magnitudes *of_points, const execution &on) {
  const kind_info &kind = *set.kind;
  const auto fields = static_cast<std::size_t>(kind.fields);
  const level &leaves = set.boxes.levels[0];
  constexpr std::size_t chunk = 32; // blocks, whose rows stay in the first cache
  std::atomic<bool> bad{false};
  std::mutex lock;
  magnitudes most;
  for_chunks(on, leaves.count(), chunk, [&](int, std::size_t first, std::size_t last) {
    const std::size_t begin = first * lanes, end = std::min(last * lanes, set.elements);
    float *const rows = set.rows + begin * fields;
    fetch(slots, kind, at, begin, end, rows, slots.index ? nullptr : ordered.order);
    const magnitudes of_mine = of_points ? *of_points : magnitudes_of(kind, rows, end - begin);
    const bool finite = std::isfinite(of_mine.reach) && std::isfinite(of_mine.longest);
    if ((!finite || kind.fault) && check_rows(kind, rows, end - begin) != status::ok) {
      bad.store(true, std::memory_order_relaxed);
      return;
    }
    std::copy(ordered.order + begin, ordered.order + end, set.order + begin);
    box_rows(kind, rows, end - begin, leaves.blocks + first);
    const std::scoped_lock hold(lock);
    most.add(of_mine);
  });
  if (bad)
    return status::bad_value;
  set.reach = most.reach, set.longest = most.longest;
  set.grid = at.grid;
  enclose(set.boxes, on);
  set.around = set.elements > 0 ? set.boxes.top().blocks[0].around() : nothing;
  return status::ok;
}

} // namespace meetc
