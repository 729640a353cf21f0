#include "gen/target/cpp/body.hpp"

#include "gen/bound/growth.hpp"
#include "gen/bound/rounding_count.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/statements.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace meetc::target {
namespace {

std::string constant_text(const ir::rational &q, const body_names &names) {
  const mpz_class &a = q.get_num(), &b = q.get_den();
  if (b == 1)
    return fmt::format("{}({})", names.number, a.get_str());
  // Both have one type, whatever their sizes are.
  const char *const type = a.fits_sint_p() && b.fits_sint_p() ? "" : "LL";
  return fmt::format("meetc::ratio<{0}>({1}{3}, {2}{3})", names.type, a.get_str(), b.get_str(), type);
}

syntax cpp_syntax(const body_names &names, const std::string &indent) {
  return {.type = names.type,
          .fma = names.fma,
          .constant = [names](const ir::rational &q) { return constant_text(q, names); },
          .input = names.input,
          .indent = indent,
          .wide_type = "W",
          .wide_product = "meetc::times<W>",
          .local = identifier};
}

// A statement with a remark, which goes on the same line if there is room and otherwise on the line above.
std::string line(const std::string &indent, const std::string &statement, const std::string &remark = "") {
  if (remark.empty())
    return fmt::format("{}{}\n", indent, statement);
  if (indent.size() + statement.size() + remark.size() < 106)
    return fmt::format("{}{} // {}\n", indent, statement, remark);
  return fmt::format("{0}// {1}\n{0}{2}\n", indent, remark, statement);
}

} // namespace

body_names names_of_formula() {
  body_names out;
  out.fma = "meetc::multiply_add<T>";
  out.number = "meetc::number<T>";
  return out;
}

std::string body(const ir::program &p, const body_names &names, const std::string &indent) {
  const statements::text text = statements::of(p, cpp_syntax(names, indent));
  std::string out = text.before;
  for (std::size_t i = 0; i < text.results.size(); ++i)
    out += line(indent, names.result(i, text.results[i]));
  return out;
}

void check_whole(const lower::formula &f, const std::string &text) {
  const auto assigned = [&](const lower::basis_blade &b) {
    return f.is_number() ? text.find("return ") != std::string::npos
                         : text.find(fmt::format("B.{} = ", blade_field(b))) != std::string::npos;
  };
  if (f.result_names.empty() || f.from_blades.results.size() != f.result_names.size() ||
      !std::all_of(f.result_names.begin(), f.result_names.end(), assigned))
    throw std::logic_error("an emitted formula does not assign all its results");
}

stored_body stored_parts(const ir::program &p, const body_names &names, const std::string &indent) {
  const auto object = [&](poly::residency where, int &count) {
    const statements::text text = statements::of(p, ir::stored_of(p, where), cpp_syntax(names, indent));
    std::string out = text.before;
    for (const std::string &value : text.results)
      out += line(indent, fmt::format("f[{}] = {};", count++, value));
    return out;
  };
  stored_body out;
  out.object_a = object(poly::residency::a, out.fields_a);
  out.object_b = object(poly::residency::b, out.fields_b);
  int a = 0, b = 0;
  for (const ir::node_id id : p.stored)
    out.read[id] = p.nodes.where(id) == poly::residency::a ? fmt::format("fa[{}]", a++) : fmt::format("fb[{}]", b++);
  return out;
}

std::string pair_body(const ir::program &p, const stored_body &stored, const body_names &names, bool mixed,
                      const std::vector<std::string> &remarks, const std::string &indent) {
  syntax s = cpp_syntax(names, indent);
  if (mixed) {
    for (const bound::growth &g : bound::growths(p))
      s.wide.push_back(g.degree >= 3);
  }
  const statements::text text = statements::of(p, p.results, s, stored.read);
  std::string out = text.before;
  for (std::size_t i = 0; i < text.results.size(); ++i) {
    const bool widened = mixed && !s.wide[static_cast<std::size_t>(p.results[i])];
    out += line(indent, names.result(i, widened ? fmt::format("W({})", text.results[i]) : text.results[i]),
                remarks.empty() ? "" : remarks[i]);
  }
  return out;
}

std::string count_text(const ir::counts &c) {
  const auto number = [](int n, const char *what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  std::string out =
      number(c.multiplications + c.fused, "multiplication") + ", " + number(c.additions + c.fused, "addition");
  if (c.scalings)
    out += ", " + number(c.scalings, "scaling") + (c.scalings == 1 ? " by a power of two" : " by powers of two");
  if (c.negations)
    out += ", " + number(c.negations, "negation");
  return out;
}

std::string error_text(const ir::program &p) {
  const int n = bound::rounding_count(p);
  const char *of = p.results.size() == 1 ? "the exact value" : "the exact values";
  return n == 0 ? fmt::format("These are {}.", of) : fmt::format("Within ((1 + u)^{} - 1) M of {}.", n, of);
}

std::vector<std::string> assumption_lines(const lower::assumptions &of, const std::vector<lower::basis_blade> &results,
                                          const std::vector<std::string> &inputs) {
  constexpr std::size_t longest = 24; // terms that are written out
  std::vector<std::string> out;
  for (const lower::assumption &a : of.taken) {
    out.push_back(fmt::format("Takes {} of {} for granted, {}.", a.text, a.operand,
                              a.nearly ? fmt::format("within {:g} in each coefficient", a.within)
                                       : "which holds identically in its stored numbers"));
    for (std::size_t i = 0; a.nearly && i < results.size(); ++i) {
      const poly::poly &p = a.left_out[i];
      if (p.is_zero())
        continue;
      const std::string terms =
          p.length() <= longest ? poly_with_names(p, inputs) : fmt::format("{} terms", p.length());
      out.push_back(fmt::format("  {} differs from the formula's value by at most {:g} times the sizes of: {}",
                                results[i].is_scalar() ? "The value" : "B." + blade_field(results[i]), a.within,
                                terms));
    }
  }
  return out;
}

std::string poly_with_names(const poly::poly &p, const std::vector<std::string> &names) {
  const poly::ring renamed(names);
  return poly::poly::from_terms(renamed, p.terms()).text();
}

std::string wrapped(const std::string &text, const std::string &prefix, std::size_t width) {
  std::string out;
  std::size_t from = 0;
  std::string lead = prefix;
  while (lead.size() + text.size() - from > width) {
    std::size_t cut = text.rfind(' ', from + width - lead.size());
    // Break before a '+' or '-' that stands between spaces.
    while (cut != std::string::npos && cut > from && !(cut + 2 < text.size() && text[cut + 2] == ' '))
      cut = text.rfind(' ', cut - 1);
    if (cut == std::string::npos || cut <= from)
      break;
    out += lead + text.substr(from, cut - from) + '\n';
    from = cut + 1;
    lead = prefix + "    ";
  }
  return out + lead + text.substr(from) + '\n';
}

} // namespace meetc::target
