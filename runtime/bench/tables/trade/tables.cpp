#include "meet/bench/tables/trade/tables.hpp"

#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meetc::bench {

namespace {

cell of_length(double x) {
  return {x == 0 ? "0" : std::isfinite(x) ? fmt::format("{:.2g}", x) : "none", app::with_digits(x, 4)};
}

// In percent. Only no part is shown as 0, and only all as 100.
cell of_percent(std::uint64_t part, std::size_t all) {
  const double x = static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(all, 1));
  return {part == 0 ? "0" : fmt::format("{:.3g} %", part < all ? std::min(100 * x, 99.9) : 100),
          app::with_digits(x, 6)};
}

// A method on one family of pairs.
struct row {
  const trade_cell &of;
  const trade_point &point;
  const trade_point *plain; // the rung fp32, beside which times are shown; null: there is none
};

// The method of this name on each family of a predicate.
std::vector<const trade_point *> points_of(const std::vector<trade_cell> &all, const predicate_info *by,
                                           const std::string &method) {
  std::vector<const trade_point *> out;
  for (const trade_cell &c : all)
    if (c.by == by)
      for (const trade_point &p : c.result.points)
        if (p.method.name == method)
          out.push_back(&p);
  return out;
}

// A method without a wrong answer in these pairs is not equal to one that gives none at all.
bool loses(const std::vector<const trade_point *> &one, const std::vector<const trade_point *> &other) {
  if (!one.empty() && one[0]->method.promises_truth() && !other[0]->method.promises_truth())
    return false;
  for (std::size_t f = 0; f < one.size(); ++f)
    if (other[f]->seconds >= one[f]->seconds || other[f]->wrong.differs.wrong() > one[f]->wrong.differs.wrong())
      return false;
  return !one.empty();
}

} // namespace

std::vector<std::string> families_of(const std::vector<trade_cell> &all) {
  std::vector<std::string> out;
  for (const trade_cell &c : all)
    if (std::find(out.begin(), out.end(), c.family) == out.end())
      out.push_back(c.family);
  return out;
}

table table_of_family(const std::string &family, const std::vector<trade_cell> &all) {
  std::string title;
  std::vector<row> rows;
  int repetitions = 0;
  for (const trade_cell &c : all) {
    if (c.family != family)
      continue;
    title = fmt::format("{}: {} pair{} for each predicate", c.in_words, app::grouped(c.pairs), c.pairs == 1 ? "" : "s");
    repetitions = std::max(repetitions, c.result.repetitions);
    const trade_point *plain = nullptr;
    for (const trade_point &p : c.result.points)
      plain = !plain && p.method.precision == rung::fp32 ? &p : plain;
    for (const trade_point &p : c.result.points)
      rows.push_back({c, p, plain});
  }
  const auto proved = [](const row &r) {
    return r.point.wrong.proved              ? of_length(*r.point.wrong.proved)
           : r.point.method.promises_truth() ? of_length(0)
                                             : missing();
  };
  return table_of<row>(
      family, title,
      {{"predicate", "predicate", [](const row &r) { return of_words(r.of.by->name); }},
       {"method", "method", [](const row &r) { return of_words(r.point.method.name); }},
       {"ns", "ns a pair", [](const row &r) { return of_nanoseconds(r.point.seconds); }},
       {"over_fp32", "x fp32",
        [](const row &r) { return r.plain ? of_ratio(r.point.seconds / r.plain->seconds) : missing(); }},
       {"hits", "hits", [](const row &r) { return of_count(r.of.result.hits); }},
       {"false", "false|hits", [](const row &r) { return of_count(r.point.wrong.differs.extra); }},
       {"missed", "missed|hits", [](const row &r) { return of_count(r.point.wrong.differs.missed); }},
       {"wrong", "wrong",
        [](const row &r) {
          return of_percent(r.point.wrong.differs.wrong(), r.point.pairs > 0 ? r.point.pairs : r.of.pairs);
        }},
       {"farthest", "farthest|wrong by", [](const row &r) { return of_length(r.point.wrong.farthest); }},
       {"ulps", "in ulps", [](const row &r) { return of_length(r.point.wrong.farthest_in_ulps); }},
       {"proved", "proved", proved},
       {"unsure", "unsure|in fp32",
        [](const row &r) { return r.point.unsure ? of_percent(*r.point.unsure, r.of.pairs) : missing(""); }}},
      rows, {fmt::format("The median of up to {} interleaved repetitions on one thread.", repetitions)});
}

