#include "meet/bench/tables/trade/cells.hpp"

#include "meet/app/query/choose.hpp"
#include "meet/bench/baselines/paper_way.hpp"
#include "meet/bench/truth/distance.hpp"
#include "meet/bench/truth/proved_distance.hpp"
#include "meet/core/views/pose.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meetc::bench {

namespace {

std::vector<index_pair> row_with_row(std::size_t n) {
  std::vector<index_pair> pairs(n);
  for (std::size_t i = 0; i < n; ++i)
    pairs[i] = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)};
  return pairs;
}

element_pairs on_grid(element_pairs pairs, double grid) {
  pose at;
  at.grid = grid;
  for (std::size_t i = 0; i < pairs.count; ++i) {
    move_rows(*pairs.by->a, at, pairs.a.data() + i * static_cast<std::size_t>(pairs.by->a->fields), 1);
    move_rows(*pairs.by->b, at, pairs.b.data() + i * static_cast<std::size_t>(pairs.by->b->fields), 1);
  }
  return pairs;
}

const float *row(const std::vector<float> &rows, const kind_info &kind, std::size_t i) {
  return rows.data() + i * static_cast<std::size_t>(kind.fields);
}

} // namespace

std::vector<trade_method> methods_of(const predicate_info &p) {
  std::vector<trade_method> out;
  if (const decide_function paper = paper_way(p.name))
    out.push_back({"paper, fp32", paper, {}});
  for (int r = 0; r < rung_count; ++r)
    if (pair_decider decide = decider_of(p, static_cast<rung>(r)))
      out.push_back({app::name_of(static_cast<rung>(r)), std::move(decide), static_cast<rung>(r)});
  return out;
}

std::vector<answer> decide_all(const element_pairs &pairs, const pair_decider &decide) {
  std::vector<answer> out(pairs.count);
  const std::vector<index_pair> list = row_with_row(pairs.count);
  decide(pairs.a.data(), pairs.b.data(), list.data(), list.size(), out.data());
  return out;
}

wrongness wrongness_of(const element_pairs &pairs, const trade_method &method, const std::vector<answer> &given,
                       const std::vector<answer> &exact) {
  const predicate_info &p = *pairs.by;
  wrongness w;
  w.differs = difference_of(given, exact);
  const proved_distance proved = method.precision ? proved_distance_of(p.name, *method.precision) : nullptr;
  if (method.grid > 0)
    w.proved = moved_by_grid(p, method.grid);
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const float *const a = row(pairs.a, *p.a, i), *const b = row(pairs.b, *p.b, i);
    if (proved)
      w.proved = std::max(w.proved.value_or(0), proved(a, b));
    if (given[i] == exact[i])
      continue;
    const double far = distance_from_change(p, a, b, exact[i] == answer::yes);
    w.farthest = std::max(w.farthest, far);
    w.farthest_in_ulps = std::max(w.farthest_in_ulps, far / ulp_of_pair(p, a, b));
  }
  return w;
}

trade_result measure_trade(const element_pairs &pairs, const turns &how, double tolerance) {
  const predicate_info &p = *pairs.by;
  std::vector<trade_method> all = methods_of(p);
  const pair_decider certified = decider_of(p, rung::certified);
  const double grid = certified ? grid_within(p, tolerance) : 0;
  element_pairs rounded;
  if (grid > 0) {
    all.push_back({"certified, rounded", certified, {}, grid});
    rounded = on_grid(pairs, grid);
  }
  const std::vector<index_pair> list = row_with_row(pairs.count);
  const std::vector<answer> exact = decide_all(pairs, p.decide[static_cast<int>(rung::exact)]);
  std::vector<std::vector<answer>> given(all.size(), std::vector<answer>(pairs.count));
  std::vector<method> methods;
  for (std::size_t m = 0; m < all.size(); ++m) {
    const auto run = [&, m] {
      const element_pairs &of = all[m].grid > 0 ? rounded : pairs;
      all[m].decide(of.a.data(), of.b.data(), list.data(), list.size(), given[m].data());
    };
    methods.push_back({all[m].name, all[m].promises_truth(), {run}, [&, m] { return difference_of(given[m], exact); }});
  }
  host_clock clock(1);
  const measured_methods timed = measure(fmt::format("trade: {}", p.name), clock, methods, how);
  trade_result out{
      {}, static_cast<std::uint64_t>(std::count(exact.begin(), exact.end(), answer::yes)), timed.repetitions};
  const auto each = static_cast<double>(std::max<std::size_t>(pairs.count, 1));
  for (std::size_t m = 0; m < all.size(); ++m) {
    trade_point point{all[m], timed.of[m].seconds[0] / each, wrongness_of(pairs, all[m], given[m], exact)};
    if (all[m].precision == rung::certified && p.certify[0]) {
      const std::vector<answer> first = decide_all(pairs, p.certify[0]);
      point.unsure = static_cast<std::uint64_t>(std::count(first.begin(), first.end(), answer::unsure));
    }
    out.points.push_back(std::move(point));
  }
  return out;
}

} // namespace meetc::bench
