// The domain of passes that rebuild a program, operation by operation. A pass derives from it and overrides members.
#pragma once
#include "gen/ir/fold.hpp"

namespace meetc::passes {

struct rewrite {
  using value = ir::node_id; // in `to`
  ir::arena to;

  explicit rewrite(const ir::arena &from) : to(from.inputs()) {}

  value input(const ir::place &, int number) { return to.input(number); }
  value constant(const ir::place &, const ir::rational &q) { return to.constant(q); }
  value negate(const ir::place &, value x) { return to.negate(x); }
  value add(const ir::place &, value x, value y) { return to.add(x, y); }
  value subtract(const ir::place &, value x, value y) { return to.subtract(x, y); }
  value multiply(const ir::place &, value x, value y) { return to.multiply(x, y); }
  value fused(const ir::place &, value x, value y, value z) { return to.fused(x, y, z); }
};

} // namespace meetc::passes
