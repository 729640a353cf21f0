#include "gen/lower/kernel/value_names.hpp"

#include "gen/ir/residue.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace meetc::lower {
namespace {

constexpr int points = 2; // a name is no proof
constexpr long most_steps_named = 200'000;

// The coefficients of a multivector of numbers.
using coefficients = std::map<blade, rational>;

struct named_value {
  std::string name;
  coefficients value;
};
using named_values = std::vector<named_value>;

// The values that an expression names, on operands that are numbers at one point.
class collector {
public:
  collector(const model &m, int point) : model_(m), point_(point), none_({}), expand_(m, none_, unused_) {
    expand_.limit(most_steps_named);
    expand_.allow_bits(1 << 16);
  }

  value general(const std::vector<blade> &blades) {
    multivector v;
    for (const blade b : blades)
      v.add(b, {none_, next()});
    return {v};
  }
  value stored(const lang::kind &k) {
    return expand_.operand(k, [this] { return next(); });
  }

  void add(const std::string &name, const value &v, const location &where) {
    if (std::holds_alternative<multivector>(v.is) || std::holds_alternative<std::shared_ptr<const object>>(v.is))
      record(name, expand_.blade_of(v, where));
  }

  // The calls in an expression, and in the functions that they name, outer ones first.
  void calls(const lang::expr &e, const environment &env) {
    const lang::function *f = e.kind == lang::op::call ? model_.spec().find_function(e.text) : nullptr;
    const bool operation = e.kind == lang::op::builtin || (e.kind == lang::op::call && !f);
    if ((f && f->params.size() == e.args.size()) || (operation && lang::called_builtin(model_.spec(), e)))
      add(e.text, expand_.evaluate(e, env), e.where);
    for (const lang::expr_ptr &arg : e.args)
      calls(*arg, env);
    if (!f || f->params.size() != e.args.size())
      return;
    environment inner;
    for (std::size_t i = 0; i < e.args.size(); ++i)
      inner.emplace_back(f->params[i], expand_.evaluate(*e.args[i], env));
    calls(*f->body, inner);
  }

  // Products of operands of which searched programs are made (gen/search/product_forms.hpp).
  void products(const environment &operands) {
    const metric &basis = model_.working();
    std::vector<multivector> of;
    for (const auto &[name, v] : operands) {
      of.push_back(expand_.blade_of(v, {}));
      const multivector square = algebra::geometric(basis, of.back(), algebra::reverse(of.back()));
      record("rnorm2_" + name, algebra::grade_part(square, 0));
      record(name + "_rev_" + name, square);
    }
    if (of.size() == 2)
      record("bracket", algebra::geometric(basis, of[0], of[1]) - algebra::geometric(basis, of[1], of[0]));
  }

  named_values take() { return std::move(out_); }

private:
  const model &model_;
  int point_, next_ = 0;
  poly::ring none_;
  decision unused_;
  expander expand_;
  named_values out_;

  void record(const std::string &name, const multivector &v) {
    named_value n{name, {}};
    for (const auto &[at, c] : v.terms())
      n.value.emplace(at, c.constant());
    out_.push_back(std::move(n));
  }
  rational next() { return mpz_class(std::to_string(ir::residue_input(point_, next_++))); }
};

bool is_numbered(const std::string &name) {
  return (name[0] == 't' || name[0] == 'b') && name.size() > 1 &&
         name.find_first_not_of("0123456789", 1) == std::string::npos;
}

// Gives out names that emitted functions use for nothing else. The words of the languages are the targets' to avoid.
class free_names {
public:
  free_names(const lang::algebra &a, const std::vector<std::string> &operands)
      : used_(operands.begin(), operands.end()) {
    // Those of values and types in emitted functions, and macros of headers that a caller may include before them.
    for (const char *name : {"B",        "S",          "T",       "W",         "f",        "fa",       "fb",
                             "fields_a", "fields_b",   "k",       "np",        "object_a", "object_b", "pair",
                             "sign",     "isinstance", "complex", "imaginary", "near",     "far",      "small"})
      used_.insert(name);
    for (const std::string &name : operands) // in C, Python and shaders, where the language has the word
      used_.insert(name + "_operand");
    for (const lang::kind &k : a.kinds)
      used_.insert(k.name);
  }

