// core/device/query/lists.hpp: the lists of pairs of a query, which grow up to a limit.
#ifndef MEETC_CORE_DEVICE_QUERY_LISTS_HPP
#define MEETC_CORE_DEVICE_QUERY_LISTS_HPP

#include "meet/core/device/memory/buffers.hpp"

#include <algorithm>
#include <cstddef>

namespace meetc {

class query_lists {
public:
  // With room for so many pairs, if the limit and the device's memory allow it. `stores`: hits are listed, too. Throws
  // device_error.
  query_lists(device_buffers &buffers, std::uint64_t expected, std::size_t limit, bool stores)
      : buffers_(buffers), limit_(limit), stores_(stores) {
    constexpr std::size_t first = std::size_t{1} << 22;
    const auto within = [&](std::size_t least) {
      return std::clamp(buffers_.first.capacity(), std::min(limit_, least), limit_);
    };
    capacity_ = within(std::max<std::size_t>(expected, first));
    if (!enlarge(capacity_))
      capacity_ = within(first);
    buffers_.first.reserve(capacity_, "a list of candidates");
    buffers_.second.reserve(capacity_, "a list of candidates");
    if (stores_)
      buffers_.hits.reserve(capacity_, "a list of hits");
  }

  std::size_t capacity() const { return capacity_; }
  // Returns false where the limit or the device's memory forbids it.
  bool take_more_room() {
    const std::size_t more = std::min(capacity_ * 8, limit_);
    if (more == capacity_ || !enlarge(more))
      return false;
    capacity_ = more;
    return true;
  }

  cuda::pair_list candidates() const { return list(buffers_.first, counter::candidates); }
  cuda::pair_list kept() const { return list(buffers_.second, counter::kept); }
  // Without a list: only their number.
  cuda::pair_list hits() const {
    return stores_ ? list(buffers_.hits, counter::hits) : cuda::pair_list{nullptr, buffers_.count_of(counter::hits), 0};
  }

  // Whether the lists could take so many times as much as the last part has filled, by the counts that were read.
  bool hold(std::uint64_t times) const {
    const std::uint64_t most = capacity_ / times;
    const auto fits = [&](counter c) { return buffers_.seen_of(c) <= most; };
    return fits(counter::candidates) && fits(counter::kept) && (!stores_ || fits(counter::hits));
  }

private:
  bool enlarge(std::size_t capacity) {
    const auto grows = [&](device_memory<index_pair> &m) { return m.grow(capacity, 0, buffers_.stream); };
    return grows(buffers_.first) && grows(buffers_.second) && (!stores_ || grows(buffers_.hits));
  }
  cuda::pair_list list(const device_memory<index_pair> &pairs, counter c) const {
    return {pairs.data(), buffers_.count_of(c), std::min(pairs.capacity(), capacity_)};
  }

  device_buffers &buffers_;
  std::size_t limit_, capacity_ = 0;
  bool stores_;
};

} // namespace meetc

#endif
