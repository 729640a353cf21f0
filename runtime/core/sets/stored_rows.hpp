// core/sets/stored_rows.hpp: the values that a predicate reads beside the rows of a set, computed once that pays.
//
// A query that looks at few pairs must not compute the values of a whole set, and one that looks at many must not compute
// them for each pair. So the pairs that were looked at are counted, over all queries; once they are a quarter of the
// set's elements, one thread computes the values of all rows, while the others go on without them. Answers and counts
// do not depend on when that happens, since a stored value is bit for bit what a pair would compute.
#ifndef MEETC_CORE_SETS_STORED_ROWS_HPP
#define MEETC_CORE_SETS_STORED_ROWS_HPP

#include "meet/core/sets/element_set.hpp"

#include <atomic>
#include <memory>

namespace meetc {

class stored_rows {
public:
  // The values of all rows, or null where each pair is to compute them, given that `pairs` more are to be looked at.
  // `room` has space for values.floats numbers a row; null: the memory is allocated, and if there is none, nothing is
  // stored. Any thread may call; the set and the values are always the same. A call that is cancelled stores nothing.
  const float *after(std::size_t pairs, const element_set &set, const stored_values &values, float *room,
                     const execution &on = 1);

private:
  static bool compute(const element_set &set, const stored_values &values, float *room, const execution &on);
  std::atomic<const float *> ready_{nullptr};
  std::atomic<std::uint64_t> pairs_{0};
  std::atomic<bool> begun_{false};
  std::unique_ptr<float[]> own_;
};

// The stored values of one operand of a query; no rows: nothing is stored.
struct stored_operand {
  stored_rows *rows = nullptr;
  stored_values values = {};
  float *room = nullptr;

  const float *after(std::size_t pairs, const element_set &set, const execution &on) const {
    return rows ? rows->after(pairs, set, values, room, on) : nullptr;
  }
};

} // namespace meetc

#endif
