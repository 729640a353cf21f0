// The box form: the recurrence of (bound, error) on scaled values, in exact rationals.
//
// Leaves of A are divided by alpha, those of B by beta, those of the pair by D. These are powers of two with alpha,
// beta <= D, so scaling commutes with rounding except for the subnormals, whose spacing grows to at most
// 2^box_format_lowest. A sum of terms with different powers is scaled by the least powers of alpha and of beta; its
// terms then only get smaller.
#include "gen/bound/bound.hpp"
#include "gen/ir/fold.hpp"

#include <algorithm>

namespace meetc::bound {
namespace {
using ir::node;
using ir::node_id;
using ir::op;
using poly::residency;

// The least k with w <= 2^k, w > 0.
int ceil_log2(const rational &w) {
  int k = static_cast<int>(mpz_sizeinbase(w.get_num().get_mpz_t(), 2)) -
          static_cast<int>(mpz_sizeinbase(w.get_den().get_mpz_t(), 2)) - 1;
  while (power_of_two(k) < w)
    ++k;
  return k;
}

struct rounder {
  int precision, lowest;
  // The rounding error of any value of magnitude at most w: half a unit in the last place below 2^k.
  rational error(const rational &w) const {
    if (w == 0)
      return 0;
    return power_of_two(std::max(ceil_log2(w) - precision, lowest) - 1);
  }
  void round(box_node &n, const rational &w) const {
    n.computed = rounded_up(w, precision);
    n.error = n.unrounded_error + error(w);
  }
};

void take_scale_of_sum(box_node &out, const box_node &x, const box_node &y) {
  const int degree = std::max(x.a + x.b + x.pair, y.a + y.b + y.pair);
  out.a = std::min(x.a, y.a);
  out.b = std::min(x.b, y.b);
  out.pair = degree - out.a - out.b;
}
// The recurrence: (bound, error) of every node.
struct boxing {
  using value = box_node;
  rounder in;

  value rounded(value n) const {
    in.round(n, n.computed);
    return n;
  }
  static value product(const value &x, const value &y) {
    value r;
    r.exact = x.exact * y.exact;
    r.computed = x.computed * y.computed;
    r.error = r.unrounded_error = x.error * y.exact + x.exact * y.error + x.error * y.error;
    r.a = x.a + y.a;
    r.b = x.b + y.b;
    r.pair = x.pair + y.pair;
    return r;
  }
  value sum(const value &x, const value &y) const {
    value r;
    r.exact = x.exact + y.exact;
    r.computed = x.computed + y.computed;
    r.unrounded_error = x.error + y.error;
    take_scale_of_sum(r, x, y);
    return rounded(r);
  }

  std::optional<value> given(const ir::node_ref &at) const {
    const auto l = leaf_at(at.nodes, at.id);
    if (!l)
      return std::nullopt;
    value r;
    r.exact = r.computed = 1;
    r.error = l->subtrahend >= 0 ? in.error(1) : rational(0);
    (l->where == residency::a ? r.a : l->where == residency::b ? r.b : r.pair) = 1;
    return r;
  }
  value input(const ir::node_ref &, int) const { return {}; } // a leaf
  value constant(const ir::node_ref &, const rational &q) const {
    value r;
    r.exact = abs(q);
    r.computed = rounded_up(r.exact, in.precision);
    r.error = r.unrounded_error = r.computed - r.exact;
    return r;
  }
  value negate(const ir::node_ref &, const value &x) const { return x; }
  value add(const ir::node_ref &, const value &x, const value &y) const { return sum(x, y); }
  value subtract(const ir::node_ref &, const value &x, const value &y) const { return sum(x, y); }
  value multiply(const ir::node_ref &at, const value &x, const value &y) const {
    value r = product(x, y);
    if (!scales_exactly(at.nodes, at.id))
      return rounded(r);
    const bool first = at.nodes.at(at.operation().a).kind == op::constant;
    r.unrounded_error = (first ? y : x).unrounded_error * (first ? x : y).exact;
    return r;
  }
  value fused(const ir::node_ref &, const value &x, const value &y, const value &z) const {
    return sum(product(x, y), z);
  }
};
} // namespace

bool scales_exactly(const ir::arena &nodes, node_id id) {
  const node &n = nodes.at(id);
  const auto is_power_of_two = [&](node_id factor) {
    if (nodes.at(factor).kind != op::constant || nodes.value(factor).get_den() != 1)
      return false;
    return mpz_popcount(mpz_class(abs(nodes.value(factor).get_num())).get_mpz_t()) == 1;
  };
  return n.kind == op::multiply && (is_power_of_two(n.a) || is_power_of_two(n.b));
}

last_rounding last_rounding_of(const ir::arena &nodes, node_id id) {
  rational scale = 1;
  for (;;) {
    const node &n = nodes.at(id);
    if (n.kind == op::negate) {
      id = n.a;
    } else if (scales_exactly(nodes, id)) {
      const bool first = nodes.at(n.a).kind == op::constant;
      scale *= abs(nodes.value(first ? n.a : n.b));
      id = first ? n.b : n.a;
    } else {
      return {id, scale};
    }
  }
}

ir::folded<box_node> box_nodes(const ir::program &p, int precision, int lowest_exponent) {
  boxing d{{precision, lowest_exponent}};
  return ir::fold(p, d);
}

} // namespace meetc::bound
