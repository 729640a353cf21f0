// Kernels for eyes and for other programs: polynomials as JSON, LaTeX and text, and the graph.
#include "gen/poly/separate.hpp"
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/target.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace meetc::target {
namespace {

using algebra::blade;
using lower::multivector;
using poly::rational;

// A formula in the declared basis: its operands' coefficients X.e1^e2 there, with linear relations between the
// coefficients of a kind (as e and eb parts that are equal) used up, so that each value has one name.
struct declared_formula {
  std::shared_ptr<poly::ring> numbers;
  std::vector<blade> blades;
  std::vector<poly::poly> values;
  poly::poly norm2;
};

// For each support blade: how it follows from the blades kept. Row reduction of the coefficients as vectors of
// monomials, over all constructors of the kind at once.
std::vector<std::vector<std::pair<std::size_t, rational>>> linear_relations(const lower::model &m, const lang::kind &k,
                                                                            const std::vector<blade> &blades) {
  std::vector<std::map<std::string, rational>> columns(blades.size()); // monomial to coefficient
  const auto add = [&](const std::string &tag, const std::vector<lang::field> &of, const lang::expr &body) {
    std::vector<std::string> names;
    for (const lang::field &f : of)
      if (f.type == "real")
        names.push_back(f.name);
      else
        for (const lower::stored_real &r : m.layout(*m.spec().find_kind(f.type)).reals)
          names.push_back(f.name + '.' + r.path);
    const poly::ring ring(names);
    lower::decision unused;
    lower::expander expand(m, ring, unused);
    lower::environment env;
    for (const lang::field &f : of)
      if (f.type == "real")
        env.emplace_back(f.name, lower::value{multivector(0, poly::poly::variable(ring, ring.find(f.name)))});
      else
        env.emplace_back(f.name, expand.operand(*m.spec().find_kind(f.type), f.name + '.'));
    const multivector v = algebra::outermorphism(expand.evaluate_multivector(body, env), m.to_declared());
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
  // Each column reduced by the pivots of the columns kept before it; what vanishes is a combination of those.
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
      // In terms of kept columns alone: made_of names only columns that were kept.
    } else {
      out[i].emplace_back(i, 1);
      kept.push_back(std::move(p));
      // Pivots in order of their leading monomials keep the reduction complete.
      std::sort(kept.begin(), kept.end(),
                [](const pivot &a, const pivot &b) { return a.rest.begin()->first < b.rest.begin()->first; });
    }
  }
  return out;
}

declared_formula in_declared_basis(const lower::model &m, const lower::request &r) {
  std::vector<std::vector<blade>> supports;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    supports.push_back(lower::support(m, *r.kinds[i], true));
    for (const blade b : supports.back())
      names.push_back(r.names[i] + '.' + m.declared().name(b));
  }
  auto numbers = std::make_shared<poly::ring>(names);
  lower::decision unused;
  std::vector<std::vector<rational>> identity(static_cast<std::size_t>(m.declared().vectors()));
  for (std::size_t i = 0; i < identity.size(); ++i) {
    identity[i].resize(identity.size());
    identity[i][i] = 1;
  }
  lower::expander expand(m, *numbers, unused, m.declared(), identity);
  lower::environment env;
  std::size_t at = 0;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const auto relations = linear_relations(m, *r.kinds[i], supports[i]);
    multivector operand;
    for (std::size_t b = 0; b < supports[i].size(); ++b)
      for (const auto &[column, c] : relations[b])
        operand.add(supports[i][b], poly::poly::variable(*numbers, static_cast<int>(at + column)).scaled(c));
    env.emplace_back(r.names[i], lower::value{operand});
    at += supports[i].size();
  }
  const multivector v = expand.evaluate_multivector(*r.body, env);
  declared_formula out{numbers, {}, {}, poly::poly(*numbers)};
  for (const auto &[b, c] : v.terms())
    out.blades.push_back(b);
  std::sort(out.blades.begin(), out.blades.end(), algebra::in_reading_order);
  for (const blade b : out.blades)
    out.values.push_back(*v.find(b));
  const multivector square = algebra::geometric(m.declared(), v, v);
  if (const poly::poly *s = square.find(0))
    out.norm2 = *s;
  return out;
}

std::string json_poly(const poly::poly &p) {
  std::vector<std::string> terms;
  for (const poly::term &t : p.terms()) {
    std::vector<std::string> factors;
    for (const poly::power &f : t.factors)
      factors.push_back(fmt::format("\"{}\": {}", p.in().name(f.variable), f.exponent));
    terms.push_back(fmt::format("[\"{}\", {{{}}}]", t.coefficient.get_str(), join(factors, ", ")));
  }
  return '[' + join(terms, ", ") + ']';
}