  std::string take(const std::string &wanted) {
    std::string name;
    for (const char c : wanted) // two underscores in a row, or one at an end, are reserved
      if (c != '_' || (!name.empty() && name.back() != '_'))
        name += c;
    while (!name.empty() && name.back() == '_')
      name.pop_back();
    const auto ends = [&](const char *with) { return name.ends_with(with); };
    const bool lower = std::any_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    if (!lower || is_numbered(name) || name.starts_with("of_") || name.starts_with("blade_of_") || ends("_blade") ||
        ends("_result") || name.starts_with("gl_"))
      name = "value_" + name; // macros are in capitals
    std::string out = name;
    for (int n = 2; !used_.insert(out).second; ++n)
      out = fmt::format("{}_{}", name, n);
    return out;
  }

private:
  std::set<std::string> used_;
};

std::string coefficient_name(const model &m, const std::string &of, const coefficients &v, blade at) {
  if (at == 0)
    return v.size() == 1 ? of : of + "_scalar";
  return of + '_' + m.working().name(at, "_");
}

using key = std::vector<std::uint64_t>; // a value at the points

// The names of the coefficients, by value; the first one counts. Calls of one name with different values are numbered.
std::map<key, std::string> names_by_value(const model &m, const std::vector<named_values> &at) {
  std::map<key, std::string> out;
  std::map<std::string, std::vector<coefficients>> known;
  for (std::size_t i = 0; i < at[0].size() && i < at[1].size(); ++i) {
    const coefficients &v = at[0][i].value;
    std::vector<coefficients> &others = known[at[0][i].name];
    if (std::find(others.begin(), others.end(), v) != others.end())
      continue;
    others.push_back(v);
    const std::string name = others.size() == 1 ? at[0][i].name : fmt::format("{}_{}", at[0][i].name, others.size());
    for (const auto &[b, c] : v)
      if (const auto other = at[1][i].value.find(b); other != at[1][i].value.end())
        out.try_emplace(ir::residues(std::vector<rational>{c, other->second}), coefficient_name(m, name, v, b));
  }
  return out;
}

bool is_operation(const node &n) {
  return n.kind != op::input && n.kind != op::constant && n.kind != op::negate;
}

void name_nodes(program &p, const std::map<key, std::string> &by_value, const std::vector<basis_blade> &results,
                free_names free) {
  p.names.clear();
  for (std::size_t i = 0; i < results.size() && i < p.results.size(); ++i)
    if (is_operation(p.nodes.at(p.results[i])) && !p.names.count(p.results[i]))
      p.names[p.results[i]] = free.take("B_" + (results[i].is_scalar() ? "scalar" : join(results[i].vectors, "_")));
  const std::vector<node_id> ids = ir::needed(p.nodes, p.results);
  const std::vector<ir::residue_list> values = ir::residues(program{p.nodes, ids});
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!is_operation(p.nodes.at(ids[i])) || p.names.count(ids[i]))
      continue;
    const std::size_t words = points * ir::residue_primes.size();
    const auto it = by_value.find({values[i].begin(), values[i].begin() + static_cast<std::ptrdiff_t>(words)});
    if (it != by_value.end())
      p.names[ids[i]] = free.take(it->second);
  }
}

// Names for what `collect` names at each point, up to where that is too long.
template <class Collect> std::map<key, std::string> names_from(const model &m, const Collect &collect) {
  std::vector<named_values> at;
  for (int point = 0; point < points; ++point) {
    collector c(m, point);
    try {
      collect(c);
    } catch (const spec_error &) {
    }
    at.push_back(c.take());
  }
  return names_by_value(m, at);
}

} // namespace

void name_values(const model &m, kernel &k) {
  if (k.is_predicate)
    return;
  const request &r = k.asked;
  const free_names free(m.spec(), r.names);
  const std::vector<basis_blade> results = k.value.is_number() ? std::vector<basis_blade>{} : k.value.result_names;
  const auto on_blades = names_from(m, [&](collector &c) {
    environment env;
    for (std::size_t i = 0; i < r.kinds.size(); ++i)
      env.emplace_back(r.names[i], c.general(support(m, *r.kinds[i])));
    c.calls(*r.body, env);
    c.products(env);
  });
  for (program *p : {&k.value.from_blades, &k.value.prepared})
    name_nodes(*p, on_blades, results, free);
  if (!k.value.is_number())
    return;
  const auto on_stored = names_from(m, [&](collector &c) {
    environment env;
    for (std::size_t i = 0; i < r.kinds.size(); ++i) {
      env.emplace_back(r.names[i], c.stored(*r.kinds[i]));
      c.add(r.names[i], env.back().second, r.where);
    }
    c.calls(*r.body, env);
    c.products(env);
  });
  for (program *p : {&k.value.from_stored, &k.value.for_pairs})
    name_nodes(*p, on_stored, results, free);
}

} // namespace meetc::lower
