#include "gen/lower/build.hpp"

#include "gen/ir/count.hpp"
#include "gen/ir/evaluate.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace meetc::lower {
namespace {

std::vector<residency> residencies(const poly::local_origin &f) {
  std::vector<residency> out;
  for (int v = 0; v < f.base().size(); ++v)
    out.push_back(f.info(v).where);
  return out;
}

using monomials = std::vector<poly::monomial>;

// Chooses the variables of a multivariate Horner scheme. Coefficients are ignored, and so is sharing between the parts.
class scheme {
public:
  explicit scheme(std::vector<int> rank) : rank_(std::move(rank)) {}

  // The variable to take out, or -1 to add up the terms.
  int variable(const monomials &p) {
    std::map<int, int> occurrences;
    for (const poly::monomial &t : p)
      for (const poly::power &f : t)
        ++occurrences[f.variable];
    std::vector<int> useful;
    for (const auto &[v, n] : occurrences)
      if (n >= 2)
        useful.push_back(v);
    if (useful.empty())
      return -1;
    const auto better = [&](int a, int b) {
      return std::tuple(-occurrences[a], -rank(a), a) < std::tuple(-occurrences[b], -rank(b), b);
    };
    std::sort(useful.begin(), useful.end(), better);
    if (p.size() > most_searched)
      return useful.front();
    int best = useful.front(), best_cost = std::numeric_limits<int>::max();
    for (const int v : useful) {
      const auto [quotient, rest] = split(p, v);
      const int c = cost(quotient) + cost(rest) + 1 + (rest.empty() ? 0 : 1);
      if (c < best_cost) {
        best = v;
        best_cost = c;
      }
    }
    return best;
  }

private:
  static constexpr std::size_t most_searched = 10; // longer sums take the most frequent variable
  std::vector<int> rank_;
  std::map<monomials, int> costs_;

  int rank(int v) const { return rank_[static_cast<std::size_t>(v)]; }

  static std::pair<monomials, monomials> split(const monomials &p, int v) {
    std::pair<monomials, monomials> out;
    for (poly::monomial t : p) {
      const auto it = std::find_if(t.begin(), t.end(), [&](const poly::power &f) { return f.variable == v; });
      if (it == t.end()) {
        out.second.push_back(std::move(t));
        continue;
      }
      if (--it->exponent == 0)
        t.erase(it);
      out.first.push_back(std::move(t));
    }
    return out;
  }

  int cost(const monomials &p) {
    if (p.empty() || (p.size() == 1 && p[0].empty()))
      return 0;
    if (const auto it = costs_.find(p); it != costs_.end())
      return it->second;
    int out = 0;
    if (const int v = variable(p); v >= 0) {
      const auto [quotient, rest] = split(p, v);
      out = cost(quotient) + cost(rest) + 1 + (rest.empty() ? 0 : 1);
    } else {
      for (const poly::monomial &t : p) {
        int degree = 0;
        for (const poly::power &f : t)
          degree += f.exponent;
        out += std::max(0, degree - 1) + 1;
      }
      out -= 1;
    }
    return costs_[p] = out;
  }
};

// p = v * quotient + rest, where no term of rest contains v.
std::pair<std::vector<poly::term>, std::vector<poly::term>> split(const std::vector<poly::term> &p, int v) {
  std::pair<std::vector<poly::term>, std::vector<poly::term>> out;
  for (poly::term t : p) {
    const auto it =
        std::find_if(t.factors.begin(), t.factors.end(), [&](const poly::power &f) { return f.variable == v; });
    if (it == t.factors.end()) {
      out.second.push_back(std::move(t));
      continue;
    }
    if (--it->exponent == 0)
      t.factors.erase(it);
    out.first.push_back(std::move(t));
  }
  return out;
}

// Takes the common rational factor out of the terms and makes the first term positive.
rational take_content(std::vector<poly::term> &p) {
  mpz_class g = 0, l = 1;
  for (const poly::term &t : p) {
    g = gcd(g, t.coefficient.get_num());
    l = lcm(l, t.coefficient.get_den());
  }
  rational content(g, l);
  content.canonicalize();
  if (p.front().coefficient < 0)
    content = -content;
  for (poly::term &t : p)
    t.coefficient /= content;
  return content;
}

} // namespace

