// core/marks.hpp: flags and counts of elements, marked by all threads at once in arrays that a caller lends.
//
// The atomic operations are relaxed: marks are only set or added up, so their order does not matter.
#ifndef MEETC_CORE_MARKS_HPP
#define MEETC_CORE_MARKS_HPP

#include "core/decide.hpp"

#include <atomic>

namespace meetc {

// Each array has one number for each element, 0 before the first hit, or is null where it is not asked for.
struct marks {
  std::uint8_t *flags_a = nullptr, *flags_b = nullptr;
  std::uint64_t *counts_a = nullptr, *counts_b = nullptr;

  void take(const index_pair *hits, std::size_t n) const {
    for (std::size_t i = 0; i < n; ++i) {
      set(flags_a, hits[i].a);
      set(flags_b, hits[i].b);
      add(counts_a, hits[i].a);
      add(counts_b, hits[i].b);
    }
  }
  bool any() const { return flags_a || flags_b || counts_a || counts_b; }

private:
  static void set(std::uint8_t *flags, std::uint32_t element) {
    if (flags)
      std::atomic_ref(flags[element]).store(1, std::memory_order_relaxed);
  }
  static void add(std::uint64_t *counts, std::uint32_t element) {
    if (counts)
      std::atomic_ref(counts[element]).fetch_add(1, std::memory_order_relaxed);
  }
};

class mark_elements final : public hit_taker {
public:
  explicit mark_elements(const marks &to) : to_(to) {}
  void take(int, const index_pair *hits, std::size_t n) override { to_.take(hits, n); }

private:
  marks to_;
};

} // namespace meetc

#endif