// The least sum of products f(X) g(Y).
std::string json_separation(const poly::poly &p, int first_of_y) {
  const poly::separation s = poly::separate(p, first_of_y);
  std::vector<std::string> products;
  for (const poly::product &k : s.products)
    products.push_back(fmt::format("[{}, {}]", json_poly(k.f), json_poly(k.g)));
  return fmt::format("{{\"products\": [{}], \"of_x\": {}, \"of_y\": {}}}", join(products, ", "), json_poly(s.of_x),
                     json_poly(s.of_y));
}

std::string latex_name(const std::string &name) {
  std::string out;
  for (const char c : name)
    out += c == '_' ? std::string("\\_") : std::string(1, c);
  return out;
}

std::string latex_blade(const algebra::metric &m, blade b) {
  std::string out;
  for (int i = 0; i < m.vectors(); ++i)
    if (b >> i & 1) {
      const std::string &n = m.names()[static_cast<std::size_t>(i)];
      const std::size_t digits = n.find_first_of("0123456789");
      std::string text = digits == std::string::npos || digits == 0
                             ? n
                             : fmt::format("{}_{{{}}}", n.substr(0, digits), n.substr(digits));
      if (n.size() == 2 && n[1] == 'b')
        text = fmt::format("\\bar{{{}}}", n[0]);
      out += (out.empty() ? "" : " \\wedge ") + text;
    }
  return out.empty() ? "1" : out;
}

// "X.e1^e2" to X_{e_{1} \wedge e_{2}}.
std::string latex_poly(const poly::poly &p, const std::vector<std::string> &names) {
  if (p.is_zero())
    return "0";
  std::string out;
  for (const poly::term &t : p.terms()) {
    const rational c = abs(t.coefficient);
    out += t.coefficient < 0 ? (out.empty() ? "-" : " - ") : (out.empty() ? "" : " + ");
    if (c != 1 || t.factors.empty())
      out += c.get_den() == 1 ? c.get_num().get_str()
                              : fmt::format("\\tfrac{{{}}}{{{}}}", c.get_num().get_str(), c.get_den().get_str());
    for (const poly::power &f : t.factors) {
      out += ' ' + names[static_cast<std::size_t>(f.variable)];
      if (f.exponent > 1)
        out += fmt::format("^{{{}}}", f.exponent);
    }
  }
  return out;
}

// A predicate's atoms as the polynomials in stored numbers that they are the signs of.
std::vector<const lower::stage *> stages_of(const lower::predicate &p) {
  std::vector<const lower::stage *> out;
  for (const lower::stage *s : {&p.reject, &p.common, &p.rare})
    if (!s->atoms.empty())
      out.push_back(s);
  return out;
}

} // namespace

std::string json(const lower::model &m, const lower::kernel &k) {
  std::vector<std::string> operands;
  for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
    operands.push_back(fmt::format("\"{}\": \"{}\"", k.asked.names[i], k.asked.kinds[i]->name));
  std::string out =
      fmt::format("{{\n  \"kernel\": \"{}\",\n  \"operands\": {{{}}},\n", k.asked.text, join(operands, ", "));
  if (k.is_predicate) {
    std::vector<std::string> stages, separated;
    static const char *const names[] = {"reject", "common", "rare"};
    const lower::stage *const all[] = {&k.decision.reject, &k.decision.common, &k.decision.rare};
    for (std::size_t s = 0; s < 3; ++s) {
      std::vector<std::string> atoms, sums;
      for (const int a : all[s]->atoms) {
        const poly::poly &atom = k.decision.signs.atoms()[static_cast<std::size_t>(a)];
        atoms.push_back("      " + json_poly(atom));
        sums.push_back("      " + json_separation(atom, k.decision.inputs_a));
      }
      const auto list = [&](const std::vector<std::string> &lines) {
        return fmt::format("    \"{}\": [{}{}{}]", names[s], lines.empty() ? "" : "\n", join(lines, ",\n"),
                           lines.empty() ? "" : "\n    ");
      };
      stages.push_back(list(atoms));
      separated.push_back(list(sums));
    }
    return out + fmt::format("  \"atoms\": {{\n{}\n  }},\n  \"separate\": {{\n{}\n  }}\n}}\n", join(stages, ",\n"),
                             join(separated, ",\n"));
  }
  const declared_formula f = in_declared_basis(m, k.asked);
  std::vector<std::string> blades;
  for (std::size_t i = 0; i < f.blades.size(); ++i)
    blades.push_back(fmt::format("    \"{}\": {}", m.declared().name(f.blades[i]), json_poly(f.values[i])));
  std::string separated;
  if (k.asked.kinds.size() == 2) {
    const auto first_of_y = static_cast<int>(lower::support(m, *k.asked.kinds[0], true).size());
    std::vector<std::string> sums;
    for (std::size_t i = 0; i < f.blades.size(); ++i)
      sums.push_back(
          fmt::format("    \"{}\": {}", m.declared().name(f.blades[i]), json_separation(f.values[i], first_of_y)));
    sums.push_back(fmt::format("    \"norm2\": {}", json_separation(f.norm2, first_of_y)));
    separated = fmt::format(",\n  \"separate\": {{\n{}\n  }}", join(sums, ",\n"));
  }
  return out + fmt::format("  \"blades\": {{{}{}{}}},\n  \"norm2\": {}{}\n}}\n", blades.empty() ? "" : "\n",
                           join(blades, ",\n"), blades.empty() ? "" : "\n  ", json_poly(f.norm2), separated);
}

