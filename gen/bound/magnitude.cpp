// The magnitude form: |v^ - v| <= ((1 + u)^theta - 1) M.
//
// Claim, by induction over the graph: if t^ are the computed values of the leaves, with |t^ - t| <= u |t^|, and M is
// the graph on max(|t^|, floor) with additions only, then |v^ - v| <= ((1 + u)^theta - 1) M. A rounding adds u times
// the computed value or, below the normal numbers, half of the smallest subnormal. It never adds both, and the latter
// is at most u M since M >= floor^degree. The computed M^ >= M (1 - u)^phi, and a threshold K M^ is rounded once more.
#include "gen/bound/bound.hpp"
#include "gen/bound/growth.hpp"
#include "gen/ir/rewrite.hpp"

#include <algorithm>
#include <map>

namespace meetc::bound {
namespace {
using ir::node;
using ir::node_id;
using ir::op;
using poly::residency;

rational power(const rational &base, int exponent) {
  rational out = 1;
  for (int i = 0; i < exponent; ++i)
    out *= base;
  return out;
}

int bits_of(const rational &integer) {
  return static_cast<int>(mpz_sizeinbase(integer.get_num().get_mpz_t(), 2));
}

// The roundings of a constant itself: none where the arithmetic can represent it.
int constant_roundings(const rational &q, int significand) {
  mpz_class odd = abs(q.get_num());
  if (odd == 0)
    return 0;
  odd >>= mpz_scan1(odd.get_mpz_t(), 0);
  return bits_of(rational(odd)) > significand;
}

// Counts theta and phi of every node; phi is for fp32 or fp64, where a*b + c is rounded once.
struct counting {
  using value = roundings;
  const arithmetic &in;

  static value sum(const value &x, const value &y) {
    return {std::max(x.theta, y.theta) + 1, std::max(x.phi, y.phi) + 1, std::max(x.degree, y.degree)};
  }
  static value product(const value &x, const value &y) {
    return {x.theta + y.theta, x.phi + y.phi, x.degree + y.degree};
  }

  std::optional<value> given(const ir::node_ref &at) const {
    const auto l = leaf_at(at.nodes, at.id);
    if (!l)
      return std::nullopt;
    return value{l->subtrahend >= 0 && in.leaf_rounds ? 1 : 0, 0, 1};
  }
  value input(const ir::node_ref &, int) const { return {}; } // a leaf
  value constant(const ir::node_ref &, const rational &q) const {
    const int m_significand = in.precision == 24 ? 24 : 53;
    return {constant_roundings(q, in.significand), constant_roundings(q, m_significand), 0};
  }
  value negate(const ir::node_ref &, const value &x) const { return x; }
  value add(const ir::node_ref &, const value &x, const value &y) const { return sum(x, y); }
  value subtract(const ir::node_ref &, const value &x, const value &y) const { return sum(x, y); }
  value multiply(const ir::node_ref &at, const value &x, const value &y) const {
    value r = product(x, y);
    if (!scales_exactly(at.nodes, at.id)) {
      ++r.theta;
      ++r.phi;
    }
    return r;
  }
  value fused(const ir::node_ref &, const value &x, const value &y, const value &z) const {
    value r = product(x, y);
    r.theta += !in.fuses;
    return sum(r, z);
  }
};

bool last_operation_rounds(const ir::arena &nodes, node_id id) {
  const op kind = nodes.at(last_rounding_of(nodes, id).node).kind;
  return kind != op::input && kind != op::constant;
}

std::vector<roundings> of_results(const ir::program &p, const arithmetic &a) {
  std::vector<roundings> out = ir::fold_results(p, counting{a});
  for (std::size_t i = 0; i < out.size(); ++i)
    if (a.monotonic && last_operation_rounds(p.nodes, p.results[i]) && out[i].theta > 0)
      --out[i].theta;
  return out;
}

// The graph on magnitudes, node for node, over leaves. A value is a node of it, or -1 for a leaf that is not read.
struct on_magnitudes {
  using value = node_id;
  const std::map<node_id, int> &leaves; // the leaves that are read, by node
  ir::arena to;

