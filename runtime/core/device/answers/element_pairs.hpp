// core/device/answers/element_pairs.hpp: the sorted list of all pairs.
//
// The hits of a query that is one part are put into order by a kernel that follows the search, which needs no number on the
// host. Those of several parts, and those that it cannot put into order, are sorted as numbers.
#ifndef MEETC_CORE_DEVICE_ANSWERS_ELEMENT_PAIRS_HPP
#define MEETC_CORE_DEVICE_ANSWERS_ELEMENT_PAIRS_HPP

#include "meet/core/device/answers/hit_keys.hpp"
#include "meet/core/device/answers/kernels.hpp"

#include <optional>

namespace meetc::on_device {

class element_pairs final : public query_answer {
public:
  // If left_there is not null, the list becomes that one where the device has sorted it.
  explicit element_pairs(pairs_there *left_there = nullptr) : left_there_(left_there) {}

  void start(const queried_sets &sets) override;
  void take_early(const cuda::pair_list &hits) override;
  void take(const part_hits &hits) override;
  void finish() override;
  void download(device_result &r) override;

private:
  pairs_there *left_there_;
  std::optional<queried_sets> sets_;
  std::optional<hit_keys> keys_;
  bool early_ = false;                 // take_early() has put hits into order
  std::optional<std::size_t> ordered_; // these are all
};

} // namespace meetc::on_device

#endif
