#include "bench/tables/trade/maps.hpp"

#include "app/choose.hpp"
#include "bench/harness/gnuplot.hpp"
#include "bench/scenes/trade_families.hpp"
#include "bench/tables/trade/measure.hpp"
#include "bench/truth/distance.hpp"
#include "bench/truth/proved_distance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace meetc::bench {

namespace {

constexpr int bits_step = 4;
constexpr std::array wrong_rungs{rung::fp32, rung::fp64, rung::fp64x2};
constexpr std::array unsure_rungs{rung::fp32, rung::fp64};

struct column {
  std::string label;
  int scale;
  double offset;
};

// Scales from about 1e-38 to 4e37; offsets from 0 to 1e7 sizes.
std::vector<column> columns_of(trade_maps::axis across) {
  std::vector<column> out;
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
    const float *const a = pairs.a.data() + i * static_cast<std::size_t>(p.a->fields), *const b =
                                                                                           pairs.b.data() +
                                                                                           i * static_cast<std::size_t>(
                                                                                                   p.b->fields);
    const double seen = distance_from_change(p, a, b, exact[i] == answer::yes), limit = proved(a, b);
    most = std::max(most, limit > 0 ? seen / limit : seen > 0 ? HUGE_VAL : 0);
  }
  return most;
}

} // namespace

trade_maps map_trade(const predicate_info &p, trade_maps::axis across, std::size_t n) {
  trade_maps out;
  out.across = across;
  const std::vector<column> columns = columns_of(across);
  for (const column &c : columns)
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
    for (const column &c : columns) {
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

void draw_maps(const std::filesystem::path &to, const std::string &title, const std::vector<trade_maps> &all) {
  constexpr int panel_width = 330, panel_height = 300, head = 50;
  std::size_t most = 0;
  for (const trade_maps &m : all)
    most = std::max(most, m.maps.size());
  std::string script =
      fmt::format("set encoding utf8\n"
                  "set terminal pngcairo noenhanced size {},{} background '#fcfcfb' font 'Sans,9'\n"
                  "set multiplot layout {},{} title {}\n",
                  panel_width * static_cast<int>(most), head + panel_height * static_cast<int>(all.size()), all.size(),
                  most, gnuplot_string(title));
  script +=
      "set palette defined (0 '#f2f5f7', 0.001 '#cfe3f1', 0.05 '#8ab6d9', 0.25 '#f0c36a', 0.6 '#d9693a', 1 '#8e1b2c')\n"
      "set cbrange [0:100]\nset format cb '%g %%'\nset tics out nomirror\nset border 3\nunset key\n";
  for (const trade_maps &m : all)
    for (std::size_t k = 0; k < most; ++k) {
      if (k >= m.maps.size()) {
        script += "set multiplot next\n";
        continue;
      }
      const trade_map &map = m.maps[k];
      std::string ticks;
      const std::size_t every = m.columns.size() / 4 + 1;
      for (std::size_t c = 0; c < m.columns.size(); c += every)
        ticks += fmt::format("{}'{}' {}", ticks.empty() ? "" : ", ", m.columns[c], c);
      script += fmt::format("set title '{} {}'\nset xlabel '{}'\nset ylabel 'nearness to a contact, bits'\n"
                            "set xtics ({})\nset xrange [-0.5:{}]\nset yrange [{}:{}]\nset ytics 12\n$map << END\n",
                            map.unsure ? "unsure in bounded" : "wrong in plain", map.rung,
                            m.across == trade_maps::axis::scale ? "scale" : "distance from the origin, in sizes", ticks,
                            static_cast<double>(m.columns.size()) - 0.5, -bits_step / 2, nearest_bits + bits_step / 2);
      for (std::size_t i = 0; i < map.share.size(); ++i)
        script += fmt::format("{} {} {:.4f}\n", i % m.columns.size(), m.bits[i / m.columns.size()], 100 * map.share[i]);
      script += "END\nplot $map using 1:2:3 with image\n";
    }
  run_gnuplot(script + "unset multiplot\n", to);
}

} // namespace meetc::bench
