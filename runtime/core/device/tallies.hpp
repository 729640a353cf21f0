// core/device/tallies.hpp: what is counted of the hits of each element, or of each instance of a set, without a list of pairs.
#ifndef MEETC_CORE_DEVICE_TALLIES_HPP
#define MEETC_CORE_DEVICE_TALLIES_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/device/memory.hpp"
#include "meet/core/query/collide.hpp"

#include <span>

namespace meetc {

// All members enqueue their work on the stream, finish() waits for it, and all throw device_error.
class tallies {
public:
  // For `counts` or `flags` of so many elements; or, if of_instances is not empty, for the pairs of as many instances of B.
  void start(answer_kind want, std::uint32_t elements_a, std::uint32_t elements_b,
             std::span<const std::uint64_t> of_instances, cudaStream_t stream);
  // Adds n hits, pairs of slots. Of instances, order_b is not read.
  void add(const index_pair *hits, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *order_b,
           cudaStream_t stream);
  // Fills counts or flags of r, or of_instances.
  void finish(result &r, std::span<std::uint64_t> of_instances, cudaStream_t stream);

private:
  answer_kind want_ = answer_kind::counts;
  std::uint32_t elements_a_ = 0, elements_b_ = 0, of_instance_ = 0; // the slots of an instance; 0: there are none
  device_memory<unsigned long long> counts_a_, counts_b_;
  device_memory<std::uint8_t> flags_a_, flags_b_;
};

} // namespace meetc

#endif
