// core/query/decide.hpp: decides candidates on all threads.
//
// Each thread collects candidates in a batch and takes it through the cascade; a rung sees only the pairs that the one
// before left unsure. The answers get each hit. Memory is one batch for each thread, however many candidates or hits there
// are.
#ifndef MEETC_CORE_QUERY_DECIDE_HPP
#define MEETC_CORE_QUERY_DECIDE_HPP

#include "meet/core/answers/query_answer.hpp"
#include "meet/core/cascade/cascade.hpp"
#include "meet/core/sets/stored_rows.hpp"
#include "meet/core/traversal/candidates.hpp"

namespace meetc {

// Leaves out candidates that are not to be decided.
class candidate_filter {
public:
  virtual ~candidate_filter() = default;
  // Moves those that are to be decided to the front, in their order, and returns their number. Any thread may call.
  virtual std::size_t keep(index_pair *slots, std::size_t n) const = 0;
};

struct decision_job {
  const element_set &a, &b;
  stored_operand stored_a, stored_b; // for by.stored_a and by.stored_b
  const cascade &by;
  const tree_pairs &source;
  execution on;
  void (*progress)(void *context, double fraction); // may be null; called from the calling thread a few times a second
  void *progress_context;
  std::span<query_answer *const> answers; // which have been started; none: only count
  // Each candidate {a, b} stands for {b, a} as well, which has the same answer; a and b are one set, and no answer takes slots.
  bool both_ways = false;
  const candidate_filter *only = nullptr; // before the candidates are counted; null: all are decided
};

struct tally {
  std::uint64_t candidates = 0, hits = 0;
  rung_report rungs;
};

std::size_t batch_bytes(int threads);

// `batches` holds batch_bytes(threads). Throws `cancelled` and what the answers throw. Where all answers are done early, the
// counts mean nothing but that they are not 0, and no unnecessary rung runs.
tally decide_all(const decision_job &job, memory batches);

} // namespace meetc

#endif
