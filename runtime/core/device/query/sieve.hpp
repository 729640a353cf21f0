// core/device/query/sieve.hpp: what takes the candidates of a part before they are decided.
#ifndef MEETC_CORE_DEVICE_QUERY_SIEVE_HPP
#define MEETC_CORE_DEVICE_QUERY_SIEVE_HPP

#include "meetc/cuda/table.hpp"

namespace meetc {

class candidate_sieve {
public:
  virtual ~candidate_sieve() = default;

  // Enqueues. Candidates that are to be decided go to `kept`, whose list is as long and whose count is 0. It may add others to
  // the hits, and may then write over the candidates.
  virtual void sift(const cuda::pair_list &candidates, const cuda::pair_list &kept, const cuda::pair_list &hits) = 0;
  // Called after a part that counts, whose counters the host has read.
  virtual void take() = 0;
};

} // namespace meetc

#endif
