#include "meet/core/sets/stored_rows.hpp"

#include <new>

namespace meetc {

const float *stored_rows::after(std::size_t pairs, const element_set &set, const stored_values &values, float *room) {
  if (const float *numbers = ready_.load(std::memory_order_acquire))
    return numbers;
  if (pairs_.fetch_add(pairs, std::memory_order_relaxed) + pairs < set.elements / 4 || begun_.exchange(true))
    return nullptr;
  if (!room) {
    own_.reset(new (std::nothrow) float[set.elements * static_cast<std::size_t>(values.floats)]);
    room = own_.get();
  }
  if (!room || !values.compute(set.rows, set.elements, room))
    return nullptr; // now and later
  ready_.store(room, std::memory_order_release);
  return room;
}

} // namespace meetc
