#include "gen/search/assumed.hpp"

#include "gen/ir/count.hpp"

#include <algorithm>
#include <set>

namespace meetc::search {
namespace {

using ir::node_id;
using poly::poly;
using poly_ring = meetc::poly::ring;

// relation = scale * (variable - number)
struct fixed_variable {
  std::size_t relation;
  int variable;
  rational scale, number;
};

std::vector<fixed_variable> fixed_by(const std::vector<poly> &relations) {
  std::vector<fixed_variable> out;
  std::set<int> done;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    const std::vector<int> used = relations[i].variables();
    if (used.size() != 1 || relations[i].total_degree() != 1 || !done.insert(used[0]).second)
      continue;
    const poly k = relations[i].derivative(used[0]);
    const poly rest = relations[i] - k * poly::variable(relations[i].in(), used[0]);
    out.push_back({i, used[0], k.constant(), rest.is_zero() ? rational(0) : rational(-rest.constant() / k.constant())});
  }
  return out;
}

// Polynomials with one variable replaced by its number, and what was left out as a multiple of the relation.
class fixing {
public:
  fixing(const poly_ring &r, const fixed_variable &by) : by_(by) {
    for (int v = 0; v < r.size(); ++v)
      images_.push_back(v == by.variable ? poly(r, by.number) : poly::variable(r, v));
    divisor_ = std::make_unique<poly>((poly::variable(r, by.variable) - poly(r, by.number)).scaled(by.scale));
  }
  poly operator()(const poly &p) const { return p.substitute(images_, p.in()); }
  multivector operator()(const multivector &m) const {
    multivector out;
    for (const auto &[at, c] : m.terms())
      out.add(at, (*this)(c));
    return out;
  }
  // (p - fixed) / relation
  poly left_out(const poly &p, const poly &fixed) const {
    const auto q = quotient(p - fixed, *divisor_);
    return q ? *q : poly(p.in());
  }

private:
  const fixed_variable &by_;
  std::vector<poly> images_;
  std::unique_ptr<poly> divisor_;
};

// A subject without the variables that relations say to be numbers.
struct fixed_subject {
  product_subject of;
  std::vector<certified_difference> differences; // of the values
  // relation j of the subject = relation j of `of` + sum of multiplier * relation
  std::vector<certified_difference> of_relations;
};

fixed_subject with_fixed(const product_subject &from) {
  fixed_subject out{from, {}, {}};
  const std::vector<fixed_variable> all = fixed_by(from.relations);
  for (const fixed_variable &by : all) {
    const fixing fix(from.numbers, by);
    const auto replace = [&](std::vector<poly> &of, std::vector<certified_difference> &differences) {
      for (std::size_t i = 0; i < of.size(); ++i) {
        const poly fixed = fix(of[i]);
        if (const poly m = fix.left_out(of[i], fixed); !m.is_zero())
          differences.push_back({i, by.relation, m});
        of[i] = fixed;
      }
    };
    replace(out.of.values, out.differences);
    for (multivector &m : out.of.operands)
      m = fix(m);
    out.of.relations[by.relation] = poly(from.numbers); // it has been used
    replace(out.of.relations, out.of_relations);
  }
  return out;
}

// The certificate in the relations of the subject from which `s` was made.
std::vector<certified_difference> in_relations(const fixed_subject &s, const std::vector<certified_difference> &found) {
  std::vector<certified_difference> out = s.differences;
  for (const certified_difference &d : found) {
    out.push_back(d);
    for (const certified_difference &r : s.of_relations)
      if (r.output == d.relation)
        out.push_back({d.output, r.relation, (d.multiplier * r.multiplier).scaled(-1)});
  }
  return out;
}

std::set<int> variables_of(const multivector &m) {
  std::set<int> out;
  for (const auto &[at, c] : m.terms())
    for (const int v : c.variables())
      out.insert(v);
  return out;
}

// The lowest and highest degree of terms in these variables.
std::pair<int, int> degrees(const std::vector<poly> &of, const std::set<int> &variables) {
  int low = 99, high = 0;
  for (const poly &p : of)
    for (const meetc::poly::term &t : p.terms()) {
      int sum = 0;
      for (const meetc::poly::power &f : t.factors)
        sum += variables.count(f.variable) ? f.exponent : 0;
      low = std::min(low, sum);
      high = std::max(high, sum);
    }
  return {low, high};
}

} // namespace

