// core/sets/normalised.hpp: the rows of a set, multiplied by a power of two.
//
// Where the numbers of two sets are very small or very large, products of three and more of them leave float32's range,
// so that fp32 decides nothing. Signs of predicates do not change when all numbers are multiplied by one positive
// number, and multiplying by a power of two is exact unless the result leaves float32's range or loses a bit as a
// subnormal. Boxes and the answers keep the caller's units.
#ifndef MEETC_CORE_SETS_NORMALISED_HPP
#define MEETC_CORE_SETS_NORMALISED_HPP

#include "meet/core/sets/element_set.hpp"
#include "meet/core/sets/stored_rows.hpp"

#include <memory>
#include <mutex>

namespace meetc {

// A k for which the numbers of both sets times 2^k have room for their products; 0 where they have it as they are. It
// is a multiple of 16, so that a set that meets many others is seldom normalised twice.
int normalising_power(const element_set &a, const element_set &b);

// The values that a set of this kind stores for predicates; see stored.hpp.
class stored_table {
public:
  explicit stored_table(const kind_info &kind);
  // Null if there are none, or if `of`, the kind for which they are computed, is not the set's own: two catalogues may
  // number such values differently.
  stored_rows *of(const stored_values &values, const kind_info &of) const;

private:
  const kind_info *kind_;
  std::unique_ptr<stored_rows[]> rows_; // kind.stored elements
};

struct normalised_set {
  std::unique_ptr<float[]> rows;
  element_set set; // with these rows; its boxes, reach and longest are those of the original
  stored_table stored;
};

// The normalised sets of one set, made when asked for. The last one is kept.
class normalisation {
public:
  // The set times 2^power. Null where that is not exact for each number, or where memory is short. Any thread may call;
  // the set is always the same. A call that is cancelled keeps nothing.
  std::shared_ptr<const normalised_set> of(const element_set &set, int power, const execution &on = 1);

private:
  std::mutex lock_;
  int power_ = 0;
  std::shared_ptr<const normalised_set> last_; // for power_; null where there is none
};

} // namespace meetc

#endif
