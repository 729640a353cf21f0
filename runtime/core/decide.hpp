// core/decide.hpp: decides candidates on all threads.
//
// Each thread collects candidates in a batch and takes it through the cascade; a rung sees only the pairs that the one
// before left unsure. The taker gets each hit by the caller's element indices. Memory is one batch for each thread,
// however many candidates or hits there are.
#ifndef MEETC_CORE_DECIDE_HPP
#define MEETC_CORE_DECIDE_HPP

#include "core/candidates.hpp"
#include "core/cascade.hpp"
#include "core/stored.hpp"

namespace meetc {

// Takes hits in any order. A worker passes only its own number; different workers call at the same time.
class hit_taker {
public:
  virtual ~hit_taker() = default;
  virtual void take(int worker, const index_pair *hits, std::size_t n) = 0;
};

struct decision_job {
  const element_set &a, &b;
  stored_operand stored_a, stored_b; // for by.stored_a and by.stored_b
  const cascade &by;
  const candidate_source &source;
  int threads;
  bool stop_at_first;
  void (*progress)(void *context, double fraction); // may be null; called from the calling thread a few times a second
  void *progress_context;
  hit_taker *taker;             // null: only count
  hit_taker *by_slot = nullptr; // gets each hit by the slots of its elements, before the taker; null: none
  // Each candidate {a, b} stands for {b, a} as well, which has the same answer; a and b are one set, and nothing is taken by
  // slots.
  bool both_ways = false;
};

struct tally {
  std::uint64_t candidates = 0, hits = 0;
  rung_report rungs;
};

std::size_t batch_bytes(int threads);

// `batches` holds batch_bytes(threads). With stop_at_first, hits is 0 or 1, the taker is not called, and no unnecessary
// rung runs.
tally decide_all(const decision_job &job, memory batches);

} // namespace meetc

#endif