std::optional<found_program> under_relations(ir::arena &nodes, const product_subject &of,
                                             const std::vector<node_id> &leaves, const written_programs &written,
                                             int to_beat) {
  if (of.relations.empty())
    return std::nullopt;
  const fixed_subject fixed = with_fixed(of);
  std::vector<found_program> all = searched_forms(nodes, fixed.of, leaves, meetc::poly::price::whole);
  if (!fixed.differences.empty())
    for (std::vector<node_id> &outputs : written(fixed.of.operands))
      all.push_back({std::move(outputs), {}});
  std::optional<found_program> best;
  for (found_program &f : all) {
    f.differences = in_relations(fixed, f.differences);
    if (f.differences.empty())
      continue;
    if (const int cost = ir::count(nodes, f.outputs).total(); cost < to_beat) {
      to_beat = cost;
      best = std::move(f);
    }
  }
  return best;
}

std::optional<found_program> prepared(ir::arena &nodes, const product_subject &of, const std::vector<node_id> &leaves) {
  if (of.operands.size() != 2)
    return std::nullopt;
  const fixed_subject fixed = with_fixed(of);
  for (const std::size_t object : {1, 0}) {
    const std::set<int> of_object = variables_of(fixed.of.operands[object]),
                        of_versor = variables_of(fixed.of.operands[1 - object]);
    if (of_object.empty() || degrees(fixed.of.values, of_object).second != 1 ||
        degrees(fixed.of.values, of_versor).second < 2)
      continue;
    // The matrix, row by row; equal entries up to a factor once.
    struct entry {
      std::size_t value, matrix;
      int variable; // -1: the entry is added as it is
      rational scale;
    };
    std::vector<entry> entries;
    std::vector<poly> matrix;
    const auto add = [&](std::size_t value, int variable, const poly &p) {
      if (p.is_zero())
        return;
      const auto [content, primitive] = p.primitive();
      auto it = std::find(matrix.begin(), matrix.end(), primitive);
      if (it == matrix.end())
        it = matrix.insert(matrix.end(), primitive);
      entries.push_back({value, static_cast<std::size_t>(it - matrix.begin()), variable, content});
    };
    for (std::size_t i = 0; i < fixed.of.values.size(); ++i) {
      poly rest = fixed.of.values[i];
      for (const int v : of_object) {
        const poly c = rest.derivative(v);
        add(i, v, c);
        rest = rest - c * poly::variable(of.numbers, v);
      }
      add(i, -1, rest);
    }
    product_subject own{of.basis, of.numbers, {fixed.of.operands[1 - object]}, {}, matrix, {}};
    std::vector<std::size_t> numbers; // of own relations among the subject's
    for (std::size_t r = 0; r < fixed.of.relations.size(); ++r) {
      const std::vector<int> used = fixed.of.relations[r].variables();
      if (!used.empty() && std::all_of(used.begin(), used.end(), [&](int v) { return of_versor.count(v) > 0; })) {
        own.relations.push_back(fixed.of.relations[r]);
        numbers.push_back(r);
      }
    }
    const auto cost = [&](const found_program &f) { return ir::count(nodes, f.outputs).total(); };
    const std::vector<found_program> all = searched_forms(nodes, own, leaves, meetc::poly::price::whole);
    if (all.empty())
      return std::nullopt;
    const found_program &best = *std::min_element(
        all.begin(), all.end(), [&](const found_program &x, const found_program &y) { return cost(x) < cost(y); });
    found_program out{std::vector<node_id>(of.values.size(), nodes.constant(0)), {}};
    std::vector<certified_difference> found;
    for (const entry &e : entries) {
      const node_id m = nodes.multiply(nodes.constant(e.scale), best.outputs[e.matrix]);
      out.outputs[e.value] = nodes.add(
          out.outputs[e.value], e.variable < 0 ? m : nodes.multiply(m, leaves[static_cast<std::size_t>(e.variable)]));
      for (const certified_difference &d : best.differences)
        if (d.output == e.matrix) {
          poly multiplier = d.multiplier.scaled(e.scale);
          if (e.variable >= 0)
            multiplier = multiplier * poly::variable(of.numbers, e.variable);
          found.push_back({e.value, numbers[d.relation], multiplier});
        }
    }
    out.differences = in_relations(fixed, found);
    return out;
  }
  return std::nullopt;
}

} // namespace meetc::search
