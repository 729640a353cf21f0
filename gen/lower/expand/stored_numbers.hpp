// The stored numbers of operands: as a ring, and as the values that they are.
#pragma once
#include "gen/lower/expand/expand.hpp"
#include "gen/poly/local_origin.hpp"

namespace meetc::lower {

// The stored numbers of operands as a ring, "X.c.x", and how a translation moves them.
struct stored_ring {
  std::shared_ptr<poly::ring> numbers;
  std::vector<poly::stored_number> moves;
};
stored_ring stored_numbers(const lower::model &m, const std::vector<std::string> &names,
                           const std::vector<const lang::kind *> &kinds);

// The stored number that a value is. Throws spec_error, which says that `what` must be one.
int input_of(const value &v, const char *what, const location &where);

} // namespace meetc::lower
