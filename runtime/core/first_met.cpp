#include "core/first_met.hpp"

#include "core/answers.hpp"

#include <atomic>

namespace meetc {

first_of_each::first_of_each(const element_set &a, const element_set &b, decltype(predicate_info::first_met) order)
    : a_(a), b_(b), order_(order), first_(a.elements, no_element) {}

bool first_of_each::before(const float *row, std::uint32_t slot, std::uint32_t other) const {
  const std::size_t fields = static_cast<std::size_t>(b_.kind->fields);
  const int order = order_(row, b_.rows + slot * fields, b_.rows + other * fields);
  return order < 0 || (order == 0 && b_.order[slot] < b_.order[other]);
}

void first_of_each::take(int, const index_pair *hits, std::size_t n) {
  const std::size_t fields = static_cast<std::size_t>(a_.kind->fields);
  for (std::size_t i = 0; i < n; ++i) {
    const index_pair hit = hits[i];
    const std::atomic_ref<std::uint32_t> first(first_[hit.a]);
    std::uint32_t now = first.load(std::memory_order_relaxed);
    while ((now == no_element || before(a_.rows + hit.a * fields, hit.b, now)) &&
           !first.compare_exchange_weak(now, hit.b, std::memory_order_relaxed)) {
    }
  }
}

std::vector<std::uint32_t> first_of_each::by_element(std::size_t elements) const {
  std::vector<std::uint32_t> out(elements, no_element);
  for (std::size_t slot = 0; slot < first_.size(); ++slot)
    if (first_[slot] != no_element)
      out[a_.order[slot]] = b_.order[first_[slot]];
  return out;
}

} // namespace meetc
