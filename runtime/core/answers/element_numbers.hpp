// core/answers/element_numbers.hpp: flags and counts of elements, which all threads mark at once.
//
// The atomic operations are relaxed: marks are only set or added up, so their order does not matter.
#ifndef MEETC_CORE_ANSWERS_ELEMENT_NUMBERS_HPP
#define MEETC_CORE_ANSWERS_ELEMENT_NUMBERS_HPP

#include "meet/core/answers/query_answer.hpp"

#include <atomic>

namespace meetc {

// A number for each element of both sets, 0 before the first hit, in the answer's own memory or in arrays that a caller lends.
template <class T> class element_numbers : public query_answer {
public:
  void start(const queried_sets &sets) override {
    if (!lent_) {
      own_ = {std::vector<T>(sets.elements_a), std::vector<T>(sets.elements_b)};
      a_ = own_.a.data(), b_ = own_.b.data();
      return;
    }
    if (a_)
      std::fill_n(a_, sets.elements_a, T{0});
    if (b_)
      std::fill_n(b_, sets.elements_b, T{0});
  }

protected:
  element_numbers() = default;
  element_numbers(T *a, T *b) : lent_(true), a_(a), b_(b) {} // null: of this set nothing is wanted

  // Calls mark(number) for both elements of each hit.
  template <class Mark> void mark_each(const index_pair *hits, std::size_t n, const Mark &mark) const {
    for (std::size_t i = 0; i < n; ++i) {
      if (a_)
        mark(std::atomic_ref(a_[hits[i].a]));
      if (b_)
        mark(std::atomic_ref(b_[hits[i].b]));
    }
  }
  per_element<T> own_;

private:
  bool lent_ = false;
  T *a_ = nullptr, *b_ = nullptr;
};

// 1 for each element that is in a pair.
class element_flags final : public element_numbers<std::uint8_t> {
public:
  element_flags() = default;
  element_flags(std::uint8_t *a, std::uint8_t *b) : element_numbers(a, b) {}
  void take(int, const index_pair *hits, std::size_t n) override {
    mark_each(hits, n, [](std::atomic_ref<std::uint8_t> flag) { flag.store(1, std::memory_order_relaxed); });
  }
  void finish(result &r) override { r.flags = std::move(own_); }
};

// The number of pairs that each element is in.
class element_counts final : public element_numbers<std::uint64_t> {
public:
  element_counts() = default;
  element_counts(std::uint64_t *a, std::uint64_t *b) : element_numbers(a, b) {}
  void take(int, const index_pair *hits, std::size_t n) override {
    mark_each(hits, n, [](std::atomic_ref<std::uint64_t> count) { count.fetch_add(1, std::memory_order_relaxed); });
  }
  void finish(result &r) override { r.counts = std::move(own_); }
};

} // namespace meetc

#endif
