// core/device/answers/first_met.hpp: the element of b that each element of a meets first on its way from its first point to its
// second, found without a list of pairs on the host.
#ifndef MEETC_CORE_DEVICE_ANSWERS_FIRST_MET_HPP
#define MEETC_CORE_DEVICE_ANSWERS_FIRST_MET_HPP

#include "meet/core/device/answers/query_answer.hpp"
#include "meet/core/device/memory/memory.hpp"

#include <span>

namespace meetc::on_device {

class first_met final : public query_answer {
public:
  // The launchers know an order. owner_b: the items of b's elements, or empty.
  first_met(const cuda::pair_launchers &by, std::span<const std::uint32_t> owner_b) : by_(by), owner_b_(owner_b) {}

  void start(const queried_sets &sets) override;
  void take(const part_hits &hits) override;
  void finish() override;
  void download(device_result &r) override;

private:
  const cuda::pair_launchers &by_;
  std::span<const std::uint32_t> owner_b_;
  const device *on_ = nullptr;
  const device_rows *a_ = nullptr, *b_ = nullptr;
  device_memory<std::uint32_t> owners_there_;                          // of b; without memory there are none
  device_memory<std::uint32_t> *slots_ = nullptr, *numbers_ = nullptr; // slots of b by slots of a; numbers by numbers
};

} // namespace meetc::on_device

#endif
