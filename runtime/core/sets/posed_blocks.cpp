#include "meet/core/sets/posed_blocks.hpp"

#include "meet/core/views/rows.hpp"

#include <cmath>

namespace meetc {

box posed_box(const pose &at, const box &around, float longest) {
  constexpr float most = std::numeric_limits<float>::max();
  box out{{-most, -most, -most}, {most, most, most}};
  double least[3], greatest[3];
  if (!ends_in(at, around.lo, around.hi, static_cast<double>(longest), least, greatest))
    return out;
  for (int k = 0; k < 3; ++k) {
    const auto lo = static_cast<float>(least[k]), hi = static_cast<float>(greatest[k]);
    out.lo[k] = static_cast<double>(lo) <= least[k] ? lo : std::nextafter(lo, -most);
    out.hi[k] = static_cast<double>(hi) >= greatest[k] ? hi : std::nextafter(hi, most);
  }
  return out;
}

posed_blocks::posed_blocks(const element_set &from, const pose &at, std::span<const box> near, std::stop_token stop)
    : from_(from), pose_(at), near_(near), on_(1, std::move(stop)) {
  if (from.boxes.depth > 0)
    mark(from.boxes.depth - 1, 0);
  for (const std::size_t block : blocks_)
    elements_ += from.boxes.levels[0].filled(block);
}

bool posed_blocks::touches(const box &b) const {
  return std::ranges::any_of(near_, [&b](const box &n) { return !apart(b, n); });
}

void posed_blocks::mark(int at, std::size_t block) {
  on_.go_on();
  const level &here = from_.boxes.levels[at];
  for (std::size_t i = 0; i < here.filled(block); ++i) {
    const std::size_t child = block * lanes + i;
    if (!touches(posed_box(pose_, here.get(child), from_.longest)))
      continue;
    if (at == 1)
      blocks_.push_back(child);
    else
      mark(at - 1, child);
  }
}

std::size_t posed_blocks::fill(element_set &set) const {
  const kind_info &kind = *set.kind;
  const auto fields = static_cast<std::size_t>(kind.fields);
  const level &leaves = from_.boxes.levels[0];
  magnitudes most;
  std::size_t slot = 0, block = 0, bad = elements_;
  for (const std::size_t old : blocks_) {
    if ((block & 0xff) == 0)
      on_.go_on();
    const std::size_t filled = leaves.filled(old); // the last block alone may have fewer than sixteen
    float *const rows = set.rows + slot * fields;
    std::copy_n(from_.rows + old * lanes * fields, filled * fields, rows);
    std::copy_n(from_.order + old * lanes, filled, set.order + slot);
    move_rows(kind, pose_, rows, filled);
    if (check_rows(kind, rows, filled) != status::ok)
      for (std::size_t i = 0; i < filled; ++i)
        if (check_rows(kind, rows + i * fields, 1) != status::ok &&
            (bad == elements_ || set.order[slot + i] < set.order[bad]))
          bad = slot + i;
    most.add(magnitudes_of(kind, rows, filled));
    box_rows(kind, rows, filled, set.boxes.levels[0].blocks + block++);
    slot += filled;
  }
  set.reach = most.reach, set.longest = most.longest;
  set.grid = pose_.grid;
  set.around = from_.boxes.depth > 0 ? posed_box(pose_, from_.around, from_.longest) : from_.around;
  enclose(set.boxes, on_);
  return bad;
}

} // namespace meetc
