// A kernel's polynomials as JSON, for other programs.
#include "gen/target/json/json.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

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

// The shortest sum of products f(X) g(Y).
std::string json_separation(const poly::separation &s) {
  std::vector<std::string> products;
  for (const poly::product &k : s.products)
    products.push_back(fmt::format("[{}, {}]", json_poly(k.f), json_poly(k.g)));
  return fmt::format("{{\"products\": [{}], \"of_x\": {}, \"of_y\": {}}}", join(products, ", "), json_poly(s.of_x),
                     json_poly(s.of_y));
}

} // namespace

std::string json(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  const forms &all = u.shown[kernel];
  std::vector<std::string> operands;
  for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
    operands.push_back(fmt::format("\"{}\": \"{}\"", k.asked.names[i], k.asked.kinds[i]->name));
  const std::string out =
      fmt::format("{{\n  \"kernel\": \"{}\",\n  \"operands\": {{{}}},\n", k.asked.text, join(operands, ", "));
  if (k.is_predicate) {
    std::vector<std::string> stages, separated;
    std::size_t next = 0;
    const auto by_stage = lower::stages(k.decision);
    for (std::size_t s = 0; s < by_stage.size(); ++s) {
      std::vector<std::string> atoms, sums;
      for (const int a : by_stage[s]->atoms) {
        atoms.push_back("      " + json_poly(k.decision.signs.atoms()[static_cast<std::size_t>(a)]));
        sums.push_back("      " + json_separation(all.separated[next++].parts));
      }
      const auto list = [&](const std::vector<std::string> &lines) {
        return fmt::format("    \"{}\": [{}{}{}]", lower::name_of(lower::stage_kinds[s]), lines.empty() ? "" : "\n",
                           join(lines, ",\n"), lines.empty() ? "" : "\n    ");
      };
      stages.push_back(list(atoms));
      separated.push_back(list(sums));
    }
    return out + fmt::format("  \"atoms\": {{\n{}\n  }},\n  \"separate\": {{\n{}\n  }}\n}}\n", join(stages, ",\n"),
                             join(separated, ",\n"));
  }
  const lower::declared_formula &f = *all.declared;
  std::vector<std::string> blades, sums;
  for (std::size_t i = 0; i < f.blades.size(); ++i)
    blades.push_back(fmt::format("    \"{}\": {}", f.blades[i].text(), json_poly(f.values[i])));
  for (const lower::separated &s : all.declared_separated)
    sums.push_back(fmt::format("    \"{}\": {}", s.label, json_separation(s.parts)));
  const std::string separated = sums.empty() ? "" : fmt::format(",\n  \"separate\": {{\n{}\n  }}", join(sums, ",\n"));
  return out + fmt::format("  \"blades\": {{{}{}{}}},\n  \"norm2\": {}{}\n}}\n", blades.empty() ? "" : "\n",
                           join(blades, ",\n"), blades.empty() ? "" : "\n  ", json_poly(f.norm2), separated);
}

} // namespace meetc::target
