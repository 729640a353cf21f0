// The signs and values of kernels as sums of products f(X) g(Y): how wide all pairs are as a matrix product.
#include "gen/poly/separate.hpp"

#include "gen/target/target.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

struct subject {
  std::string group, label; // "common", "s[0]"; "", "e1^n"
  poly::separation parts;
};

// Everything that a kernel on two operands computes, in the stored numbers of signs and in the blades of formulas.
std::vector<subject> subjects_of(const lower::model &m, const lower::kernel &k) {
  std::vector<subject> out;
  if (k.is_predicate) {
    const lower::predicate &p = k.decision;
    const std::pair<const char *, const lower::stage *> stages[] = {
        {"reject", &p.reject}, {"common", &p.common}, {"rare", &p.rare}};
    for (const auto &[name, stage] : stages)
      for (const int a : stage->atoms)
        out.push_back({name, fmt::format("s[{}]", out.size()),
                       poly::separate(p.signs.atoms()[static_cast<std::size_t>(a)], p.inputs_a)});
    return out;
  }
  if (k.asked.kinds.size() != 2)
    return out;
  const auto inputs_a = static_cast<int>(lower::support(m, *k.asked.kinds[0]).size());
  for (std::size_t i = 0; i < k.value.result.size(); ++i)
    out.push_back({"", m.working().name(k.value.result[i]), poly::separate(k.value.polynomials[i], inputs_a)});
  return out;
}

constexpr int step = 16; // columns that one m16n8k16 multiplies

// In half precision f g is three columns, h h' + h l' + l h', and an additive term is two, h + l.
int columns(const poly::separation &s) {
  return 3 * static_cast<int>(s.products.size()) + 2 * s.additive();
}
int steps(const poly::separation &s) {
  return (columns(s) + step - 1) / step;
}

std::string numbers(const poly::separation &s) {
  return fmt::format("{:>4} {:>9} {:>9} {:>8} {:>6}", s.terms(), s.products.size(), s.additive(), columns(s), steps(s));
}

std::string in_parentheses(const poly::poly &p) {
  return p.length() > 1 || p.terms().front().coefficient != 1 ? '(' + p.text() + ')' : p.text();
}

} // namespace

std::string separate_text(const lower::model &m, const lower::kernel &k) {
  if (k.asked.kinds.size() != 2)
    throw spec_error(
        {}, fmt::format("--emit=separate is of two operands; '{}' has {}", k.asked.text, k.asked.kinds.size()));
  const auto plural = [](int n, const char *what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  std::string out;
  for (const subject &s : subjects_of(m, k)) {
    out +=
        fmt::format("{}{}{}: K = {}, {} and {}; {} of half precision, {} of {}\n", s.group, s.group.empty() ? "" : " ",
                    s.label, s.parts.terms(), plural(static_cast<int>(s.parts.products.size()), "product"),
                    plural(s.parts.additive(), "additive term"), plural(columns(s.parts), "column"),
                    plural(steps(s.parts), "step"), step);
    for (const poly::product &p : s.parts.products)
      out += fmt::format("  {} * {}\n", in_parentheses(p.f), in_parentheses(p.g));
    for (const poly::poly *p : {&s.parts.of_x, &s.parts.of_y})
      if (!p->is_zero())
        out += fmt::format("  {}\n", p->text());
  }
  return out;
}

std::string separate_table(const lower::model &m, const std::vector<lower::kernel> &kernels) {
  std::size_t width = 6;
  for (const lower::kernel &k : kernels)
    width = std::max(width, k.asked.text.size());
  std::string out = fmt::format("{:<{}}  {:<7} {:>5} {:>4} {:>9} {:>9} {:>8} {:>6}\n", "kernel", width, "of", "count",
                                "K", "products", "additive", "columns", "steps");
  for (const lower::kernel &k : kernels) {
    const std::vector<subject> all = subjects_of(m, k);
    if (all.empty())
      out +=
          fmt::format("{:<{}}  {}\n", k.asked.text, width, k.asked.kinds.size() == 2 ? "zero" : "not of two operands");
    // Equal rows of a stage are one, in the order of their first.
    std::vector<std::pair<std::pair<std::string, std::string>, int>> rows;
    for (const subject &s : all) {
      const std::pair key{s.group.empty() ? std::string("value") : s.group, numbers(s.parts)};
      const auto at = std::find_if(rows.begin(), rows.end(), [&](const auto &r) { return r.first == key; });
      if (at == rows.end())
        rows.emplace_back(key, 1);
      else
        ++at->second;
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
      out += fmt::format("{:<{}}  {:<7} {:>5} {}\n", i ? "" : k.asked.text, width, rows[i].first.first, rows[i].second,
                         rows[i].first.second);
  }
  return out +
         fmt::format(
             "columns: 3 a product and 2 an additive term, in half precision; steps of {} columns; the matrix path "
             "is open in one step\n",
             step);
}

} // namespace meetc::target
