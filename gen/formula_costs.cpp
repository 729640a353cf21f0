#include "gen/formula_costs.hpp"

#include "gen/columns.hpp"
#include "gen/lang/toml_reader.hpp"
#include "gen/lower/expand/stored_numbers.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc {
ir::counts cheapest(const lower::formula &f) {
  const ir::counts by_blades = ir::count(f.from_blades.nodes, f.from_blades.results);
  if (!f.stored_numbers)
    return by_blades;
  const ir::counts by_stored = ir::count(f.from_stored.nodes, f.from_stored.results);
  return by_stored.total() < by_blades.total() ? by_stored : by_blades;
}

published_counts read_published(const std::string &path) {
  const lang::toml_reader in(path);
  in.allow(in.root(), "a file of counts", {"generators", "counts"});
  published_counts out;
  if (const toml::node *names = in.root().get("generators"))
    out.generators = in.as_strings(*names, "'generators'");
  if (out.generators.empty())
    throw spec_error({in.file(), 0, 1}, "a file of counts names its 'generators'");
  if (const toml::node *counts = in.root().get("counts"))
    for (const auto &[key, node] : in.in_file_order(in.as_table(*counts, "'counts'"))) {
      const std::vector<std::string> of = in.as_strings(*node, "counts");
      if (of.size() != out.generators.size())
        throw spec_error(in.place(*node),
                         fmt::format("there are {} generators and {} counts", out.generators.size(), of.size()));
      out.of.emplace(key->str(), of);
      out.where.emplace(key->str(), in.place(*key));
    }
  return out;
}

std::vector<formula_cost> formula_costs(const compilation &c) {
  std::vector<formula_cost> out;
  for (const lower::kernel &k : c.kernels) {
    if (k.is_predicate)
      continue;
    const lower::formula &f = k.value;
    const int stored = lower::stored_numbers(*c.model, k.asked.names, k.asked.kinds).numbers->size();
    out.push_back(
        {k.asked.text, cheapest(f), {}, sizeof(float) * (static_cast<std::size_t>(stored) + f.result.size())});
    if (!f.prepared.results.empty())
      out.back().per_object = ir::count(f.prepared, poly::residency::pair);
  }
  return out;
}

std::string formula_table(const std::vector<formula_cost> &costs, const std::map<std::string, double> &nanoseconds,
                          const published_counts &beside) {
  std::vector<std::vector<std::string>> rows{{"formula", "mul/add", "scalings", "prepared", "bytes"}};
  if (!nanoseconds.empty())
    rows[0].emplace_back("ns");
  rows[0].insert(rows[0].end(), beside.generators.begin(), beside.generators.end());
  for (const formula_cost &f : costs) {
    std::vector<std::string> row{f.text, ir::mul_add(f.whole), fmt::format("{}", f.whole.scalings),
                                 f.per_object ? ir::mul_add(*f.per_object) : "-", fmt::format("{}", f.bytes)};
    if (!nanoseconds.empty()) {
      const auto it = nanoseconds.find(f.text);
      row.push_back(it == nanoseconds.end() ? "-" : fmt::format("{:.2f}", it->second));
    }
    const auto it = beside.of.find(f.text);
    for (std::size_t i = 0; i < beside.generators.size(); ++i)
      row.push_back(it == beside.of.end() || it->second[i].empty() ? "-" : it->second[i]);
    rows.push_back(std::move(row));
  }
  return in_columns(rows, false);
}

void require_asked(const published_counts &beside, const std::vector<formula_cost> &costs) {
  for (const auto &[text, at] : beside.where)
    if (std::none_of(costs.begin(), costs.end(), [&](const formula_cost &f) { return f.text == text; }))
      throw spec_error(at, fmt::format("no scene asks for '{}'", text));
}

} // namespace meetc
