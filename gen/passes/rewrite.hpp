// The domain of passes that rebuild a program, operation by operation. A pass derives from it and overrides members.
#pragma once
#include "gen/ir/fold.hpp"

namespace meetc::passes {

struct rewrite {
  using value = ir::node_id; // in `to`
  ir::arena to;

  explicit rewrite(const ir::arena &from) : to(from.inputs()) {}

  value input(const ir::node_ref &, int number) { return to.input(number); }
  value constant(const ir::node_ref &, const ir::rational &q) { return to.constant(q); }
  value negate(const ir::node_ref &, value x) { return to.negate(x); }
  value add(const ir::node_ref &, value x, value y) { return to.add(x, y); }
  value subtract(const ir::node_ref &, value x, value y) { return to.subtract(x, y); }
  value multiply(const ir::node_ref &, value x, value y) { return to.multiply(x, y); }
  value fused(const ir::node_ref &, value x, value y, value z) { return to.fused(x, y, z); }
};

} // namespace meetc::passes
