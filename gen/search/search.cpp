#include "gen/search/search.hpp"

#include "gen/poly/kernels.hpp"
#include "gen/poly/modulo.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace meetc::search {
namespace {

using ir::node_id;
using poly::packed;
using poly::rational;

constexpr unsigned seeds = 8; // for representatives
constexpr poly::extraction_effort narrow{1, 12, 1}, wide{4, 32, 3};
constexpr std::size_t most_changed = 400;                      // terms of all outputs, before a change of variables
constexpr std::size_t most_terms = 220;                        // after it
constexpr std::size_t longest_alone = 20, longest_output = 64; // terms of the one output, of each of several
constexpr std::size_t refined = 6;                             // systems that are searched with more effort

// A start of the search, packed.
struct start {
  value_system from; // simplified
  poly::packed_system system;
  std::vector<rational> contents;                  // of the outputs
  std::vector<std::vector<poly::reduction>> steps; // by output; of packed relations
  long cost = 0;
  bool improved = false; // by kernels that are quickly found
};

packed renamed(const packed &p, const std::vector<int> &to) {
  std::vector<poly::packed_term> out;
  for (const poly::packed_term &t : p) {
    poly::product_of f = 0;
    for (poly::product_of rest = t.of; rest != 0; rest = poly::rest_of(rest))
      f = poly::times(f, poly::factor(to[static_cast<std::size_t>(poly::first_factor(rest))]));
    out.push_back({f, t.coefficient});
  }
  return poly::joined(std::move(out));
}

// The variables of `from` in the table. Nothing where a value does not fit.
std::optional<std::vector<int>> variables_of(const value_system &from, poly::scheme_table &table,
                                             poly::packed_system &system) {
  std::vector<int> to(static_cast<std::size_t>(from.leaves()));
  for (std::size_t v = 0; v < to.size(); ++v)
    to[v] = static_cast<int>(v);
  for (const poly::poly &value : from.values) {
    const auto p = poly::pack(value);
    if (!p)
      return std::nullopt;
    const packed definition = renamed(p->of, to);
    const int v = table.value(definition);
    to.push_back(v);
    if (!system.definition(v))
      system.values.emplace_back(v, definition);
  }
  return to;
}

// The starts that one system gives: itself, and with shorter outputs modulo the relations.
void add_starts(const value_system &from, poly::scheme_table &table, std::vector<start> &out) {
  start first{simplified(from), {}, {}, {}, 0};
  const auto to = variables_of(first.from, table, first.system);
  if (!to)
    return;
  std::size_t terms = 0;
  for (const poly::poly &p : first.from.outputs) {
    auto q = poly::pack(p);
    if (!q)
      return;
    terms += q->of.size();
    if (q->of.size() > (first.from.outputs.size() == 1 ? longest_alone : longest_output))
      return;
    first.contents.push_back(q->content);
    first.system.outputs.push_back(renamed(q->of, *to));
  }
  if (terms > most_terms)
    return;
  first.steps.resize(first.system.outputs.size());
  out.push_back(first);
  std::vector<packed> relations;
  for (const poly::poly &r : first.from.relations) {
    auto q = poly::pack(r);
    if (!q)
      return;
    relations.push_back(renamed(q->of, *to));
  }
  for (unsigned seed = 0; seed < seeds && !relations.empty(); ++seed) {
    start s = first;
    for (std::size_t i = 0; i < s.system.outputs.size(); ++i) {
      poly::reduced r = poly::shortened(s.system.outputs[i], relations, seed);
      s.system.outputs[i] = std::move(r.of);
      s.steps[i] = std::move(r.steps);
    }
    const bool known = std::any_of(out.begin(), out.end(),
                                   [&](const start &other) { return other.system.outputs == s.system.outputs; });
    if (!known)
      out.push_back(std::move(s));
  }
}

// Nodes for packed sums, by the schemes of the table.
class emitter {
public:
  emitter(ir::arena &nodes, const std::vector<node_id> &leaves, const poly::packed_system &s, poly::scheme_table &table)
      : nodes_(nodes), leaves_(leaves), system_(s), table_(table) {}

  node_id emit(const packed &p) {
    if (p.empty())
      return nodes_.constant(0);
    const std::int64_t g = poly::content(p);
    return nodes_.multiply(number(g), primitive(poly::divided(p, g)));
  }

private:
  ir::arena &nodes_;
  const std::vector<node_id> &leaves_;
  const poly::packed_system &system_;
  poly::scheme_table &table_;
  std::map<int, node_id> values_;

  node_id number(std::int64_t c) { return nodes_.constant(rational(static_cast<long>(c))); }

  node_id variable(int v) {
    if (v < static_cast<int>(leaves_.size()))
      return leaves_[static_cast<std::size_t>(v)];
    if (const auto it = values_.find(v); it != values_.end())
      return it->second;
    const node_id id = emit(*system_.definition(v));
    return values_[v] = id;
  }

  // Joins values of one object first.
  node_id joined(const std::vector<node_id> &all, node_id start, node_id (ir::arena::*operation)(node_id, node_id)) {
    std::map<ir::residency, node_id> parts;
    for (const node_id x : all)
      if (const auto [part, fresh] = parts.try_emplace(nodes_.where(x), x); !fresh)
        part->second = (nodes_.*operation)(part->second, x);
    for (const auto &[where, part] : parts)
      start = (nodes_.*operation)(start, part);
    return start;
  }

