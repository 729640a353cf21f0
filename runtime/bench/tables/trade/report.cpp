#include "bench/tables/trade/report.hpp"

#include "app/choose.hpp"
#include "app/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace meetc::bench {

namespace {

cell of_length(double x) {
  return {x == 0 ? "0" : std::isfinite(x) ? fmt::format("{:.2g}", x) : "none", app::with_digits(x, 4)};
}

double share(std::uint64_t part, std::size_t all) {
  return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(all, 1));
}

// In percent. Only no part is shown as 0, and only all as 100.
cell of_percent(std::uint64_t part, std::size_t all) {
  const double x = share(part, all);
  return {part == 0 ? "0" : fmt::format("{:.3g} %", part < all ? std::min(100 * x, 99.9) : 100),
          app::with_digits(x, 6)};
}

// The plain fp32 rung, beside which times are shown.
const trade_point *plain(const trade_cell &c) {
  for (const trade_point &p : c.result.points)
    if (p.method.precision == rung::fp32)
      return &p;
  return nullptr;
}

std::vector<const predicate_info *> predicates_of(const std::vector<trade_cell> &all) {
  std::vector<const predicate_info *> out;
  for (const trade_cell &c : all)
    if (std::find(out.begin(), out.end(), c.by) == out.end())
      out.push_back(c.by);
  return out;
}

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

std::uint64_t wrong(const trade_point &p) {
  return p.wrong.false_hits + p.wrong.missed;
}

bool is_never_wrong(const trade_method &m) {
  return m.precision && never_wrong(*m.precision);
}

// That no wrong answer was seen does not make a method equal to one that gives none.
bool loses(const std::vector<const trade_point *> &one, const std::vector<const trade_point *> &other) {
  if (!one.empty() && is_never_wrong(one[0]->method) && !is_never_wrong(other[0]->method))
    return false;
  for (std::size_t f = 0; f < one.size(); ++f)
    if (other[f]->seconds >= one[f]->seconds || wrong(*other[f]) > wrong(*one[f]))
      return false;
  return !one.empty();
}

} // namespace

table table_of(const std::string &family, const std::vector<trade_cell> &all) {
  table t{family,
          "",
          {{"predicate", "predicate"},
           {"method", "method"},
           {"ns", "ns a pair"},
           {"over_fp32", "x fp32"},
           {"hits", "hits"},
           {"false", "false|hits"},
           {"missed", "missed|hits"},
           {"wrong", "wrong"},
           {"farthest", "farthest|wrong by"},
           {"ulps", "in ulps"},
           {"proved", "proved"},
           {"unsure", "unsure|in fp32"}},
          {},
          {}};
  int repetitions = 0;
  for (const trade_cell &c : all) {
    if (c.family != family)
      continue;
    t.title =
        fmt::format("{}: {} pair{} for each predicate", c.in_words, app::grouped(c.pairs), c.pairs == 1 ? "" : "s");
    repetitions = std::max(repetitions, c.result.repetitions);
    const trade_point *const base = plain(c);
    for (const trade_point &p : c.result.points)
      t.rows.push_back({of_words(c.by->name), of_words(p.method.name), of_nanoseconds(p.seconds),
                        base ? of_ratio(p.seconds / base->seconds) : missing("-"), of_count(c.result.hits),
                        of_count(p.wrong.false_hits), of_count(p.wrong.missed),
                        of_percent(wrong(p), p.pairs > 0 ? p.pairs : c.pairs), of_length(p.wrong.farthest),
                        of_length(p.wrong.farthest_in_ulps),
                        p.wrong.proved             ? of_length(*p.wrong.proved)
                        : is_never_wrong(p.method) ? of_length(0)
                                                   : missing("-"),
                        p.unsure ? of_percent(*p.unsure, c.pairs) : missing("")});
  }
  t.notes.push_back(fmt::format("The lower quartile of up to {} interleaved repetitions on one thread.", repetitions));
  return t;
}

table losers_of(const std::vector<trade_cell> &all) {
  table t{"losers",
          "Methods that lose everywhere",
          {{"predicate", "predicate"}, {"method", "method"}, {"loses_to", "loses to"}},
          {},
          {"A method loses to another that was faster in every family above and in none more often wrong. What is "
           "never wrong "
           "loses only to what is never wrong either."}};
  for (const predicate_info *by : predicates_of(all)) {
    const std::vector<trade_method> methods = methods_of(*by);
    for (const trade_method &one : methods) {
      std::string to;
      for (const trade_method &other : methods)
        if (other.name != one.name && loses(points_of(all, by, one.name), points_of(all, by, other.name)))
          to += (to.empty() ? "" : ", ") + other.name;
      if (!to.empty())
        t.rows.push_back({of_words(by->name), of_words(one.name), of_words(to)});
    }
  }
  return t;
}

table table_of(const std::vector<trade_query> &all, int threads) {
  table t{"queries",
          fmt::format("Whole queries, both sets prepared, {} thread{}", threads, threads == 1 ? "" : "s"),
          {{"scene", "scene"},
           {"rung", "rung"},
           {"ms", "ms"},
           {"over_fp32", "x fp32"},
           {"pairs", "pairs"},
           {"candidates", "candidates"},
           {"false", "false|pairs"},
           {"missed", "missed|pairs"},
           {"unsure", "unsure|in fp32"}},
          {},
          {"Candidates are fewer for exact and certified where segments are tested by more than their boxes."}};
  double plain_seconds = NAN;
  std::string scene;
  for (const trade_query &q : all) {
    if (q.scene != scene)
      plain_seconds = q.precision == rung::fp32 && !q.device ? q.seconds : NAN;
    scene = q.scene;
    t.rows.push_back(
        {of_words(q.scene),
         of_words(q.device ? fmt::format("{}, device", app::name_of(q.precision)) : app::name_of(q.precision)),
         of_milliseconds(q.seconds), of_ratio(q.seconds / plain_seconds), of_count(q.pairs), of_count(q.candidates),
         of_count(q.false_hits), of_count(q.missed),
         q.precision == rung::certified ? of_count(q.unsure) : missing("")});
  }
  return t;
}

std::string as_csv(const std::vector<trade_cell> &all) {
  std::string out = "family,predicate,method,pairs,hits,ns_a_pair,false_hits,missed_hits,farthest,farthest_ulps,proved,"
                    "unsure_fp32\n";
  for (const trade_cell &c : all)
    for (const trade_point &p : c.result.points)
      out += fmt::format("{},{},\"{}\",{},{},{:.4g},{},{},{:.6g},{:.6g},{},{}\n", c.family, c.by->name, p.method.name,
                         c.pairs, c.result.hits, 1e9 * p.seconds, p.wrong.false_hits, p.wrong.missed, p.wrong.farthest,
                         p.wrong.farthest_in_ulps, p.wrong.proved ? fmt::format("{:.6g}", *p.wrong.proved) : "",
                         p.unsure ? fmt::format("{}", *p.unsure) : "");
  return out;
}

} // namespace meetc::bench
