#include "gen/lower/programs/build.hpp"

#include "gen/ir/count.hpp"
#include "gen/ir/residue.hpp"
#include "gen/search/search.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace meetc::lower {
namespace {

constexpr std::size_t most_searched = 1; // forms of one polynomial

std::vector<residency> residencies(const poly::local_origin &f) {
  std::vector<residency> out;
  for (int v = 0; v < f.base().size(); ++v)
    out.push_back(f.info(v).where);
  return out;
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

builder::candidate builder::candidate_of(std::size_t terms, node_id root) const {
  return {terms, count(nodes_, {root}, residency::pair).total(), count(nodes_, {root}).total(), root};
}

std::array<int, 3> builder::key(const candidate &c) const {
  const int terms = static_cast<int>(c.terms);
  return prefer_ == prefer::operations ? std::array{c.operations, terms, 0}
         : prefer_ == prefer::pair     ? std::array{c.pair, c.operations, terms}
                                       : std::array{terms, c.operations, 0};
}

builder::candidate builder::best_of(const std::vector<candidate> &all) const {
  return *std::min_element(all.begin(), all.end(),
                           [&](const candidate &x, const candidate &y) { return key(x) < key(y); });
}

node_id builder::local(const poly::poly &p, bool is_irreducible) {
  if (p.is_constant())
    return nodes_.constant(p.is_zero() ? rational(0) : p.constant());
  auto [content, primitive] = p.primitive();
  const std::string key = primitive.key();
  node_id n = -1;
  if (const auto it = known_.find(key); it != known_.end()) {
    n = it->second;
  } else {
    const auto f = is_irreducible ? poly::poly::factor{{{primitive, 1}}, 1} : primitive.factors();
    std::vector<candidate> all;
    if (f.parts.size() > 1 || f.parts[0].second > 1)
      all.push_back(candidate_of(1, factored(f)));
    if (all.empty() || prefer_ != prefer::accuracy) {
      const std::vector<candidate> of_whole = forms(primitive);
      all.insert(all.end(), of_whole.begin(), of_whole.end());
    }
    n = best_of(all).root;
    known_[key] = n;
  }
  return nodes_.multiply(nodes_.constant(content), n);
}

// Each factor is measured from points of its own: those of the product may not be its own points.
node_id builder::factored(const poly::poly::factor &f) {
  node_id n = nodes_.constant(f.content);
  for (const auto &[part, exponent] : f.parts)
    n = nodes_.multiply(n, nodes_.power(local(origin_.lower(origin_.raise(part)), true), exponent));
  return n;
}

std::vector<node_id> builder::symbols(const std::vector<poly::invariant> &of) {
  std::vector<node_id> out;
  for (const poly::invariant &q : of)
    out.push_back(symbol(q));
  return out;
}

std::array<builder::candidate, 3> builder::with_squares(const poly::form &f, std::vector<node_id> &symbols) {
  symbols.resize(static_cast<std::size_t>(f.symbols->size()), -1);
  for (std::size_t i = 0; i < f.made.size(); ++i) {
    const poly::made_symbol &m = f.made[i];
    node_id n = build_over(m.first, symbols);
    if (m.kind == poly::made_symbol::type::length) {
      const node_id second = build_over(m.second, symbols);
      node_id sum = nodes_.constant(0);
      for (std::size_t axis = 0; axis < origin_.vector(m.u).size(); ++axis) {
        const node_id u = leaf(origin_.vector(m.u)[axis]), v = leaf(origin_.vector(m.v)[axis]);
        const node_id x = nodes_.add(nodes_.multiply(n, u), nodes_.multiply(second, v));
        sum = nodes_.add(sum, nodes_.multiply(x, x));
      }
      n = sum;
    }
    symbols[static_cast<std::size_t>(f.symbol(i))] = n;
  }
  // A difference of two squares is tried as it is, too.
  return {candidate_of(f.value.length(), build_over(f.value, symbols)),
          candidate_of(f.value.length(), horner(nodes_, f.value, symbols, by())),
          candidate_of(f.value.length(), horner(nodes_, f.value, symbols, other_price()))};
}

// Every form is built. Nodes used only by rejected ones are never emitted.
std::vector<builder::candidate> builder::forms(const poly::poly &p) {
  std::vector<candidate> all;
  const std::vector<poly::vector_form> plain = poly::vector_forms(origin_, p);
  for (const poly::vector_form &v : plain) {
    const std::vector<node_id> of = symbols(v.invariants);
    all.push_back(candidate_of(v.form.length(), horner(nodes_, v.form, of, by())));
    // Bare numbers are kept apart where they factor: (r + s)^2 - d^2, not r^2 + 2 r s + s^2 - d^2.
    std::vector<poly::term> bare, rest;
    for (const poly::term &t : v.form.terms()) {
      const bool numbers = std::all_of(t.factors.begin(), t.factors.end(), [&](const poly::power &f) {
        return v.invariants[static_cast<std::size_t>(f.variable)].kind == poly::invariant::type::number;
      });
      (numbers ? bare : rest).push_back(t);
    }
    if (bare.size() > 1 && !rest.empty()) {
      const node_id apart = nodes_.add(build_over(poly::poly::from_terms(*v.symbols, bare), of),
                                       horner(nodes_, poly::poly::from_terms(*v.symbols, rest), of, by()));
      all.push_back(candidate_of(1 + rest.size(), apart));
    }
  }
  if (all.empty() || prefer_ != prefer::accuracy) {
    std::vector<node_id> leaves(static_cast<std::size_t>(origin_.local().size()), -1);
    for (const int v : p.variables())
      leaves[static_cast<std::size_t>(v)] = leaf(v);
    all.push_back(candidate_of(p.length(), horner(nodes_, p, leaves, by())));
  }
  if (prefer_ == prefer::accuracy)
    return all;
  // The forms with squares that cost least, for a search.
  struct squared {
    candidate best;
    poly::form form;
    std::vector<node_id> symbols;
  };
  std::vector<squared> least;
  for (const poly::vector_form &v : plain) {
    const std::vector<node_id> of = symbols(v.invariants);
    all.push_back(candidate_of(v.form.length(), horner(nodes_, v.form, of, other_price())));
    for (const poly::form &f : poly::squares(v)) {
      std::vector<node_id> made = of;
      const auto built = with_squares(f, made);
      all.insert(all.end(), built.begin(), built.end());
      least.push_back({best_of({built.begin(), built.end()}), f, std::move(made)});
    }
  }
  std::stable_sort(least.begin(), least.end(),
                   [&](const squared &x, const squared &y) { return key(x.best) < key(y.best); });
  for (std::size_t i = 0; i < std::min(most_searched, least.size()); ++i) {
    const poly::ring &ring = *least[i].form.symbols;
    const auto found =
        search::search_program(nodes_, ring, least[i].symbols, search::system_of(ring, {least[i].form.value}),
                               std::vector<int>(static_cast<std::size_t>(ring.size()), -1), by());
    if (found)
      all.push_back(candidate_of(least[i].form.value.length(), found->outputs[0]));
  }
  return all;
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
    n = nodes_.multiply(n, nodes_.power(horner(nodes_, part, leaves, by()), exponent));
  return n;
}

program builder::finish(const std::vector<node_id> &results) const {
  program out{nodes_, results};
  std::vector<node_id> asked;
  std::vector<poly::poly> wanted;
  for (const node_id r : results)
    if (const auto it = asked_.find(r); it != asked_.end())
      asked.push_back(r), wanted.push_back(it->second);
  if (!ir::same_values({nodes_, asked}, wanted, origin_.base()))
    throw std::logic_error("lowering changed a value");
  return out;
}

} // namespace meetc::lower
