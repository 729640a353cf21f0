#include "core/first_met.hpp"

#include "core/answers.hpp"
#include "meetc/take_first.hpp"

#include <atomic>

namespace meetc {

first_of_each::first_of_each(const element_set &a, const element_set &b, std::span<const std::uint32_t> owner_b,
                             decltype(predicate_info::first_met) order)
    : a_(a), b_(b), owner_b_(owner_b), order_(order), first_(a.elements, no_element) {}

std::uint32_t first_of_each::number_of(std::uint32_t slot) const {
  return owner_b_.empty() ? b_.order[slot] : owner_b_[b_.order[slot]];
}

void first_of_each::take(int, const index_pair *hits, std::size_t n) {
  const auto fields_a = static_cast<std::size_t>(a_.kind->fields), fields_b = static_cast<std::size_t>(b_.kind->fields);
  for (std::size_t i = 0; i < n; ++i) {
    const index_pair hit = hits[i];
    const float *const row = a_.rows + hit.a * fields_a;
    const std::atomic_ref<std::uint32_t> first(first_[hit.a]);
    const auto before = [&](std::uint32_t slot, std::uint32_t other) {
      return comes_before(order_(row, b_.rows + slot * fields_b, b_.rows + other * fields_b), number_of(slot),
                          number_of(other));
    };
    take_first(first.load(std::memory_order_relaxed), hit.b, no_element, before,
               [&first](std::uint32_t expected, std::uint32_t slot) {
                 first.compare_exchange_strong(expected, slot, std::memory_order_relaxed);
                 return expected; // what it held
               });
  }
}

std::vector<std::uint32_t> first_of_each::by_element(std::size_t elements) const {
  std::vector<std::uint32_t> out(elements, no_element);
  for (std::size_t slot = 0; slot < first_.size(); ++slot)
    if (first_[slot] != no_element)
      out[a_.order[slot]] = number_of(first_[slot]);
  return out;
}

} // namespace meetc
