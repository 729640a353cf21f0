// The operations of kernels as a table.
#include "gen/target/text/text.hpp"

#include "gen/ir/count.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

// Scalings by powers of two and negations have columns of their own.
std::string row(const std::string &kernel, std::size_t width, const std::string &program, const std::string &all,
                const std::string &a, const std::string &b, const std::string &pair, const std::string &scalings,
                const std::string &negations) {
  return fmt::format("{:<{}}  {:<19} {:>8} {:>8} {:>8} {:>8} {:>9} {:>9}\n", kernel, width, program, all, a, b, pair,
                     scalings, negations);
}

std::string rows(const lower::kernel &k, std::size_t width) {
  std::string out;
  lower::kernel copy = k; // programs() returns references that passes may replace
  for (const lower::kernel_program &p : lower::programs(copy)) {
    const auto part = [&](poly::residency where) { return ir::mul_add(ir::count(*p.code, where)); };
    const ir::counts all = ir::count(p.code->nodes, p.code->results);
    out += row(k.asked.text, width, p.title, ir::mul_add(all), part(poly::residency::a), part(poly::residency::b),
               part(poly::residency::pair), std::to_string(all.scalings), std::to_string(all.negations));
  }
  return out.empty() ? fmt::format("{:<{}}  zero\n", k.asked.text, width) : out;
}

std::string table(const std::vector<const lower::kernel *> &kernels) {
  std::size_t width = 6;
  for (const lower::kernel *k : kernels)
    width = std::max(width, k->asked.text.size());
  std::string out = row("kernel", width, "program", "whole", "A alone", "B alone", "pair", "scalings", "negations");
  for (const lower::kernel *k : kernels)
    out += rows(*k, width);
  return out;
}

} // namespace

std::string counts_text(const unit &u, std::size_t kernel) {
  return table({&u.kernels[kernel]});
}

std::string counts_table(const unit &u) {
  std::vector<const lower::kernel *> all;
  for (const lower::kernel &k : u.kernels)
    all.push_back(&k);
  return table(all);
}

} // namespace meetc::target
