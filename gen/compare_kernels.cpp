#include "gen/compare_kernels.hpp"

#include "gen/formula_costs.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace meetc {
namespace {

// The widest factor of the signs of all stages. Empty: no rung of the scene needs bounds.
std::string widest(bound::kernel_bounds b) {
  bound::rational most = 0;
  for (const bound::stage_bounds *s : b.stages())
    for (const bound::roundings &r : s->fp32)
      most = std::max(most, bound::factor(bound::fp32, r));
  return fmt::format("{:.1f}", bound::rational(most / bound::power_of_two(-24)).get_d());
}

kernel_figures figures_of(const lower::kernel &k, const std::optional<bound::kernel_bounds> &bounds) {
  kernel_figures out{k.asked.text, {}, {}, {}};
  if (!k.is_predicate) {
    out.operations = ir::mul_add(cheapest(k.value));
    return out;
  }
  lower::kernel copy = k; // programs() returns references that passes may replace
  ir::counts sum;
  for (const lower::kernel_program &p : lower::programs(copy))
    if (p.as != lower::use::once || k.is_sign) {
      const ir::counts c = ir::count_pair(*p.code);
      sum.multiplications += c.multiplications, sum.additions += c.additions, sum.fused += c.fused;
    }
  std::set<int> atoms;
  for (const lower::stage *s : lower::stages(k.decision))
    atoms.insert(s->atoms.begin(), s->atoms.end());
  out.operations = ir::mul_add(sum);
  out.atoms = fmt::format("{}", atoms.size());
  if (bounds)
    out.bound = widest(*bounds);
  return out;
}

} // namespace

std::vector<kernel_figures> kernel_figures_of(const compilation &c) {
  std::vector<kernel_figures> out;
  for (std::size_t i = 0; i < c.kernels.size(); ++i)
    out.push_back(figures_of(c.kernels[i], c.bounds[i]));
  return out;
}

std::vector<std::vector<std::string>> kernel_rows(const std::vector<std::string> &scenes,
                                                  const std::vector<std::vector<kernel_figures>> &all) {
  std::vector<std::vector<std::string>> rows{{"kernel"}};
  std::map<std::string, std::size_t> row_of;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const char *column : {"mul/add", "atoms", "bound"})
      rows[0].push_back(fmt::format("{}: {}", scenes[i], column));
    for (const kernel_figures &k : all[i])
      if (row_of.try_emplace(k.name, rows.size()).second)
        rows.push_back({k.name});
  }
  for (const std::vector<kernel_figures> &scene : all) {
    const std::size_t width = rows[0].size() - 3 * static_cast<std::size_t>(&all.back() - &scene);
    for (const kernel_figures &k : scene)
      for (const std::string &cell : {k.operations, k.atoms, k.bound})
        rows[row_of.at(k.name)].push_back(cell.empty() ? "-" : cell);
    for (std::vector<std::string> &row : rows)
      row.resize(std::max(row.size(), width), "-");
  }
  return rows;
}

} // namespace meetc
