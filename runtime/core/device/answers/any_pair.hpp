// core/device/answers/any_pair.hpp: whether there is a pair.
#ifndef MEETC_CORE_DEVICE_ANSWERS_ANY_PAIR_HPP
#define MEETC_CORE_DEVICE_ANSWERS_ANY_PAIR_HPP

#include "meet/core/device/answers/query_answer.hpp"

namespace meetc::on_device {

// The count becomes 0 or 1.
class any_pair final : public query_answer {
public:
  void start(const queried_sets &) override { found_ = false; }
  void take(const part_hits &hits) override { found_ = found_ || hits.n > 0; }
  void download(device_result &r) override { r.count = found_ ? 1 : 0; }
  bool needs_pairs() const override { return false; }
  bool stops_early() const override { return true; }
  bool done() const override { return found_; }

private:
  bool found_ = false;
};

} // namespace meetc::on_device

#endif
