// The signs and values of kernels as sums of products f(X) g(Y), with the inner dimension of the matrix product of all
// pairs.
#include "gen/target/text/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

constexpr int step = 16; // columns that one m16n8k16 multiplies

// In half precision f g takes three columns, h h' + h l' + l h', and an additive term takes two, h + l.
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

std::string separate_text(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  if (k.asked.kinds.size() != 2)
    throw spec_error(
        {}, fmt::format("--emit=separate is of two operands; '{}' has {}", k.asked.text, k.asked.kinds.size()));
  const auto plural = [](int n, const char *what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  std::string out;
  for (const lower::separated &s : u.shown[kernel].separated) {
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

std::string separate_table(const unit &u) {
  std::size_t width = 6;
  for (const lower::kernel &k : u.kernels)
    width = std::max(width, k.asked.text.size());
  std::string out = fmt::format("{:<{}}  {:<7} {:>5} {:>4} {:>9} {:>9} {:>8} {:>6}\n", "kernel", width, "of", "count",
                                "K", "products", "additive", "columns", "steps");
  for (std::size_t kernel = 0; kernel < u.kernels.size(); ++kernel) {
    const lower::kernel &k = u.kernels[kernel];
    const std::vector<lower::separated> &all = u.shown[kernel].separated;
    if (all.empty())
      out +=
          fmt::format("{:<{}}  {}\n", k.asked.text, width, k.asked.kinds.size() == 2 ? "zero" : "not of two operands");
    // Equal rows of a stage are merged, in the order of first occurrence.
    std::vector<std::pair<std::pair<std::string, std::string>, int>> rows;
    for (const lower::separated &s : all) {
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
