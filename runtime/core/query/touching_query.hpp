// core/query/touching_query.hpp: a query of two prepared sets, checked and ready: what collide() and its chunks have in common.
#ifndef MEETC_CORE_QUERY_TOUCHING_QUERY_HPP
#define MEETC_CORE_QUERY_TOUCHING_QUERY_HPP

#include "meet/core/query/collide.hpp"
#include "meet/core/query/decide.hpp"
#include "meet/core/query/operand.hpp"

namespace meetc {

// Throws usage_error.
inline void require(bool holds, const char *what) {
  if (!holds)
    throw usage_error(what);
}

class touching_query {
public:
  // All must outlive it. Throws as collide() does.
  touching_query(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
                 const collide_options &options);

  // The set that is walked, in the caller's units; the set of the same elements whose rows are decided, which may be
  // normalised; and what that one stores.
  const element_set &walked_a() const { return of_a_.given.set(); }
  const element_set &a() const { return of_a_.set(); }
  stored_operand stored_a() const { return of_a_.stored(by_.stored_a, *by_.predicate->a); }
  const cascade &by() const { return by_; }
  const execution &on() const { return on_; }
  // Whether a and b are one set, of whose pairs half are enough.
  bool half() const { return half_; }

  // Takes the hits of b and of `a`, which are all elements of a or a part of them; `walked` has the same ones.
  tally run(const element_set &walked, const element_set &a, const stored_operand &stored_a, bool half,
            std::span<query_answer *const> takers, const std::function<void(double)> &progress) const;
  // Starts an answer about `a`.
  void start(query_answer &answer, const element_set &a) const;

private:
  std::size_t elements_a_, elements_b_;
  cascade by_;
  query_operand of_a_, of_b_;
  execution on_;
  bool half_;
  ruled_out_by what_;
};

} // namespace meetc

#endif