  std::optional<value> given(const ir::node_ref &at) {
    if (!leaf_at(at.nodes, at.id))
      return std::nullopt;
    const auto it = leaves.find(at.id);
    return it == leaves.end() ? -1 : to.input(it->second);
  }
  value input(const ir::node_ref &, int) const { return -1; } // a leaf
  value constant(const ir::node_ref &, const rational &q) { return to.constant(abs(q)); }
  value negate(const ir::node_ref &, value x) const { return x; }
  value add(const ir::node_ref &, value x, value y) { return to.add(x, y); }
  value subtract(const ir::node_ref &, value x, value y) { return to.add(x, y); }
  value multiply(const ir::node_ref &, value x, value y) { return to.multiply(x, y); }
  value fused(const ir::node_ref &, value x, value y, value z) { return to.fused(x, y, z); }
};

void make_magnitudes(const ir::program &p, stage_bounds &out) {
  const std::vector<node_id> ids = ir::needed(p.nodes, p.results);
  // A leaf that only a difference reads is not listed by itself, since the difference is the leaf.
  std::vector<char> read(p.nodes.size());
  for (const node_id r : p.results)
    read[static_cast<std::size_t>(r)] = 1;
  for (const node_id id : ids)
    if (!leaf_at(p.nodes, id))
      for (const node_id operand : ir::operands(p.nodes.at(id)))
        read[static_cast<std::size_t>(operand)] = 1;
  std::map<leaf, int> number;
  std::map<node_id, int> leaves;
  std::vector<residency> where;
  for (const node_id id : ids)
    if (const auto l = leaf_at(p.nodes, id); l && read[static_cast<std::size_t>(id)]) {
      const auto [it, fresh] = number.try_emplace(*l, static_cast<int>(out.leaves.size()));
      leaves[id] = it->second;
      if (fresh) {
        out.leaves.push_back(*l);
        where.push_back(l->where);
      }
    }
  on_magnitudes d{leaves, ir::arena(where)};
  std::vector<node_id> results = ir::fold(p, d).of(p.results);
  out.magnitudes = {std::move(d.to), std::move(results)};
}

// The widest differences, in bits on a common grid, for which values of degree 1 and 2 are exact in fp64 and the others
// in double-double (there an integer below 2^100 has an error below 1/2 and is an integer, so it is exact).
int exact_window(const ir::program &p, bool mixed, const std::vector<int> &weights) {
  const std::vector<growth> all = growths(p, true, weights);
  int window = 53;
  for (const node_id id : ir::needed(p.nodes, p.results)) {
    const growth &g = all[static_cast<std::size_t>(id)];
    const int room = mixed && g.degree >= 3 ? 100 : 53;
    if (g.degree > 0)
      window = std::min(window, (room - g.bits_more) / g.degree);
  }
  return window;
}

bool can_be_mixed(const ir::program &p, const std::vector<growth> &all) {
  bool wide = false;
  for (const node_id id : ir::needed(p.nodes, p.results))
    if (all[static_cast<std::size_t>(id)].degree >= 3) {
      wide = true;
      if (p.nodes.where(id) != residency::pair)
        return false;
    }
  return wide;
}

// The degrees of the results in each group, or nothing where a value is not homogeneous in one.
std::optional<std::vector<std::vector<int>>> degrees_of(const ir::program &p, const grading &groups) {
  std::vector<std::vector<int>> out(p.results.size());
  for (int j = 0; j < groups.groups(); ++j) {
    const std::vector<growth> all = growths(p, false, groups.of_group(j));
    if (all.empty())
      return std::nullopt;
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i].push_back(all[static_cast<std::size_t>(p.results[i])].degree);
  }
  return out;
}

// Returns nothing where a value is not homogeneous.
std::optional<stage_bounds> bounds_of(const ir::program &p, const grading &groups) {
  stage_bounds out;
  const bool one_group = groups.weights.empty();
  if (!one_group) {
    auto degrees = degrees_of(p, groups);
    if (!degrees)
      return std::nullopt;
    out.degrees = std::move(*degrees);
  }
  const std::vector<int> weights = groups.total();
  const std::vector<growth> all = growths(p, false, weights);
  if (all.empty())
    return std::nullopt;
  for (const int w : weights) // an input that no value reads is converted as well
    out.degree = std::max(out.degree, w);
  for (const growth &g : all) {
    out.degree = std::max(out.degree, g.degree);
    out.growth = std::max(out.growth, g.bits_more);
  }
  make_magnitudes(p, out);
  out.fp32 = of_results(p, fp32);
  out.fp64 = of_results(p, fp64);
  out.fp64x2 = of_results(p, fp64x2);
  int factors = 1; // the most leaves that are multiplied
  for (const roundings &r : out.fp32)
    factors = std::max(factors, r.degree);
  out.floor_fp32 = -(102 / factors);
  // No float32 difference is below 2^-149. Above degree 6 the floor keeps products of doubles above the subnormals.
  out.floor_fp64 = std::max(-200, -(900 / factors));
  out.mixed = one_group && can_be_mixed(p, growths(p, true));
  out.window = exact_window(p, out.mixed, weights);
  if (!one_group)
    return out;
  out.box_lowest = -(102 / out.degree);
  out.box_highest = (120 - out.growth) / out.degree;
  for (const box_node &n : box_nodes(p, 24, box_format_lowest).of(p.results))
    out.box.push_back({rounded_up(n.unrounded_error, 12), n.a, n.b, n.pair});
  return out;
}
std::optional<stage_bounds> bounds_of(const subject::stage &s, const grading &groups) {
  if (s.signs.empty())
    return stage_bounds();
  auto out = bounds_of(*s.code, groups);
  if (out) {
    ir::program parted = ir::unfused(*s.code);
    auto bounds = bounds_of(parted, groups);
    out->unfused = std::make_shared<const unfused_stage>(unfused_stage{std::move(parted), std::move(*bounds)});
  }
  return out;
}
} // namespace

std::optional<leaf> leaf_at(const ir::arena &nodes, node_id id) {
  const node &n = nodes.at(id);
  if (n.kind == op::input)
    return leaf{n.a, -1, nodes.where(id)};
  if (n.kind == op::subtract && nodes.at(n.a).kind == op::input && nodes.at(n.b).kind == op::input)
    return leaf{nodes.at(n.a).a, nodes.at(n.b).a, nodes.where(id)};
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
  // 2^(size - 1) < q < 2^(size + 1), so after a shift by less than size - bits, q would need more than `bits` bits.
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
  if (!a.leaf_rounds) // M has differences rounded in fp64, v exact ones; v^ is represented by its high word
    k *= power(1 + in_m, r.degree + 8);
  return k;
}

std::optional<kernel_bounds> analyse(const subject &of) {
  kernel_bounds out;
  std::vector<const poly::poly *> signs;
  for (const subject::stage &s : of.stages)
    signs.insert(signs.end(), s.signs.begin(), s.signs.end());
  auto groups = find_grading(signs, of.local);
  if (!groups)
    return std::nullopt;
  out.groups = std::move(*groups);
  const auto to = out.stages();
  for (std::size_t i = 0; i < to.size(); ++i) {
    auto b = bounds_of(of.stages[i], out.groups);
    if (!b)
      return std::nullopt;
    *to[i] = std::move(*b);
  }
  find_coincidences(of, out);
  return out;
}

} // namespace meetc::bound
