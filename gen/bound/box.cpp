// The box form: the recurrence of (bound, error) on scaled values, in exact rationals.
//
// Leaves of A are divided by alpha, of B by beta, of the pair by D: powers of two with alpha, beta <= D, so scaling
// commutes with rounding but for the subnormals, whose spacing grows to at most 2^box_format_lowest. A sum of terms
// with different powers is scaled by the least powers of alpha and of beta; its terms then only get smaller.
#include "gen/bound/bound.hpp"

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
} // namespace

bool scales_exactly(const ir::program &p, node_id id) {
  const node &n = p.nodes.at(id);
  const auto is_power_of_two = [&](node_id factor) {
    if (p.nodes.at(factor).kind != op::constant || p.nodes.value(factor).get_den() != 1)
      return false;
    return mpz_popcount(mpz_class(abs(p.nodes.value(factor).get_num())).get_mpz_t()) == 1;
  };
  return n.kind == op::multiply && (is_power_of_two(n.a) || is_power_of_two(n.b));
}

last_rounding last_rounding_of(const ir::program &p, node_id id) {
  rational scale = 1;
  for (;;) {
    const node &n = p.nodes.at(id);
    if (n.kind == op::negate) {
      id = n.a;
    } else if (scales_exactly(p, id)) {
      const bool first = p.nodes.at(n.a).kind == op::constant;
      scale *= abs(p.nodes.value(first ? n.a : n.b));
      id = first ? n.b : n.a;
    } else {
      return {id, scale};
    }
  }
}

std::vector<box_node> box_nodes(const ir::program &p, int precision, int lowest_exponent) {
  const rounder in{precision, lowest_exponent};
  std::vector<box_node> out(p.nodes.size());
  const auto of = [&](node_id id) -> box_node & { return out[static_cast<std::size_t>(id)]; };
  const auto product = [](const box_node &x, const box_node &y) {
    box_node r;
    r.exact = x.exact * y.exact;
    r.computed = x.computed * y.computed;
    r.error = r.unrounded_error = x.error * y.exact + x.exact * y.error + x.error * y.error;
    r.a = x.a + y.a;
    r.b = x.b + y.b;
    r.pair = x.pair + y.pair;
    return r;
  };
  const auto sum = [&](const box_node &x, const box_node &y) {
    box_node r;
    r.exact = x.exact + y.exact;
    r.unrounded_error = x.error + y.error;
    take_scale_of_sum(r, x, y);
    in.round(r, x.computed + y.computed);
    return r;
  };
  for (const node_id id : ir::needed(p.nodes, p.results)) {
    const node &n = p.nodes.at(id);
    if (const auto l = leaf_at(p, id)) {
      box_node r;
      r.exact = r.computed = 1;
      r.error = l->subtrahend >= 0 ? in.error(1) : rational(0);
      (l->where == residency::a ? r.a : l->where == residency::b ? r.b : r.pair) = 1;
      of(id) = r;
      continue;
    }
    switch (n.kind) {
    case op::input:
      break;
    case op::constant: {
      box_node r;
      const rational q = abs(p.nodes.value(id));
      r.exact = q;
      r.computed = rounded_up(q, precision);
      r.error = r.unrounded_error = r.computed - q;
      of(id) = r;
      break;
    }
    case op::negate:
      of(id) = of(n.a);
      break;
    case op::add:
    case op::subtract:
      of(id) = sum(of(n.a), of(n.b));
      break;
    case op::multiply: {
      box_node r = product(of(n.a), of(n.b));
      if (scales_exactly(p, id)) {
        const bool first = p.nodes.at(n.a).kind == op::constant;
        const node_id scaled = first ? n.b : n.a, by = first ? n.a : n.b;
        r.unrounded_error = of(scaled).unrounded_error * abs(p.nodes.value(by));
      } else {
        in.round(r, r.computed);
      }
      of(id) = r;
      break;
    }
    case op::fused:
      of(id) = sum(product(of(n.a), of(n.b)), of(n.c));
      break;
    }
  }
  return out;
}

} // namespace meetc::bound
