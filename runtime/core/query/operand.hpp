// core/query/operand.hpp: a prepared set as an operand of a query.
#ifndef MEETC_CORE_QUERY_OPERAND_HPP
#define MEETC_CORE_QUERY_OPERAND_HPP

#include "meet/core/sets/normalised.hpp"
#include "meet/core/sets/prepared.hpp"

#include <cstring>
#include <memory>

namespace meetc {

inline bool same_kind(const kind_info &x, const kind_info &y) {
  return &x == &y || (x.fields == y.fields && std::strcmp(x.name, y.name) == 0);
}

// The set whose rows a query reads: the normalised one where there is one.
struct query_operand {
  const prepared &given;
  std::shared_ptr<const normalised_set> normal;

  const element_set &set() const { return normal ? normal->set : given.set(); }
  stored_operand stored(const stored_values &values, const kind_info &of) const {
    return {normal ? normal->stored.of(values, of) : given.stored(values, of), values};
  }
};

// Normalises both or none.
inline void normalise(query_operand &a, query_operand &b, const std::stop_token &stop) {
  const int power = normalising_power(a.given.set(), b.given.set());
  if (power == 0)
    return;
  a.normal = a.given.normalised(power, stop);
  if (a.normal)
    b.normal = b.given.normalised(power, stop);
  if (!b.normal)
    a.normal = nullptr;
}

} // namespace meetc

#endif