std::string latex(const lower::model &m, const lower::kernel &k) {
  std::string out = "\\begin{align*}\n";
  if (k.is_predicate) {
    std::vector<std::string> names;
    for (const std::string &n : k.decision.stored_inputs)
      names.push_back(fmt::format("\\mathit{{{}}}", latex_name(n)));
    int i = 0;
    for (const lower::stage *s : stages_of(k.decision))
      for (const int a : s->atoms)
        out += fmt::format("s_{{{}}} &= {} \\\\\n", i++,
                           latex_poly(k.decision.signs.atoms()[static_cast<std::size_t>(a)], names));
    return out + "\\end{align*}\n";
  }
  const declared_formula f = in_declared_basis(m, k.asked);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
    for (const blade b : lower::support(m, *k.asked.kinds[i], true))
      names.push_back(fmt::format("{}_{{{}}}", latex_name(k.asked.names[i]), latex_blade(m.declared(), b)));
  for (std::size_t i = 0; i < f.blades.size(); ++i)
    out += fmt::format("B_{{{}}} &= {} \\\\\n", latex_blade(m.declared(), f.blades[i]), latex_poly(f.values[i], names));
  return out + fmt::format("B^2 &= {}\n\\end{{align*}}\n", latex_poly(f.norm2, names));
}

std::string poly_text(const lower::model &m, const lower::kernel &k) {
  std::string out;
  if (k.is_predicate) {
    int i = 0;
    for (const lower::stage *s : stages_of(k.decision))
      for (const int a : s->atoms) {
        const poly::poly lowered = k.decision.local->lower(k.decision.signs.atoms()[static_cast<std::size_t>(a)]);
        out += fmt::format("s[{}] = sign of {}\n", i++, lowered.text());
      }
    return out;
  }
  for (std::size_t i = 0; i < k.value.result.size(); ++i)
    out += fmt::format("{}: {}\n", m.working().name(k.value.result[i]), k.value.polynomials[i].text());
  return out;
}

std::string dag_text(const lower::kernel &k, bool schedule) {
  std::string out;
  const auto program = [&](const ir::program &p, const std::vector<std::string> &inputs) {
    if (schedule) {
      body_names names;
      names.input = [&](int i) { return inputs[static_cast<std::size_t>(i)]; };
      names.result = [](std::size_t i, const std::string &value) { return fmt::format("result[{}] = {};", i, value); };
      out += body(p, names, "  ");
    } else {
      static const char *const residencies[] = {"scene", "A", "B", "pair"};
      static const char *const ops[] = {"input", "constant", "negate", "add", "subtract", "multiply", "fma"};
      for (const ir::node_id id : ir::needed(p.nodes, p.results)) {
        const ir::node &n = p.nodes.at(id);
        std::string operands;
        if (n.kind == ir::op::input)
          operands = ' ' + inputs[static_cast<std::size_t>(n.a)];
        else if (n.kind == ir::op::constant)
          operands = ' ' + p.nodes.value(id).get_str();
        else
          for (const ir::node_id operand : {n.a, n.b, n.c})
            if (operand >= 0)
              operands += fmt::format(" %{}", operand);
        out += fmt::format("  %{} = {}{}  ; {}\n", id, ops[static_cast<int>(n.kind)], operands,
                           residencies[static_cast<int>(p.nodes.where(id))]);
      }
      for (std::size_t i = 0; i < p.results.size(); ++i)
        out += fmt::format("  result[{}] = %{}\n", i, p.results[i]);
    }
    out += fmt::format("  ; {}\n", count_text(ir::count(p.nodes, p.results)));
  };
  if (k.is_predicate) {
    for (const lower::stage *s : stages_of(k.decision)) {
      out += fmt::format("stage of {} signs\n", s->atoms.size());
      program(s->code, k.decision.stored_inputs);
    }
    return out;
  }
  out += "from blades\n";
  program(k.value.from_blades, k.value.blade_inputs);
  if (!k.value.stored_inputs.empty()) {
    out += "from what is stored\n";
    program(k.value.from_stored, k.value.stored_inputs);
  }
  return out;
}

} // namespace meetc::target
