// core/device/answers/device_result.hpp: what a query on a device may be asked, and what it answers.
#ifndef MEETC_CORE_DEVICE_ANSWERS_DEVICE_RESULT_HPP
#define MEETC_CORE_DEVICE_ANSWERS_DEVICE_RESULT_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/device/memory/memory.hpp"

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>

namespace meetc {

// A sorted list of pairs in device memory. Null where there is none.
class pairs_there {
public:
  const index_pair *data() const { return size_ > 0 ? reinterpret_cast<const index_pair *>(memory_.data()) : nullptr; }
  index_pair *data() { return size_ > 0 ? reinterpret_cast<index_pair *>(memory_.data()) : nullptr; }
  std::size_t size() const { return size_; }
  // Takes the first n pairs of this memory, and leaves its own memory there.
  void exchange(device_memory<std::uint64_t> &from, std::size_t n) { std::swap(memory_, from), size_ = n; }
  void clear() { size_ = 0; }

private:
  static_assert(sizeof(index_pair) == sizeof(std::uint64_t));
  device_memory<std::uint64_t> memory_;
  std::size_t size_ = 0;
};

struct device_options {
  answer_kind want = answer_kind::pairs;
  // The item of each element; empty: each element is its own item. Answers are then about items, as in collide_options.
  std::span<const std::uint32_t> owner_a = {}, owner_b = {};
  bool first_met = false; // as in collide_options; the device's kernels must have been generated with the order as well
  // Where answer_kind::none is wanted, the segments of A go down a hierarchy over B alone, a thread each, and no farther than
  // to a pair that is proved (meetc/volume/first_line.hpp). Empty: where this is expected to pay.
  std::optional<bool> first_alone = {};
  // In two given sets elements that cannot touch are left out before the others are put into order. Empty: where this is
  // expected to pay.
  std::optional<bool> cull = {};
  // The list of pairs of elements stays on the device: it becomes this one, and the result has none. Where the device lacked
  // the memory to sort it, it is in the result all the same, and this one is empty. Null: it is in the result.
  pairs_there *leave_there = nullptr;
  std::size_t list_capacity = std::size_t{1} << 25; // pairs in a list, at least 2^11
  std::function<void(double fraction)> progress = {};
  // As in collide_options. It is looked at before the query and after each part of the walk; where a stop is possible, a list
  // holds at most 2^23 pairs, so that parts are short.
  std::stop_token stop = {};
};

struct device_result : result {
  std::uint64_t parts = 0; // parts of the walk that were run
  // From the first kernel to the last, with the allocations between them, and where sets are given also with what the host
  // does in between; without uploading sets, and without downloading pairs where the device had the memory to sort them.
  double device_seconds = 0;
};

} // namespace meetc

#endif
