#include "gen/ir/arena.hpp"

#include <algorithm>

namespace meetc::ir {
namespace {
residency join(residency a, residency b) {
  return static_cast<residency>(static_cast<int>(a) | static_cast<int>(b));
}

bool is_power_of_two(const rational &q) {
  if (q == 0)
    return false;
  const mpz_class n = abs(q.get_num()), &d = q.get_den();
  return mpz_popcount(n.get_mpz_t()) == 1 && mpz_popcount(d.get_mpz_t()) == 1;
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
  // c1 (c2 x) = (c1 c2) x: numbers gather in one factor.
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

std::vector<node_id> needed(const arena &nodes, const std::vector<node_id> &results) {
  std::vector<char> wanted(nodes.size());
  for (const node_id r : results)
    wanted[static_cast<std::size_t>(r)] = 1;
  std::vector<node_id> out;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!wanted[i])
      continue;
    out.push_back(static_cast<node_id>(i));
    const node &n = nodes.at(static_cast<node_id>(i));
    if (n.kind != op::input && n.kind != op::constant)
      for (const node_id operand : {n.a, n.b, n.c})
        if (operand >= 0)
          wanted[static_cast<std::size_t>(operand)] = 1;
  }
  std::reverse(out.begin(), out.end());
  return out;
}

namespace {
counts count_where(const arena &nodes, const std::vector<node_id> &ids, const std::function<bool(node_id)> &in) {
  counts out;
  for (const node_id id : ids) {
    const node &n = nodes.at(id);
    if (!in(id))
      continue;
    if (n.kind == op::add || n.kind == op::subtract)
      ++out.additions;
    else if (n.kind == op::fused || n.kind == op::multiply) {
      const auto free = [&](node_id f) { return nodes.at(f).kind == op::constant && is_power_of_two(nodes.value(f)); };
      const bool scaling = free(n.a) || free(n.b);
      if (n.kind == op::fused)
        ++(scaling ? out.additions : out.fused);
      else if (!scaling)
        ++out.multiplications;
    }
  }
  return out;
}
} // namespace

counts count(const arena &nodes, const std::vector<node_id> &results) {
  return count_where(nodes, needed(nodes, results), [](node_id) { return true; });
}

counts count(const program &p, residency where) {
  return count_where(p.nodes, needed(p.nodes, p.results), [&](node_id id) { return p.nodes.where(id) == where; });
}

std::vector<poly::poly> to_poly(const program &p, const poly::ring &inputs) {
  std::map<node_id, poly::poly> value;
  for (const node_id id : needed(p.nodes, p.results)) {
    const node &n = p.nodes.at(id);
    const auto of = [&](node_id i) -> const poly::poly & { return value.at(i); };
    poly::poly v(inputs);
    switch (n.kind) {
    case op::input:
      v = poly::poly::variable(inputs, n.a);
      break;
    case op::constant:
      v = poly::poly(inputs, p.nodes.value(id));
      break;
    case op::negate:
      v = of(n.a).scaled(-1);
      break;
    case op::add:
      v = of(n.a) + of(n.b);
      break;
    case op::subtract:
      v = of(n.a) - of(n.b);
      break;
    case op::multiply:
      v = of(n.a) * of(n.b);
      break;
    case op::fused:
      v = of(n.a) * of(n.b) + of(n.c);
      break;
    }
    value.emplace(id, std::move(v));
  }
  std::vector<poly::poly> out;
  for (const node_id r : p.results)
    out.push_back(value.at(r));
  return out;
}

std::vector<rational> evaluate(const program &p, const std::vector<rational> &inputs) {
  std::vector<rational> value(p.nodes.size());
  const auto of = [&](node_id i) -> const rational & { return value[static_cast<std::size_t>(i)]; };
  for (const node_id id : needed(p.nodes, p.results)) {
    const node &n = p.nodes.at(id);
    rational v;
    switch (n.kind) {
    case op::input:
      v = inputs[static_cast<std::size_t>(n.a)];
      break;
    case op::constant:
      v = p.nodes.value(id);
      break;
    case op::negate:
      v = -of(n.a);
      break;
    case op::add:
      v = of(n.a) + of(n.b);
      break;
    case op::subtract:
      v = of(n.a) - of(n.b);
      break;
    case op::multiply:
      v = of(n.a) * of(n.b);
      break;
    case op::fused:
      v = of(n.a) * of(n.b) + of(n.c);
      break;
    }
    value[static_cast<std::size_t>(id)] = v;
  }
  std::vector<rational> out;
  for (const node_id r : p.results)
    out.push_back(of(r));
  return out;
}

std::vector<magnitude> magnitudes(const program &p, bool differences) {
  std::vector<magnitude> out(p.nodes.size());
  const auto of = [&](node_id i) -> magnitude & { return out[static_cast<std::size_t>(i)]; };
  const auto sum = [&](const magnitude &a, const magnitude &b, magnitude &into) {
    if (a.degree != b.degree)
      return false;
    into = {a.degree, std::max(a.growth, b.growth) + 1};
    return true;
  };
  for (const node_id id : needed(p.nodes, p.results)) {
    const node &n = p.nodes.at(id);
    bool homogeneous = true;
    switch (n.kind) {
    case op::input:
      of(id) = {1, 0};
      break;
    case op::constant: {
      const rational &q = p.nodes.value(id);
      if (q.get_den() != 1)
        return {};
      // |q| < 2^size; a power of two needs one bit more than its logarithm.
      of(id) = {0, static_cast<int>(mpz_sizeinbase(q.get_num().get_mpz_t(), 2))};
      break;
    }
    case op::negate:
      of(id) = of(n.a);
      break;
    case op::add:
    case op::subtract:
      homogeneous = sum(of(n.a), of(n.b), of(id));
      if (differences && n.kind == op::subtract && p.nodes.at(n.a).kind == op::input &&
          p.nodes.at(n.b).kind == op::input)
        of(id) = {1, 0};
      break;
    case op::multiply:
      of(id) = {of(n.a).degree + of(n.b).degree, of(n.a).growth + of(n.b).growth};
      break;
    case op::fused:
      homogeneous = sum({of(n.a).degree + of(n.b).degree, of(n.a).growth + of(n.b).growth}, of(n.c), of(id));
      break;
    }
    if (!homogeneous)
      return {};
  }
  return out;
}

program fuse(const program &p) {
  const std::vector<node_id> ids = needed(p.nodes, p.results);
  std::vector<int> uses(p.nodes.size());
  for (const node_id r : p.results)
    ++uses[static_cast<std::size_t>(r)];
  for (const node_id id : ids) {
    const node &n = p.nodes.at(id);
    if (n.kind != op::input && n.kind != op::constant)
      for (const node_id operand : {n.a, n.b, n.c})
        if (operand >= 0)
          ++uses[static_cast<std::size_t>(operand)];
  }
  program out{arena(p.nodes.inputs()), {}};
  std::map<node_id, node_id> moved;
  // A product is fused where its one use is a sum. Products of different residency stay apart: a value of one
  // object that is computed once must not be pulled into the pair.
  const auto product_for = [&](node_id operand, node_id user) {
    return p.nodes.at(operand).kind == op::multiply && uses[static_cast<std::size_t>(operand)] == 1 &&
           p.nodes.where(operand) == p.nodes.where(user);
  };
  for (const node_id id : ids) {
    const node &n = p.nodes.at(id);
    const auto of = [&](node_id i) { return moved.at(i); };
    arena &to = out.nodes;
    node_id v = -1;
    const auto fuse_product = [&](node_id product, bool minus, node_id addend) {
      const node &m = p.nodes.at(product);
      return to.fused(minus ? to.negate(of(m.a)) : of(m.a), of(m.b), addend);
    };
    switch (n.kind) {
    case op::input:
      v = to.input(n.a);
      break;
    case op::constant:
      v = to.constant(p.nodes.value(id));
      break;
    case op::negate:
      v = to.negate(of(n.a));
      break;
    case op::add:
      v = product_for(n.b, id)   ? fuse_product(n.b, false, of(n.a))
          : product_for(n.a, id) ? fuse_product(n.a, false, of(n.b))
                                 : to.add(of(n.a), of(n.b));
      break;
    case op::subtract:
      v = product_for(n.b, id)   ? fuse_product(n.b, true, of(n.a))
          : product_for(n.a, id) ? fuse_product(n.a, false, to.negate(of(n.b)))
                                 : to.subtract(of(n.a), of(n.b));
      break;
    case op::multiply:
      v = to.multiply(of(n.a), of(n.b));
      break;
    case op::fused:
      v = to.fused(of(n.a), of(n.b), of(n.c));
      break;
    }
    moved[id] = v;
  }
  for (const node_id r : p.results)
    out.results.push_back(moved.at(r));
  return out;
}

} // namespace meetc::ir