builder::builder(const poly::local_origin &f, prefer by) : origin_(f), prefer_(by), nodes_(residencies(f)) {}

node_id builder::leaf(int v) {
  const poly::local_variable &info = origin_.info(v);
  const node_id from = nodes_.input(info.minuend);
  return info.subtrahend < 0 ? from : nodes_.subtract(from, nodes_.input(info.subtrahend));
}

node_id builder::build(const poly::poly &absolute, bool is_irreducible) {
  const node_id n = local(origin_.lower(absolute), is_irreducible);
  asked_.emplace(n, absolute);
  return n;
}

node_id builder::local(const poly::poly &p, bool is_irreducible) {
  if (p.is_constant())
    return nodes_.constant(p.is_zero() ? rational(0) : p.constant());
  auto [content, primitive] = p.primitive();
  const std::string key = primitive.key();
  node_id n = -1;
  if (const auto it = known_.find(key); it != known_.end()) {
    n = it->second;
  } else if (is_irreducible) {
    known_[key] = n = irreducible(primitive);
  } else {
    const auto f = primitive.factors();
    if (f.parts.size() == 1 && f.parts[0].second == 1) {
      n = irreducible(primitive);
    } else {
      n = nodes_.constant(f.content);
      for (const auto &[part, exponent] : f.parts)
        n = nodes_.multiply(n, nodes_.power(local(part, true), exponent));
    }
    known_[key] = n;
  }
  return nodes_.multiply(nodes_.constant(content), n);
}

node_id builder::irreducible(const poly::poly &p) {
  // Every candidate is built. Nodes used only by rejected ones are never emitted.
  struct candidate {
    std::size_t terms;
    int operations;
    node_id root;
  };
  std::vector<candidate> all;
  const auto cost = [&](node_id root) { return count(nodes_, {root}).total(); };
  for (const poly::vector_form &v : poly::vector_forms(origin_, p)) {
    std::vector<node_id> symbols;
    for (const poly::invariant &q : v.invariants)
      symbols.push_back(symbol(q));
    const node_id root = horner(v.form, symbols);
    all.push_back({v.form.length(), cost(root), root});
    // Bare numbers are kept apart where they factor: (r + s)^2 - d^2, not r^2 + 2 r s + s^2 - d^2.
    std::vector<poly::term> bare, rest;
    for (const poly::term &t : v.form.terms()) {
      const bool numbers = std::all_of(t.factors.begin(), t.factors.end(), [&](const poly::power &f) {
        return v.invariants[static_cast<std::size_t>(f.variable)].kind == poly::invariant::type::number;
      });
      (numbers ? bare : rest).push_back(t);
    }
    if (bare.size() > 1 && !rest.empty()) {
      const node_id apart = nodes_.add(build_over(poly::poly::from_terms(*v.symbols, bare), symbols),
                                       horner(poly::poly::from_terms(*v.symbols, rest), symbols));
      all.push_back({1 + rest.size(), cost(apart), apart});
    }
  }
  if (all.empty() || prefer_ == prefer::operations) {
    std::vector<node_id> leaves(static_cast<std::size_t>(origin_.local().size()), -1);
    for (const int v : p.variables())
      leaves[static_cast<std::size_t>(v)] = leaf(v);
    const node_id root = horner(p, leaves);
    all.push_back({p.length(), cost(root), root});
  }
  const auto better = [&](const candidate &x, const candidate &y) {
    return prefer_ == prefer::operations ? std::pair(x.operations, x.terms) < std::pair(y.operations, y.terms)
                                         : std::pair(x.terms, x.operations) < std::pair(y.terms, y.operations);
  };
  return std::min_element(all.begin(), all.end(), better)->root;
}

