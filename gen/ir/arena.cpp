#include "gen/ir/arena.hpp"

#include <algorithm>

namespace meetc::ir {
namespace {
residency join(residency a, residency b) {
  return static_cast<residency>(static_cast<int>(a) | static_cast<int>(b));
}
} // namespace

node_id arena::intern(node n, residency where) {
  const auto [it, fresh] = ids_.try_emplace(n, static_cast<node_id>(nodes_.size()));
  if (fresh) {
    nodes_.push_back(n);
    residency_.push_back(where);
  }
  return it->second;
}

node_id arena::input(int i) {
  return intern({op::input, i}, input_residency_[static_cast<std::size_t>(i)]);
}

node_id arena::constant(const rational &q) {
  const auto [it, fresh] = constant_ids_.try_emplace(q, -1);
  if (fresh) {
    constants_.push_back(q);
    it->second = intern({op::constant, static_cast<node_id>(constants_.size()) - 1}, residency::scene);
  }
  return it->second;
}

node_id arena::negate(node_id a) {
  if (at(a).kind == op::negate)
    return at(a).a;
  if (at(a).kind == op::constant)
    return constant(-value(a));
  return intern({op::negate, a}, where(a));
}

node_id arena::add(node_id a, node_id b) {
  if (is_constant(a, 0))
    return b;
  if (is_constant(b, 0))
    return a;
  if (at(a).kind == op::constant && at(b).kind == op::constant)
    return constant(value(a) + value(b));
  if (at(b).kind == op::negate)
    return subtract(a, at(b).a);
  if (at(a).kind == op::negate)
    return subtract(b, at(a).a);
  if (a > b)
    std::swap(a, b);
  return intern({op::add, a, b}, join(where(a), where(b)));
}

node_id arena::subtract(node_id a, node_id b) {
  if (a == b)
    return constant(0);
  if (is_constant(b, 0))
    return a;
  if (is_constant(a, 0))
    return negate(b);
  if (at(a).kind == op::constant && at(b).kind == op::constant)
    return constant(value(a) - value(b));
  if (at(b).kind == op::negate)
    return add(a, at(b).a);
  if (at(a).kind == op::negate)
    return negate(add(at(a).a, b));
  if (ids_.count({op::subtract, b, a}))
    return negate(intern({op::subtract, b, a}, join(where(a), where(b))));
  return intern({op::subtract, a, b}, join(where(a), where(b)));
}

node_id arena::multiply(node_id a, node_id b) {
  for (const auto &[x, y] : {std::pair(a, b), std::pair(b, a)}) {
    if (is_constant(x, 0))
      return x;
    if (is_constant(x, 1))
      return y;
    if (is_constant(x, -1))
      return negate(y);
    if (at(x).kind == op::negate)
      return negate(multiply(at(x).a, y));
    if (at(x).kind == op::constant && value(x) < 0)
      return negate(multiply(constant(-value(x)), y));
  }
  if (at(a).kind == op::constant && at(b).kind == op::constant)
    return constant(value(a) * value(b));
  // c1 (c2 x) = (c1 c2) x, so constants are collected in one factor.
  for (const auto &[x, y] : {std::pair(a, b), std::pair(b, a)})
    if (at(x).kind == op::constant && at(y).kind == op::multiply)
      for (const auto &[c, rest] : {std::pair(at(y).a, at(y).b), std::pair(at(y).b, at(y).a)})
        if (at(c).kind == op::constant)
          return multiply(constant(value(x) * value(c)), rest);
  if (a > b)
    std::swap(a, b);
  return intern({op::multiply, a, b}, join(where(a), where(b)));
}

node_id arena::fused(node_id a, node_id b, node_id c) {
  if (at(a).kind == op::negate && at(b).kind == op::negate)
    return fused(at(a).a, at(b).a, c);
  if (at(b).kind == op::negate)
    std::swap(a, b);
  if (at(a).kind != op::negate && a > b)
    std::swap(a, b);
  return intern({op::fused, a, b, c}, join(join(where(a), where(b)), where(c)));
}

node_id arena::power(node_id a, int exponent) {
  if (exponent == 0)
    return constant(1);
  if (exponent == 1)
    return a;
  const node_id half = power(a, exponent / 2);
  const node_id square = multiply(half, half);
  return exponent % 2 ? multiply(square, a) : square;
}

std::vector<node_id> needed(const arena &nodes, const std::vector<node_id> &results,
                            const std::vector<node_id> &given) {
  std::vector<char> wanted(nodes.size()), is_given(nodes.size());
  for (const node_id g : given)
    is_given[static_cast<std::size_t>(g)] = 1;
  for (const node_id r : results)
    wanted[static_cast<std::size_t>(r)] = 1;
  std::vector<node_id> out;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!wanted[i])
      continue;
    out.push_back(static_cast<node_id>(i));
    if (is_given[i])
      continue;
    for (const node_id operand : operands(nodes.at(static_cast<node_id>(i))))
      wanted[static_cast<std::size_t>(operand)] = 1;
  }
  std::reverse(out.begin(), out.end());
  return out;
}

std::vector<node_id> stored_of(const program &p, residency object) {
  std::vector<node_id> out;
  for (const node_id id : p.stored)
    if (p.nodes.where(id) == object)
      out.push_back(id);
  return out;
}

std::vector<node_id> operands_first(const arena &nodes, node_id root, const std::function<bool(node_id)> &stops) {
  std::vector<node_id> out;
  std::vector<std::pair<node_id, bool>> stack{{root, false}};
  std::vector<char> seen(nodes.size());
  while (!stack.empty()) {
    const auto [id, ready] = stack.back();
    stack.pop_back();
    if (ready) {
      out.push_back(id);
    } else if (!seen[static_cast<std::size_t>(id)]) {
      seen[static_cast<std::size_t>(id)] = 1;
      stack.emplace_back(id, true);
      if (stops(id))
        continue;
      const operand_list below = operands(nodes.at(id));
      for (std::size_t i = below.count; i-- > 0;) // pushed in reverse, so that the first is popped first
        stack.emplace_back(below.ids[i], false);
    }
  }
  return out;
}

} // namespace meetc::ir
