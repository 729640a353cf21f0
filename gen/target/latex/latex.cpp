// A kernel's polynomials as LaTeX.
#include "gen/target/latex/latex.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string latex_name(const std::string &name) {
  std::string out;
  for (const char c : name)
    out += c == '_' ? std::string("\\_") : std::string(1, c);
  return out;
}

std::string latex_blade(const lower::basis_blade &b) {
  std::vector<std::string> factors;
  for (const std::string &n : b.vectors) {
    const std::size_t digits = n.find_first_of("0123456789");
    if (n.size() == 2 && n[1] == 'b')
      factors.push_back(fmt::format("\\bar{{{}}}", n[0]));
    else if (digits == std::string::npos || digits == 0)
      factors.push_back(n);
    else
      factors.push_back(fmt::format("{}_{{{}}}", n.substr(0, digits), n.substr(digits)));
  }
  return b.is_scalar() ? "1" : join(factors, " \\wedge ");
}

// Turns "X.e1^e2" into X_{e_{1} \wedge e_{2}}.
std::string latex_poly(const poly::poly &p, const std::vector<std::string> &names) {
  if (p.is_zero())
    return "0";
  std::string out;
  for (const poly::term &t : p.terms()) {
    const poly::rational c = abs(t.coefficient);
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

// The text of a spec, on one line.
std::string latex_text(const std::string &text) {
  std::string out;
  for (const char c : text)
    if (c == '\n')
      out += ' ';
    else if (c == '^' || c == '~')
      out += fmt::format("\\{}{{}}", c);
    else if (std::string("_&#%$").find(c) != std::string::npos)
      out += std::string("\\") + c;
    else
      out += c;
  return "\\texttt{" + out + '}';
}

// The definition as it was written, and the sign atoms that it comes to: short ones in the stored numbers, others by their
// name in the spec and their number of terms.
std::string latex_predicate(const lower::kernel &k) {
  constexpr std::size_t most_terms = 12;
  std::string out = "\\begin{align*}\n";
  const auto line = [&](const std::string &what, const std::string &is) {
    out += fmt::format("{} &{} \\\\\n", what, is);
  };
  if (const lang::predicate *p = k.asked.asked) {
    for (const lang::named_expr &l : p->lets)
      line(latex_text(l.name), "= " + latex_text(lang::print(*l.body)));
    for (const lang::expr_ptr &r : p->reject)
      line("\\text{no, if}", "\\ " + latex_text(lang::print(*r)));
    line(latex_text(p->name), "= " + latex_text(lang::print(*p->hit)));
  } else {
    line(latex_text(k.asked.text), "= \\text{a sign}");
  }
  std::vector<std::string> names;
  for (const std::string &n : k.decision.stored_inputs)
    names.push_back(fmt::format("\\mathit{{{}}}", latex_name(n)));
  int i = 0;
  for (const lower::stage *s : lower::stages(k.decision))
    for (const int a : s->atoms) {
      const poly::poly &atom = k.decision.signs.atoms()[static_cast<std::size_t>(a)];
      const std::string text = k.decision.signs.text(a);
      const std::size_t terms = atom.terms().size();
      std::string is = text.empty() ? "" : "= " + latex_text(text);
      if (terms <= most_terms || text.empty())
        is += (is.empty() ? "= " : " = ") + latex_poly(atom, names);
      else
        is += fmt::format("\\quad\\text{{({} terms)}}", terms);
      line(fmt::format("s_{{{}}}", i++), is);
    }
  return out + "\\end{align*}\n";
}

} // namespace

std::string latex(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  if (k.is_predicate)
    return latex_predicate(k);
  std::string out = "\\begin{align*}\n";
  const lower::declared_formula &f = *u.shown[kernel].declared;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < f.supports.size(); ++i)
    for (const lower::basis_blade &b : f.supports[i])
      names.push_back(fmt::format("{}_{{{}}}", latex_name(k.asked.names[i]), latex_blade(b)));
  for (std::size_t i = 0; i < f.blades.size(); ++i)
    out += fmt::format("B_{{{}}} &= {} \\\\\n", latex_blade(f.blades[i]), latex_poly(f.values[i], names));
  return out + fmt::format("B^2 &= {}\n\\end{{align*}}\n", latex_poly(f.norm2, names));
}

} // namespace meetc::target