node_id builder::symbol(const poly::invariant &q) {
  switch (q.kind) {
  case poly::invariant::type::number:
    return leaf(q.i);
  case poly::invariant::type::dot:
    return dot(q.i, q.j);
  case poly::invariant::type::cross_squared: {
    const auto c = cross(q.i, q.j);
    node_id sum = nodes_.constant(0);
    for (const node_id x : c)
      sum = nodes_.add(sum, nodes_.multiply(x, x));
    return sum;
  }
  default: {
    // [i j k]: takes the cross product of two vectors of one object if there are two, and otherwise of the first two.
    const auto where = [&](int v) { return origin_.info(origin_.vector(v)[0]).where; };
    int a = q.i, b = q.j, c = q.k; // (a x b) . c; cyclic permutations do not change it
    if (where(a) != where(b) && where(b) == where(c)) {
      a = q.j, b = q.k, c = q.i;
    } else if (where(a) != where(b) && where(a) == where(c)) {
      a = q.k, b = q.i, c = q.j;
    } else if (where(a) != where(b)) {
      // With three residencies the pair's vector comes last, so that the cross product combines the objects' own
      // vectors.
      if (where(q.i) == residency::pair)
        a = q.j, b = q.k, c = q.i;
      else if (where(q.j) == residency::pair)
        a = q.k, b = q.i, c = q.j;
    }
    const bool flip = a > b;
    const auto n = cross(std::min(a, b), std::max(a, b));
    node_id sum = nodes_.constant(0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum = nodes_.add(sum, nodes_.multiply(n[axis], leaf(origin_.vector(c)[axis])));
    return flip ? nodes_.negate(sum) : sum;
  }
  }
}

node_id builder::dot(int i, int j) {
  node_id sum = nodes_.constant(0);
  for (std::size_t axis = 0; axis < origin_.vector(i).size(); ++axis)
    sum = nodes_.add(sum, nodes_.multiply(leaf(origin_.vector(i)[axis]), leaf(origin_.vector(j)[axis])));
  return sum;
}

const std::array<node_id, 3> &builder::cross(int i, int j) {
  const auto [it, fresh] = crosses_.try_emplace({i, j});
  if (fresh)
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      const auto at = [&](int v, std::size_t axis) { return leaf(origin_.vector(v)[axis]); };
      it->second[a] = nodes_.subtract(nodes_.multiply(at(i, b), at(j, c)), nodes_.multiply(at(i, c), at(j, b)));
    }
  return it->second;
}

node_id builder::build_over(const poly::poly &p, const std::vector<node_id> &leaves) {
  if (p.is_constant())
    return nodes_.constant(p.is_zero() ? rational(0) : p.constant());
  const auto f = p.factors();
  node_id n = nodes_.constant(f.content);
  for (const auto &[part, exponent] : f.parts)
    n = nodes_.multiply(n, nodes_.power(horner(part, leaves), exponent));
  return n;
}

node_id builder::horner(const poly::poly &p, const std::vector<node_id> &leaves) {
  std::vector<int> rank;
  for (const node_id l : leaves)
    rank.push_back(l < 0 ? 0 : static_cast<int>(nodes_.where(l)));
  scheme choose(rank);
  const std::function<node_id(std::vector<poly::term>)> build = [&](std::vector<poly::term> q) -> node_id {
    if (q.empty())
      return nodes_.constant(0);
    const rational content = take_content(q);
    monomials shape;
    for (const poly::term &t : q)
      shape.push_back(t.factors);
    node_id sum = nodes_.constant(0);
    if (const int v = choose.variable(shape); v >= 0) {
      auto [quotient, rest] = split(q, v);
      sum = nodes_.add(nodes_.multiply(leaves[static_cast<std::size_t>(v)], build(std::move(quotient))),
                       build(std::move(rest)));
    } else {
      for (const poly::term &t : q) {
        node_id product = nodes_.constant(t.coefficient);
        for (const poly::power &f : t.factors)
          product = nodes_.multiply(product, nodes_.power(leaves[static_cast<std::size_t>(f.variable)], f.exponent));
        sum = nodes_.add(sum, product);
      }
    }
    return nodes_.multiply(nodes_.constant(content), sum);
  };
  return build(p.terms());
}

program builder::finish(const std::vector<node_id> &results) const {
  program out{nodes_, results};
  const auto have = ir::to_poly(out, origin_.base());
  for (std::size_t i = 0; i < results.size(); ++i)
    if (const auto it = asked_.find(results[i]); it != asked_.end() && !(it->second == have[i]))
      throw std::logic_error("lowering changed a value");
  return out;
}

} // namespace meetc::lower
