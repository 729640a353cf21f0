// core/device/memory/hit_history.hpp: how many hits the same two sets had the last time, of the last few that were asked.
#ifndef MEETC_CORE_DEVICE_MEMORY_HIT_HISTORY_HPP
#define MEETC_CORE_DEVICE_MEMORY_HIT_HISTORY_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace meetc {

// It is for guesses alone, since sets are told apart by their addresses.
class hit_history {
public:
  std::optional<std::uint64_t> of(const void *a, const void *b) const {
    const auto known = std::find_if(last_.begin(), last_.end(), [=](const entry &e) { return e.a == a && e.b == b; });
    return known == last_.end() ? std::nullopt : std::optional(known->hits);
  }
  void note(const void *a, const void *b, std::uint64_t hits) {
    std::erase_if(last_, [=](const entry &e) { return e.a == a && e.b == b; });
    if (last_.size() == most)
      last_.erase(last_.begin());
    last_.push_back({a, b, hits});
  }

private:
  static constexpr std::size_t most = 8;
  struct entry {
    const void *a, *b;
    std::uint64_t hits;
  };
  std::vector<entry> last_; // the latest at the end
};

} // namespace meetc

#endif
