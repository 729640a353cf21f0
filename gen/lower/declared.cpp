#include "gen/lower/declared.hpp"
#include "gen/lower/kernel/compile.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace meetc::lower {
namespace {

// For each support blade, its linear combination of the kept blades. It is found by row reduction of the coefficients,
// as vectors of monomials, over all constructors of the kind at once.
std::vector<std::vector<std::pair<std::size_t, rational>>> linear_relations(const model &m, const lang::kind &k,
                                                                            const std::vector<blade> &blades) {
  std::vector<std::map<std::string, rational>> columns(blades.size()); // maps monomials to coefficients
  const auto add = [&](const std::string &tag, const std::vector<lang::field> &of, const lang::expr &body) {
    std::vector<std::string> names;
    for (const lang::field &f : of)
      if (f.type == "real")
        names.push_back(f.name);
      else
        for (const stored_real &r : m.layout(*m.spec().find_kind(f.type)).reals)
          names.push_back(f.name + '.' + r.path);
    const poly::ring ring(names);
    decision unused;
    expander expand(m, ring, unused);
    environment env;
    for (const lang::field &f : of)
      if (f.type == "real")
        env.emplace_back(f.name, value{multivector(0, poly::poly::variable(ring, ring.find(f.name)))});
      else
        env.emplace_back(f.name, expand.operand(*m.spec().find_kind(f.type), f.name + '.'));
    const multivector v = m.in_declared(expand.evaluate_multivector(body, env));
    for (std::size_t i = 0; i < blades.size(); ++i)
      if (const poly::poly *c = v.find(blades[i]))
        for (const poly::term &t : c->terms()) {
          std::string key = tag;
          for (const poly::power &f : t.factors)
            key += fmt::format("*{}^{}", f.variable, f.exponent);
          columns[i][key] += t.coefficient;
        }
  };
  add("", k.store, *k.blade);
  for (const lang::constructor &c : k.from)
    add(c.name, c.of, *c.blade);
  // Each column is reduced by the pivots of the columns kept before it. A column that vanishes is a combination of
  // those.
  struct pivot {
    std::map<std::string, rational> rest;
    std::map<std::size_t, rational> made_of;
  };
  std::vector<pivot> kept;
  std::vector<std::vector<std::pair<std::size_t, rational>>> out(blades.size());
  for (std::size_t i = 0; i < blades.size(); ++i) {
    pivot p{columns[i], {{i, 1}}};
    for (const pivot &q : kept) {
      const auto lead = q.rest.begin();
      const auto it = p.rest.find(lead->first);
      if (it == p.rest.end())
        continue;
      const rational f = it->second / lead->second;
      for (const auto &[key, c] : q.rest)
        if ((p.rest[key] -= f * c) == 0)
          p.rest.erase(key);
      for (const auto &[column, c] : q.made_of)
        p.made_of[column] -= f * c;
    }
    if (p.rest.empty()) {
      for (const auto &[column, c] : p.made_of)
        if (column != i && c != 0)
          out[i].emplace_back(column, -c);
      // This involves only kept columns, since made_of names no others.
    } else {
      out[i].emplace_back(i, 1);
      kept.push_back(std::move(p));
      // The reduction is complete because pivots are in the order of their leading monomials.
      std::sort(kept.begin(), kept.end(),
                [](const pivot &a, const pivot &b) { return a.rest.begin()->first < b.rest.begin()->first; });
    }
  }
  return out;
}

} // namespace

declared_formula in_declared_basis(const model &m, const request &r) {
  std::vector<std::vector<blade>> supports;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    supports.push_back(support(m, *r.kinds[i], true));
    for (const blade b : supports.back())
      names.push_back(r.names[i] + '.' + m.declared().name(b));
  }
  auto numbers = std::make_shared<poly::ring>(names);
  decision unused;
  std::vector<std::vector<rational>> identity(static_cast<std::size_t>(m.declared().vectors()));
  for (std::size_t i = 0; i < identity.size(); ++i) {
    identity[i].resize(identity.size());
    identity[i][i] = 1;
  }
  expander expand(m, *numbers, unused, m.declared(), identity);
  environment env;
  std::size_t at = 0;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const auto relations = linear_relations(m, *r.kinds[i], supports[i]);
    multivector operand;
    for (std::size_t b = 0; b < supports[i].size(); ++b)
      for (const auto &[column, c] : relations[b])
        operand.add(supports[i][b], poly::poly::variable(*numbers, static_cast<int>(at + column)).scaled(c));
    env.emplace_back(r.names[i], value{operand});
    at += supports[i].size();
  }
  const multivector v = expand.evaluate_multivector(*r.body, env);
  declared_formula out{numbers, 0, {}, {}, {}, poly::poly(*numbers)};
  for (const std::vector<blade> &of : supports)
    out.supports.push_back(named(m.declared(), of));
  if (!supports.empty())
    out.numbers_of_x = static_cast<int>(supports.front().size());
  std::set<blade> where;
  for (const auto &[b, c] : v.terms())
    where.insert(b);
  const std::vector<blade> blades = sorted_blades(m.declared(), where);
  out.blades = named(m.declared(), blades);
  for (const blade b : blades)
    out.values.push_back(*v.find(b));
  std::size_t terms = 0;
  for (const poly::poly &c : out.values)
    terms += c.length();
  if (terms * terms > 64 * static_cast<std::size_t>(most_steps))
    throw too_long(r.where, fmt::format("the square of '{}' expands to more than {} steps", r.text, most_steps));
  const multivector square = algebra::geometric(m.declared(), v, v);
  if (const poly::poly *s = square.find(0))
    out.norm2 = *s;
  return out;
}

} // namespace meetc::lower
