#include "gen/lower/programs/horner.hpp"

#include <algorithm>
#include <functional>
#include <limits>

namespace meetc::lower {
namespace {
using ir::node_id;
using poly::rational;
using monomials = std::vector<poly::monomial>;

// p = v * quotient + rest, where no term of rest contains v. factors_of(t) is the monomial of a term.
template <class Term, class Factors>
std::pair<std::vector<Term>, std::vector<Term>> split(const std::vector<Term> &p, int v, const Factors &factors_of) {
  std::pair<std::vector<Term>, std::vector<Term>> out;
  for (Term t : p) {
    poly::monomial &factors = factors_of(t);
    const auto it = std::find_if(factors.begin(), factors.end(), [&](const poly::power &f) { return f.variable == v; });
    if (it == factors.end()) {
      out.second.push_back(std::move(t));
      continue;
    }
    if (--it->exponent == 0)
      factors.erase(it);
    out.first.push_back(std::move(t));
  }
  return out;
}
poly::monomial &itself(poly::monomial &t) {
  return t;
}
poly::monomial &factors_of(poly::term &t) {
  return t.factors;
}

// Chooses the variables of a scheme.
class scheme {
public:
  // rank: the residency of each variable, as a number.
  scheme(std::vector<int> rank, price by) : rank_(std::move(rank)), by_(by) {}

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
    int best = by_ == price::whole ? useful.front() : -1;
    int best_cost = by_ == price::whole ? std::numeric_limits<int>::max() : sum_cost(p);
    for (const int v : useful) {
      const int c = taken_out(p, v);
      if (c < best_cost) {
        best = v;
        best_cost = c;
      }
    }
    return best;
  }

private:
  static constexpr std::size_t most_searched = 10; // longer sums take the most frequent variable
  static constexpr int both = 3;                   // the rank of a value of the pair
  std::vector<int> rank_;
  price by_;
  std::map<monomials, int> costs_;

  int rank(int v) const { return rank_[static_cast<std::size_t>(v)]; }
  int rank(const poly::monomial &t) const {
    int out = 0;
    for (const poly::power &f : t)
      out |= rank(f.variable);
    return out;
  }
  int rank(const monomials &p) const {
    int out = 0;
    for (const poly::monomial &t : p)
      out |= rank(t);
    return out;
  }
  // The operations that join values of these ranks, one after the other: the objects' own first.
  int joined(const std::vector<int> &ranks) const {
    if (by_ == price::whole)
      return std::max(0, static_cast<int>(ranks.size()) - 1);
    bool of_a = false, of_b = false;
    int of_pair = 0;
    for (const int r : ranks) {
      of_a = of_a || r == 1;
      of_b = of_b || r == 2;
      of_pair += r == both;
    }
    const int values = of_pair + of_a + of_b;
    return values > 1 ? values - 1 : 0;
  }
  int product_cost(const poly::monomial &t) const {
    std::vector<int> ranks;
    for (const poly::power &f : t)
      ranks.insert(ranks.end(), static_cast<std::size_t>(f.exponent), rank(f.variable));
    return joined(ranks);
  }
  int sum_cost(const monomials &p) const {
    int out = 0;
    std::vector<int> ranks;
    for (const poly::monomial &t : p) {
      out += product_cost(t);
      ranks.push_back(rank(t));
    }
    return out + joined(ranks);
  }
  int taken_out(const monomials &p, int v) {
    const auto [quotient, rest] = split(p, v, itself);
    int out = cost(quotient) + cost(rest);
    if (by_ == price::whole)
      return out + 1 + (rest.empty() ? 0 : 1);
    const int product = rank(v) | rank(quotient);
    if (rank(quotient) != 0)
      out += joined({rank(v), rank(quotient)});
    return out + (rest.empty() ? 0 : joined({product, rank(rest)}));
  }

  int cost(const monomials &p) {
    if (p.empty() || (p.size() == 1 && p[0].empty()))
      return 0;
    if (const auto it = costs_.find(p); it != costs_.end())
      return it->second;
    const int v = variable(p);
    const int out = v >= 0 ? taken_out(p, v) : sum_cost(p);
    return costs_[p] = out;
  }
};

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

class scheme_builder {
public:
  scheme_builder(ir::arena &nodes, const std::vector<node_id> &leaves, price by)
      : nodes_(nodes), leaves_(leaves), by_(by), choose_(ranks(), by) {}

  node_id build(std::vector<poly::term> q) {
    if (q.empty())
      return nodes_.constant(0);
    const rational content = take_content(q);
    monomials shape;
    for (const poly::term &t : q)
      shape.push_back(t.factors);
    node_id sum = -1;
    if (const int v = choose_.variable(shape); v >= 0) {
      auto [quotient, rest] = split(q, v, factors_of);
      sum = nodes_.add(nodes_.multiply(leaves_[static_cast<std::size_t>(v)], build(std::move(quotient))),
                       build(std::move(rest)));
    } else {
      sum = joined(
          q.size(), [&](std::size_t i) { return product(q[i]); }, nodes_.constant(0), &ir::arena::add);
    }
    return nodes_.multiply(nodes_.constant(content), sum);
  }

private:
  ir::arena &nodes_;
  const std::vector<node_id> &leaves_;
  price by_;
  scheme choose_;

  std::vector<int> ranks() const {
    std::vector<int> out;
    for (const node_id l : leaves_)
      out.push_back(l < 0 ? 0 : static_cast<int>(nodes_.where(l)));
    return out;
  }

  // Joins values to `start` from the left; with price::pair, those of one object first.
  template <class Value>
  node_id joined(std::size_t count, const Value &value, node_id start,
                 node_id (ir::arena::*operation)(node_id, node_id)) {
    if (by_ == price::whole) {
      for (std::size_t i = 0; i < count; ++i)
        start = (nodes_.*operation)(start, value(i));
      return start;
    }
    std::map<ir::residency, node_id> parts; // ascending: scene, object A, object B, pair
    for (std::size_t i = 0; i < count; ++i) {
      const node_id x = value(i);
      const auto [part, fresh] = parts.try_emplace(nodes_.where(x), x);
      if (!fresh)
        part->second = (nodes_.*operation)(part->second, x);
    }
    for (const auto &[where, part] : parts)
      start = (nodes_.*operation)(start, part);
    return start;
  }

  node_id product(const poly::term &t) {
    const auto factor = [&](std::size_t i) {
      return nodes_.power(leaves_[static_cast<std::size_t>(t.factors[i].variable)], t.factors[i].exponent);
    };
    return joined(t.factors.size(), factor, nodes_.constant(t.coefficient), &ir::arena::multiply);
  }
};

} // namespace

node_id horner(ir::arena &nodes, const poly::poly &p, const std::vector<node_id> &leaves, price by) {
  return scheme_builder(nodes, leaves, by).build(p.terms());
}

} // namespace meetc::lower
