#include "meet/core/answers/first_met.hpp"

#include "meetc/decide/take_first.hpp"

#include <atomic>

namespace meetc {

first_met::first_met(decltype(predicate_info::first_met) order, std::span<const std::uint32_t> owner_b)
    : order_(order), owner_b_(owner_b) {}

void first_met::start(const queried_sets &sets) {
  a_ = &sets.a, b_ = &sets.b, elements_ = sets.elements_a;
  first_.assign(sets.a.elements, no_element);
}

std::uint32_t first_met::number_of(std::uint32_t slot) const {
  return owner_b_.empty() ? b_->order[slot] : owner_b_[b_->order[slot]];
}

void first_met::take(int, const index_pair *hits, std::size_t n) {
  const auto fields_a = static_cast<std::size_t>(a_->kind->fields),
             fields_b = static_cast<std::size_t>(b_->kind->fields);
  for (std::size_t i = 0; i < n; ++i) {
    const index_pair hit = hits[i];
    const float *const row = a_->rows + hit.a * fields_a;
    const std::atomic_ref<std::uint32_t> first(first_[hit.a]);
    const auto before = [&](std::uint32_t slot, std::uint32_t other) {
      return comes_before(order_(row, b_->rows + slot * fields_b, b_->rows + other * fields_b), number_of(slot),
                          number_of(other));
    };
    take_first(first.load(std::memory_order_relaxed), hit.b, no_element, before,
               [&first](std::uint32_t expected, std::uint32_t slot) {
                 first.compare_exchange_strong(expected, slot, std::memory_order_relaxed);
                 return expected; // what it held
               });
  }
}

void first_met::finish(result &r) {
  r.first_met.assign(elements_, no_element);
  for (std::size_t slot = 0; slot < first_.size(); ++slot)
    if (first_[slot] != no_element)
      r.first_met[a_->order[slot]] = number_of(first_[slot]);
}

} // namespace meetc
