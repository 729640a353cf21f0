#include "meet/core/sets/set_part.hpp"

#include <numeric>
#include <vector>

namespace meetc {

set_part::set_part(const element_set &whole, std::span<const std::uint32_t> owners, std::uint64_t first,
                   std::uint64_t end, const execution &on)
    : stored_(*whole.kind) {
  constexpr std::size_t chunk = std::size_t{1} << 14;
  const auto holds = [&](std::size_t slot) {
    const std::uint32_t element = whole.order[slot], item = owners.empty() ? element : owners[element];
    return first <= item && item < end;
  };
  std::vector<std::size_t> begins((whole.elements + chunk - 1) / chunk + 1, 0);
  for_chunks(on, whole.elements, chunk, [&](int, std::size_t from, std::size_t to) {
    std::size_t held = 0;
    for (std::size_t slot = from; slot < to; ++slot)
      held += holds(slot);
    begins[from / chunk + 1] = held;
  });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());

  const std::size_t elements = begins.back(), fields = static_cast<std::size_t>(whole.kind->fields);
  bump_allocator need;
  take_set(need, *whole.kind, elements);
  bytes_ = allocate(need.bytes());
  bump_allocator from_bytes({bytes_.get(), need.bytes()});
  set_ = take_set(from_bytes, *whole.kind, elements);
  set_.around = whole.around;
  set_.reach = whole.reach, set_.longest = whole.longest, set_.grid = whole.grid;
  if (elements == 0)
    return;
  box_block *const blocks = set_.boxes.levels[0].blocks;
  blocks[(elements - 1) / lanes].clear(); // whose last lanes nothing fills
  for_chunks(on, whole.elements, chunk, [&](int, std::size_t from, std::size_t to) {
    std::size_t at = begins[from / chunk];
    for (std::size_t slot = from; slot < to; ++slot) {
      if (!holds(slot))
        continue;
      std::copy_n(whole.rows + slot * fields, fields, set_.rows + at * fields);
      set_.order[at] = whole.order[slot];
      blocks[at / lanes].set(static_cast<int>(at % lanes), whole.boxes.levels[0].get(slot));
      ++at;
    }
  });
  enclose(set_.boxes, on);
}

} // namespace meetc
