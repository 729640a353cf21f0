#include "meet/core/sets/stored_rows.hpp"

#include <new>

namespace meetc {

bool stored_rows::compute(const element_set &set, const stored_values &values, float *room, const execution &on) {
  bool computed = true;
  const auto fields = static_cast<std::size_t>(set.kind->fields), floats = static_cast<std::size_t>(values.floats);
  for_strips(on, set.elements, [&](std::size_t begin, std::size_t end) {
    computed = computed && values.compute(set.rows + begin * fields, end - begin, room + begin * floats);
  });
  return computed;
}

const float *stored_rows::after(std::size_t pairs, const element_set &set, const stored_values &values, float *room,
                                const execution &on) {
  if (const float *numbers = ready_.load(std::memory_order_acquire))
    return numbers;
  if (pairs_.fetch_add(pairs, std::memory_order_relaxed) + pairs < set.elements / 4 || begun_.exchange(true))
    return nullptr;
  if (!room) {
    own_.reset(new (std::nothrow) float[set.elements * static_cast<std::size_t>(values.floats)]);
    room = own_.get();
  }
  try {
    if (!room || !compute(set, values, room, on))
      return nullptr; // now and later
  } catch (const cancelled &) {
    begun_ = false;
    throw;
  }
  ready_.store(room, std::memory_order_release);
  return room;
}

} // namespace meetc
