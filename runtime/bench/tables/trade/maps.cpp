#include "meet/bench/tables/trade/maps.hpp"

#include "meet/app/query/choose.hpp"
#include "meet/bench/scenes/trade_families.hpp"
#include "meet/bench/tables/trade/cells.hpp"
#include "meet/bench/truth/distance.hpp"
#include "meet/bench/truth/proved_distance.hpp"
#include "meet/picture/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace meetc::bench {

namespace {

constexpr int bits_step = 4;
constexpr std::array wrong_rungs{rung::fp32, rung::fp64, rung::fp64x2};
constexpr std::array unsure_rungs{rung::fp32, rung::fp64};

struct map_column {
  std::string label;
  int scale;
  double offset;
};

// Scales from about 1e-38 to 4e37; offsets from 0 to 1e7 sizes.
std::vector<map_column> columns_of(trade_maps::axis across) {
  std::vector<map_column> out;
  if (across == trade_maps::axis::scale) {
    constexpr int least = -126, most = 125, step = 12;
    for (int scale = least; scale <= most; scale += step)
      out.push_back({fmt::format("1e{:.0f}", scale * std::log10(2.0)), scale, 0});
  } else {
    constexpr int most = 7;
    out.push_back({"0", 0, 0});
    for (int power = 0; power <= most; ++power)
      out.push_back({fmt::format("1e{}", power), 0, std::pow(10.0, power)});
  }
  return out;
}

double share(std::size_t part, std::size_t all) {
  return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(all, 1));
}

// The largest share of the proved distance among the wrong answers of a cell.
double seen_share(const element_pairs &pairs, rung precision, const std::vector<answer> &given,
                  const std::vector<answer> &exact) {
  const proved_distance proved = proved_distance_of(pairs.by->name, precision);
  if (!proved)
    return 0;
  double most = 0;
  const predicate_info &p = *pairs.by;
  for (std::size_t i = 0; i < pairs.count; ++i) {
    if (given[i] == exact[i])
      continue;
    const float *const a = pairs.a.data() + i * static_cast<std::size_t>(p.a->fields);
    const float *const b = pairs.b.data() + i * static_cast<std::size_t>(p.b->fields);
    const double seen = distance_from_change(p, a, b, exact[i] == answer::yes), limit = proved(a, b);
    most = std::max(most, limit > 0 ? seen / limit : seen > 0 ? HUGE_VAL : 0);
  }
  return most;
}

} // namespace

trade_maps map_trade(const predicate_info &p, trade_maps::axis across, std::size_t n) {
  trade_maps out;
  out.across = across;
  const std::vector<map_column> columns = columns_of(across);
  for (const map_column &c : columns)
    out.columns.push_back(c.label);
  for (int bits = 0; bits <= nearest_bits; bits += bits_step)
    out.bits.push_back(bits);
  for (const rung r : wrong_rungs)
    if (p.decide[static_cast<int>(r)])
      out.maps.push_back({app::name_of(r), false, {}});
  for (const rung r : unsure_rungs)
    if (p.certify[static_cast<int>(r)])
      out.maps.push_back({app::name_of(r), true, {}});
  std::uint64_t seed = 0;
  for (const int bits : out.bits)
    for (const map_column &c : columns) {
      const element_pairs pairs = make_pairs(p, n, {c.scale, c.offset, true, bits, bits}, ++seed);
      const std::vector<answer> exact = decide_all(pairs, p.decide[static_cast<int>(rung::exact)]);
      for (trade_map &m : out.maps) {
        const rung r = app::precision_named(m.rung);
        const std::vector<answer> given =
            decide_all(pairs, m.unsure ? p.certify[static_cast<int>(r)] : p.decide[static_cast<int>(r)]);
        std::size_t count = 0;
        for (std::size_t i = 0; i < n; ++i)
          count += m.unsure ? given[i] == answer::unsure : given[i] != exact[i];
        m.share.push_back(share(count, n));
        if (!m.unsure)
          out.seen_of_proved = std::max(out.seen_of_proved, seen_share(pairs, r, given, exact));
      }
    }
  return out;
}

plot plot_of_maps(const std::string &title, const std::vector<trade_maps> &all) {
  std::vector<std::string> titles, words, ticks, widths, shares;
  for (const trade_maps &m : all)
    for (const trade_map &map : m.maps) {
      titles.push_back(fmt::format("{} {}", map.unsure ? "unsure in bounded" : "wrong in plain", map.rung));
      words.emplace_back(m.across == trade_maps::axis::scale ? "scale" : "distance from the origin, in sizes");
      widths.push_back(fmt::format("{}", m.columns.size()));
      ticks.emplace_back(), shares.emplace_back();
      for (std::size_t c = 0; c < m.columns.size(); c += m.columns.size() / 4 + 1)
        ticks.back() += fmt::format("{}\"{}\" {}", c == 0 ? "" : ", ", m.columns[c], c);
      for (std::size_t i = 0; i < map.share.size(); ++i)
        shares.back() +=
            fmt::format("{} {} {:.4f}\n", i % m.columns.size(), m.bits[i / m.columns.size()], 100 * map.share[i]);
    }
  std::string stops;
  for (const picture::palette::stop &s : picture::palette::shares)
    stops += fmt::format("{}{} '{}'", stops.empty() ? "" : ", ", s.at, picture::hexadecimal(s.ink));
  plot out("maps");
  out.set("stops", stops);
  out.set("words", title).set("rows", static_cast<double>(all.size()));
  out.set("across", static_cast<double>(titles.size() / std::max<std::size_t>(all.size(), 1)));
  out.list("titles", titles).list("x_words", words).list("ticks", ticks).list("columns", widths);
  out.set("low", -bits_step / 2).set("high", nearest_bits + bits_step / 2).data("shares", shares);
  return out;
}

} // namespace meetc::bench
