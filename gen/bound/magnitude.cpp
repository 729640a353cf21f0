// The magnitude form: |v^ - v| <= ((1 + u)^theta - 1) M.
//
// Claim, by induction over the graph: with the leaves' computed values t^, |t^ - t| <= u |t^|, and M the graph on
// max(|t^|, floor) with additions only, |v^ - v| <= ((1 + u)^theta - 1) M. A rounding adds u times the computed
// value, or, below the normal numbers, half of the smallest subnormal; never both, and the latter is at most u M
// since M >= floor^degree. The computed M^ >= M (1 - u)^phi, and a threshold K M^ is rounded once more.
#include "gen/bound/bound.hpp"

#include <algorithm>
#include <map>

namespace meetc::bound {
namespace {
using ir::node;
using ir::node_id;
using ir::op;
using poly::residency;

rational power(rational base, int exponent) {
  rational out = 1;
  for (int i = 0; i < exponent; ++i)
    out *= base;
  return out;
}

int bits_of(const rational &integer) {
  return static_cast<int>(mpz_sizeinbase(integer.get_num().get_mpz_t(), 2));
}

// A constant's own roundings: none where the arithmetic holds it.
int constant_roundings(const rational &q, int significand) {
  mpz_class odd = abs(q.get_num());
  if (odd == 0)
    return 0;
  odd >>= mpz_scan1(odd.get_mpz_t(), 0);
  return bits_of(rational(odd)) > significand;
}

// theta and phi of every node; phi counts in fp32 or fp64, where a*b + c is one rounding.
std::vector<roundings> count_roundings(const ir::program &p, const arithmetic &a) {
  std::vector<roundings> out(p.nodes.size());
  const auto of = [&](node_id id) -> roundings & { return out[static_cast<std::size_t>(id)]; };
  const int m_significand = a.precision == 24 ? 24 : 53;
  const auto sum = [](const roundings &x, const roundings &y) {
    return roundings{std::max(x.theta, y.theta) + 1, std::max(x.phi, y.phi) + 1, std::max(x.degree, y.degree)};
  };
  const auto product = [](const roundings &x, const roundings &y) {
    return roundings{x.theta + y.theta, x.phi + y.phi, x.degree + y.degree};
  };
  for (const node_id id : ir::needed(p.nodes, p.results)) {
    const node &n = p.nodes.at(id);
    if (const auto l = leaf_at(p, id)) {
      of(id) = {l->subtrahend >= 0 && a.leaf_rounds ? 1 : 0, 0, 1};
      continue;
    }
    switch (n.kind) {
    case op::input: // leaf_at
      break;
    case op::constant:
      of(id) = {constant_roundings(p.nodes.value(id), a.significand),
                constant_roundings(p.nodes.value(id), m_significand), 0};
      break;
    case op::negate:
      of(id) = of(n.a);
      break;
    case op::add:
    case op::subtract:
      of(id) = sum(of(n.a), of(n.b));
      break;
    case op::multiply: {
      of(id) = product(of(n.a), of(n.b));
      if (!scales_exactly(p, id)) {
        ++of(id).theta;
        ++of(id).phi;
      }
      break;
    }
    case op::fused: {
      roundings r = product(of(n.a), of(n.b));
      r.theta += !a.fuses;
      of(id) = sum(r, of(n.c));
      break;
    }
    }
  }
  return out;
}

bool last_operation_rounds(const ir::program &p, node_id id) {
  const op kind = p.nodes.at(last_rounding_of(p, id).node).kind;
  return kind != op::input && kind != op::constant;
}

std::vector<roundings> of_results(const ir::program &p, const arithmetic &a) {
  const std::vector<roundings> all = count_roundings(p, a);
  std::vector<roundings> out;
  for (const node_id r : p.results) {
    out.push_back(all[static_cast<std::size_t>(r)]);
    if (a.monotonic && last_operation_rounds(p, r) && out.back().theta > 0)
      --out.back().theta;
  }
  return out;
}

// The graph on magnitudes, node for node, over leaves.
void make_magnitudes(const ir::program &p, stage_bounds &out) {
  const std::vector<node_id> ids = ir::needed(p.nodes, p.results);
  std::map<leaf, int> number;
  // A leaf that is read only by a difference is not one of its own: differences come first.
  std::vector<char> read(p.nodes.size());
  for (const node_id r : p.results)
    read[static_cast<std::size_t>(r)] = 1;
  for (const node_id id : ids) {
    const node &n = p.nodes.at(id);
    if (leaf_at(p, id) || n.kind == op::constant)
      continue;
    for (const node_id operand : {n.a, n.b, n.c})
      if (operand >= 0)
        read[static_cast<std::size_t>(operand)] = 1;
  }
  std::vector<residency> where;
  for (const node_id id : ids)
    if (const auto l = leaf_at(p, id);
        l && read[static_cast<std::size_t>(id)] && number.try_emplace(*l, out.leaves.size()).second) {
      out.leaves.push_back(*l);
      where.push_back(l->where);
    }
  out.magnitudes = {ir::arena(where), {}};
  ir::arena &to = out.magnitudes.nodes;
  std::map<node_id, node_id> moved;
  for (const node_id id : ids) {
    const node &n = p.nodes.at(id);
    const auto of = [&](node_id i) { return moved.at(i); };
    if (const auto l = leaf_at(p, id)) {
      if (read[static_cast<std::size_t>(id)])
        moved[id] = to.input(number.at(*l));
      continue;
    }
    switch (n.kind) {
    case op::input:
      break;
    case op::constant:
      moved[id] = to.constant(abs(p.nodes.value(id)));
      break;
    case op::negate:
      moved[id] = of(n.a);
      break;
    case op::add:
    case op::subtract:
      moved[id] = to.add(of(n.a), of(n.b));
      break;
    case op::multiply:
      moved[id] = to.multiply(of(n.a), of(n.b));
      break;
    case op::fused:
      moved[id] = to.fused(of(n.a), of(n.b), of(n.c));
      break;
    }
  }
  for (const node_id r : p.results)
    out.magnitudes.results.push_back(moved.at(r));
}

// The widest differences, in bits on a common grid, for which values of degree 1 and 2 are exact in fp64 and the
// others in double-double (an integer below 2^100 has an error below 1/2 there, and is an integer).
int exact_window(const ir::program &p, bool mixed) {
  const std::vector<ir::magnitude> all = ir::magnitudes(p, true);
  int window = 53;
  for (const node_id id : ir::needed(p.nodes, p.results)) {
    const ir::magnitude &m = all[static_cast<std::size_t>(id)];
    const int room = mixed && m.degree >= 3 ? 100 : 53;
    if (m.degree > 0)
      window = std::min(window, (room - m.growth) / m.degree);
  }
  return window;
}

bool can_be_mixed(const ir::program &p) {
  const std::vector<ir::magnitude> all = ir::magnitudes(p, true);
  bool wide = false;
  for (const node_id id : ir::needed(p.nodes, p.results))
    if (all[static_cast<std::size_t>(id)].degree >= 3) {
      wide = true;
      if (p.nodes.where(id) != residency::pair)
        return false;
    }
  return wide;
}

stage_bounds bounds_of(const lower::stage &s) {
  stage_bounds out;
  if (s.atoms.empty())
    return out;
  make_magnitudes(s.code, out);
  out.fp32 = of_results(s.code, fp32);
  out.fp64 = of_results(s.code, fp64);
  out.fp64x2 = of_results(s.code, fp64x2);
  out.degree = s.degree;
  out.floor_fp32 = -(102 / s.degree);
  // No float32 difference is below 2^-149; above degree 6 the floor keeps products of doubles out of the subnormals.
  out.floor_fp64 = std::max(-200, -(900 / s.degree));
  out.mixed = can_be_mixed(s.code);
  out.window = exact_window(s.code, out.mixed);
  out.box_lowest = -(102 / s.degree);
  out.box_highest = (120 - s.growth) / s.degree;
  const std::vector<box_node> nodes = box_nodes(s.code, 24, box_format_lowest);
  for (const node_id r : s.code.results) {
    const box_node &n = nodes[static_cast<std::size_t>(r)];
    out.box.push_back({rounded_up(n.unrounded_error, 12), n.a, n.b, n.pair});
  }
  return out;
}
} // namespace

std::optional<leaf> leaf_at(const ir::program &p, node_id id) {
  const node &n = p.nodes.at(id);
  if (n.kind == op::input)
    return leaf{n.a, -1, p.nodes.where(id)};
  if (n.kind == op::subtract && p.nodes.at(n.a).kind == op::input && p.nodes.at(n.b).kind == op::input)
    return leaf{p.nodes.at(n.a).a, p.nodes.at(n.b).a, p.nodes.where(id)};
  return std::nullopt;
}

std::vector<leaf> leaves_of(const stage_bounds &s, poly::residency of) {
  std::vector<leaf> out;
  for (const leaf &l : s.leaves)
    if (l.where == of)
      out.push_back(l);
  return out;
}

rational power_of_two(int exponent) {
  mpz_class z = 1;
  z <<= std::abs(exponent);
  return exponent >= 0 ? rational(z) : rational(mpz_class(1), z);
}

rational rounded_up(const rational &q, int bits) {
  if (q == 0)
    return 0;
  // 2^(size - 1) < q < 2^(size + 1): shifted by less than size - bits, q needs more than `bits` bits.
  const int size = static_cast<int>(mpz_sizeinbase(q.get_num().get_mpz_t(), 2)) -
                   static_cast<int>(mpz_sizeinbase(q.get_den().get_mpz_t(), 2));
  for (int shift = size - bits;; ++shift) {
    const rational scaled = q / power_of_two(shift);
    mpz_class up;
    mpz_cdiv_q(up.get_mpz_t(), scaled.get_num().get_mpz_t(), scaled.get_den().get_mpz_t());
    if (up <= (mpz_class(1) << bits))
      return rational(up) * power_of_two(shift);
  }
}

rational factor(const arithmetic &a, const roundings &r) {
  const rational u = power_of_two(-a.precision), in_m = power_of_two(a.precision == 24 ? -24 : -53);
  if (r.theta == 0)
    return 0;
  rational k = (power(1 + u, r.theta) - 1) / power(1 - in_m, r.phi + 1);
  if (!a.leaf_rounds) // M is of differences rounded in fp64, the values are of exact ones; the high word stands for v^
    k *= power(1 + in_m, r.degree + 8);
  return k;
}

kernel_bounds analyse(const lower::predicate &p) {
  kernel_bounds out;
  out.reject = bounds_of(p.reject);
  out.common = bounds_of(p.common);
  out.rare = bounds_of(p.rare);
  find_coincidences(p, out);
  return out;
}

} // namespace meetc::bound