  node_id primitive(const packed &p) {
    using type = poly::scheme_table::step::type;
    const poly::scheme_table::step step = p.size() == 1 ? poly::scheme_table::step{} : table_.step_of(p);
    if (step.kind == type::take_out) {
      const poly::product_of v = poly::factor(step.variable);
      const node_id inside = emit(poly::quotient(p, v)), outside = emit(poly::remainder(p, v));
      return nodes_.add(nodes_.multiply(variable(step.variable), inside), outside);
    }
    if (step.kind == type::apart) {
      const auto [odd, even] = poly::odd_and_even(p);
      const node_id first = emit(odd);
      return nodes_.add(first, emit(even));
    }
    std::vector<node_id> terms;
    for (const poly::packed_term &t : p) {
      std::vector<node_id> factors;
      for (poly::product_of f = t.of; f != 0; f = poly::rest_of(f))
        factors.push_back(variable(poly::first_factor(f)));
      std::reverse(factors.begin(), factors.end());
      terms.push_back(
          nodes_.multiply(number(t.coefficient), joined(factors, nodes_.constant(1), &ir::arena::multiply)));
    }
    return joined(terms, nodes_.constant(0), &ir::arena::add);
  }
};

// The differences that the start's representatives left out, in the leaves.
std::vector<certified_difference> differences_of(const start &s, const poly::ring &leaves) {
  std::vector<certified_difference> out;
  const std::vector<poly::poly> relations = in_leaves(s.from, s.from.relations, leaves);
  // The variables of the table as polynomials in the leaves.
  std::map<int, poly::poly> known;
  for (int v = 0; v < leaves.size(); ++v)
    known.emplace(v, poly::poly::variable(leaves, v));
  const auto expand = [&](const packed &p) {
    poly::poly sum(leaves);
    for (const poly::packed_term &t : p) {
      poly::poly product(leaves, rational(static_cast<long>(t.coefficient)));
      for (poly::product_of f = t.of; f != 0; f = poly::rest_of(f))
        product = product * known.at(poly::first_factor(f));
      sum = sum + product;
    }
    return sum;
  };
  for (const auto &[v, definition] : s.system.values)
    known.emplace(v, expand(definition));
  for (std::size_t i = 0; i < s.steps.size(); ++i) {
    std::map<std::size_t, poly::poly> by_relation;
    for (const poly::reduction &r : s.steps[i]) {
      // The packed relation is primitive.
      const rational scale = s.from.relations[r.relation].primitive().first;
      poly::poly m = expand({{r.multiplier, r.factor}}).scaled(s.contents[i] / scale);
      const auto [it, fresh] = by_relation.try_emplace(r.relation, m);
      if (!fresh)
        it->second = it->second + m;
    }
    for (const auto &[relation, multiplier] : by_relation)
      if (!multiplier.is_zero() && !relations[relation].is_zero()) // a value's definition is zero
        out.push_back({i, relation, multiplier});
  }
  return out;
}

} // namespace

std::optional<found_program> search_program(ir::arena &nodes, const poly::ring &ring,
                                            const std::vector<node_id> &leaves, const value_system &from,
                                            const std::vector<int> &group, poly::price by) {
  std::vector<int> ranks;
  for (const node_id l : leaves)
    ranks.push_back(l < 0 ? 0 : static_cast<int>(nodes.where(l)));
  poly::scheme_table table(ranks, by);
  std::size_t terms = 0;
  for (const poly::poly &p : from.outputs)
    terms += p.length();
  if (terms > most_changed)
    return std::nullopt;
  std::vector<start> starts;
  add_starts(from, table, starts);
  if (const auto pairs = with_pairs(from, group))
    add_starts(*pairs, table, starts);
  if (starts.empty())
    return std::nullopt;
  const auto cheaper = [](const start &x, const start &y) { return x.cost < y.cost; };
  std::vector<poly::packed_system> systems;
  for (start &s : starts) {
    const long plain = poly::estimated_cost(s.system, table);
    systems.push_back(poly::extract_kernels(s.system, table, narrow));
    s.cost = poly::estimated_cost(systems.back(), table);
    s.improved = s.cost < plain;
  }
  std::vector<std::size_t> order(starts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return starts[x].cost < starts[y].cost; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    start &s = starts[order[i]];
    if (i < refined && s.improved)
      systems[order[i]] = poly::extract_kernels(s.system, table, wide);
    s.cost = poly::cost(systems[order[i]], table);
  }
  const auto best = std::min_element(starts.begin(), starts.end(), cheaper);
  found_program out;
  emitter emit(nodes, leaves, systems[static_cast<std::size_t>(best - starts.begin())], table);
  const poly::packed_system &system = systems[static_cast<std::size_t>(best - starts.begin())];
  for (std::size_t i = 0; i < system.outputs.size(); ++i)
    out.outputs.push_back(nodes.multiply(nodes.constant(best->contents[i]), emit.emit(system.outputs[i])));
  out.differences = differences_of(*best, ring);
  return out;
}

} // namespace meetc::search
