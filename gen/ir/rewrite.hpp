// The domain that rebuilds a program, operation by operation. A pass derives from it and overrides members.
#pragma once
#include "gen/ir/fold.hpp"

namespace meetc::ir {

struct rewrite {
  using value = node_id; // in `to`
  arena to;

  explicit rewrite(const arena &from) : to(from.inputs()) {}

  value input(const node_ref &, int number) { return to.input(number); }
  value constant(const node_ref &, const rational &q) { return to.constant(q); }
  value negate(const node_ref &, value x) { return to.negate(x); }
  value add(const node_ref &, value x, value y) { return to.add(x, y); }
  value subtract(const node_ref &, value x, value y) { return to.subtract(x, y); }
  value multiply(const node_ref &, value x, value y) { return to.multiply(x, y); }
  value fused(const node_ref &, value x, value y, value z) { return to.fused(x, y, z); }
};

// The program with a product and a sum for every fused multiply-add, for machines without that instruction. The order
// of the operands is that of the emitted fma(), x * y + z.
program unfused(const program &p);

} // namespace meetc::ir
