// core/answers/query_answer.hpp: the interface between a query and what it answers.
//
// A query yields batches of decided pairs, and each answer takes from them what it needs. The query knows none of the
// answers, and an answer does not know how pairs are found or decided.
#ifndef MEETC_CORE_ANSWERS_QUERY_ANSWER_HPP
#define MEETC_CORE_ANSWERS_QUERY_ANSWER_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/sets/element_set.hpp"

namespace meetc {

// The sets whose rows the query reads, and on what it runs: as many workers at most call take().
struct queried_sets {
  const element_set &a, &b;
  std::size_t elements_a, elements_b; // of the caller, of which the sets may hold some
  execution on;
};

class query_answer {
public:
  virtual ~query_answer() = default;

  // Called once, before the first batch.
  virtual void start(const queried_sets &sets) = 0;
  // Takes n hits in any order: pairs of slots where by_slots() holds, else pairs of the caller's elements. If needs_pairs() is
  // false, only n means something. A worker passes only its own number, and different workers call at the same time. Loops
  // that take long, here and in finish(), look at queried_sets::on.
  virtual void take(int worker, const index_pair *hits, std::size_t n) = 0;
  // Called once, after the last batch: fills its part of the result. Throws std::bad_alloc.
  virtual void finish(result &r) = 0;

  // Whether it needs the pairs, or only their number, which each query counts.
  virtual bool needs_pairs() const { return true; }
  virtual bool by_slots() const { return false; }
  // Whether it may be done before the last pair. A query whose answers all are done stops.
  virtual bool stops_early() const { return false; }
  virtual bool done() const { return false; }
};

} // namespace meetc

#endif