table table_of_losers(const std::vector<trade_cell> &all) {
  struct loser {
    std::string predicate, method, to;
  };
  std::vector<loser> rows;
  std::vector<const predicate_info *> seen;
  for (const trade_cell &c : all) {
    if (std::find(seen.begin(), seen.end(), c.by) != seen.end())
      continue;
    seen.push_back(c.by);
    const std::vector<trade_method> methods = methods_of(*c.by);
    for (const trade_method &one : methods) {
      std::string to;
      for (const trade_method &other : methods)
        if (other.name != one.name && loses(points_of(all, c.by, one.name), points_of(all, c.by, other.name)))
          to += (to.empty() ? "" : ", ") + other.name;
      if (!to.empty())
        rows.push_back({c.by->name, one.name, to});
    }
  }
  return table_of<loser>("losers", "Methods that lose everywhere",
                         {{"predicate", "predicate", of_words, &loser::predicate},
                          {"method", "method", of_words, &loser::method},
                          {"loses_to", "loses to", of_words, &loser::to}},
                         rows,
                         {"A method loses to another that was faster in every family above and in none more often "
                          "wrong. A method that is never wrong loses only to another that is never wrong."});
}

table table_of_queries(const std::vector<trade_query> &all, int threads) {
  const auto name = [](const trade_query &q) {
    return of_words(fmt::format("{}{}", app::name_of(q.precision), q.device ? ", device" : ""));
  };
  const auto unsure = [](const trade_query &q) {
    return q.precision == rung::certified ? of_count(q.unsure) : missing("");
  };
  return table_of<trade_query>(
      "queries", fmt::format("Whole queries, both sets prepared, {} thread{}", threads, threads == 1 ? "" : "s"),
      {{"scene", "scene", of_words, &trade_query::scene},
       {"rung", "rung", name},
       {"ms", "ms", of_milliseconds, &trade_query::seconds},
       {"over_fp32", "x fp32", of_ratio, &trade_query::over_fp32},
       {"pairs", "pairs", [](const trade_query &q) { return of_count(q.differs.found); }},
       {"candidates", "candidates", of_count, &trade_query::candidates},
       {"false", "false|pairs", [](const trade_query &q) { return of_count(q.differs.extra); }},
       {"missed", "missed|pairs", [](const trade_query &q) { return of_count(q.differs.missed); }},
       {"unsure", "unsure|in fp32", unsure}},
      all, {"Candidates are fewer for exact and certified where segments are tested by more than their boxes."});
}

std::string as_csv(const std::vector<trade_cell> &all) {
  std::string out = "family,predicate,method,pairs,hits,ns_a_pair,false_hits,missed_hits,farthest,farthest_ulps,proved,"
                    "unsure_fp32\n";
  for (const trade_cell &c : all)
    for (const trade_point &p : c.result.points) {
      const wrongness &w = p.wrong;
      out += fmt::format("{},{},\"{}\",{},{},{:.4g},{},{},{:.6g},{:.6g},{},{}\n", c.family, c.by->name, p.method.name,
                         c.pairs, c.result.hits, 1e9 * p.seconds, w.differs.extra, w.differs.missed, w.farthest,
                         w.farthest_in_ulps, w.proved ? fmt::format("{:.6g}", *w.proved) : "",
                         p.unsure ? fmt::format("{}", *p.unsure) : "");
    }
  return out;
}

} // namespace meetc::bench
