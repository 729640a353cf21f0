// fold(program, domain): gives a meaning to the operations of a program.
//
// Problem: a program is evaluated in rationals, expanded into polynomials, bounded, counted, rewritten and printed in
// several languages. Each of these is a walk over the same seven operations.
// Method: there is one walk, here, and only it tells the operations apart. A domain says what a value is and what each
// operation makes of values:
//
//   struct domain {
//     using value = ...;
//     value input(const node_ref &at, int number);
//     value constant(const node_ref &at, const rational &q);
//     value negate(const node_ref &at, const value &x);
//     value add(const node_ref &at, const value &x, const value &y);
//     value subtract(const node_ref &at, const value &x, const value &y);
//     value multiply(const node_ref &at, const value &x, const value &y);
//     value fused(const node_ref &at, const value &x, const value &y, const value &z);   // x * y + z
//     std::optional<value> given(const node_ref &at);  // optional: the value of a node that the domain already has
//   };
//
// Operands come before the nodes that use them. A new operation is a new node in arena.hpp, a new case here, and a new
// member of every domain, which the C++ compiler demands.
#pragma once
#include "gen/ir/arena.hpp"

#include <optional>
#include <stdexcept>

namespace meetc::ir {

// The position of the walk.
struct node_ref {
  const arena &nodes;
  node_id id;

  const node &operation() const { return nodes.at(id); }
  residency where() const { return nodes.where(id); }
};

// The values of the nodes that a fold has visited.
template <class Value> class folded {
public:
  explicit folded(std::size_t nodes) : values_(nodes) {}
  const Value &at(node_id id) const {
    const auto &v = values_.at(static_cast<std::size_t>(id));
    if (!v)
      throw std::logic_error("a fold reads a value that it has not computed");
    return *v;
  }
  bool has(node_id id) const { return values_.at(static_cast<std::size_t>(id)).has_value(); }
  void set(node_id id, Value v) { values_.at(static_cast<std::size_t>(id)) = std::move(v); }
  // The values in the order of `ids`.
  std::vector<Value> of(const std::vector<node_id> &ids) const {
    std::vector<Value> out;
    out.reserve(ids.size());
    for (const node_id id : ids)
      out.push_back(at(id));
    return out;
  }

private:
  std::vector<std::optional<Value>> values_;
};

// Folds the nodes of `order`, in which operands come before the nodes that use them.
template <class Domain>
folded<typename Domain::value> fold(const arena &nodes, Domain &d, const std::vector<node_id> &order) {
  folded<typename Domain::value> values(nodes.size());
  for (const node_id id : order) {
    const node_ref at{nodes, id};
    const node &n = at.operation();
    if constexpr (requires { d.given(at); })
      if (auto v = d.given(at)) {
        values.set(id, std::move(*v));
        continue;
      }
    switch (n.kind) {
    case op::input:
      values.set(id, d.input(at, n.a));
      break;
    case op::constant:
      values.set(id, d.constant(at, nodes.value(id)));
      break;
    case op::negate:
      values.set(id, d.negate(at, values.at(n.a)));
      break;
    case op::add:
      values.set(id, d.add(at, values.at(n.a), values.at(n.b)));
      break;
    case op::subtract:
      values.set(id, d.subtract(at, values.at(n.a), values.at(n.b)));
      break;
    case op::multiply:
      values.set(id, d.multiply(at, values.at(n.a), values.at(n.b)));
      break;
    case op::fused:
      values.set(id, d.fused(at, values.at(n.a), values.at(n.b), values.at(n.c)));
      break;
    }
  }
  return values;
}

// Folds all nodes that the results need.
template <class Domain> folded<typename Domain::value> fold(const program &p, Domain &d) {
  return fold(p.nodes, d, needed(p.nodes, p.results));
}

// The domain's values for the results.
template <class Domain> std::vector<typename Domain::value> fold_results(const program &p, Domain d) {
  return fold(p, d).of(p.results);
}

} // namespace meetc::ir
