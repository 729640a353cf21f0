#include "meet/bench/scenes/many_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meetc::bench {
namespace {

const kind_info &triangle_of(const catalogue &all) {
  return *std::find_if(all.kinds, all.kinds + all.kind_count, [](const kind_info &k) { return k.points == 3; });
}

} // namespace

many_bodies::many_bodies(const catalogue &all, std::size_t count, int threads)
    : shape_(bodies::torus(50, 50)), bodies_(all), range_(1.5 * std::cbrt(static_cast<double>(count))) {
  own_ = std::make_shared<prepared>(prepare(faces(), triangle_of(all), {}, threads));
  for (std::size_t i = 0; i < count; ++i)
    bodies_.add(fmt::format("body {}", i), own_, drawn());
}

void many_bodies::move_all() {
  for (std::uint32_t i = 0; i < count(); ++i)
    bodies_.move(i, drawn());
}

pose many_bodies::drawn() {
  const auto uniform = [this](double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(random_()) * 0x1p-32);
  };
  const double t = uniform(-1, 1), c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
  const double x = uniform(-range_, range_), y = uniform(-range_, range_), z = uniform(-range_, range_);
  const double m[12] = {c, 0, s, x, 0, 1, 0, y, -s, 0, c, z};
  pose p;
  std::copy_n(m, 12, p.m);
  return p;
}

std::vector<index_pair> touching_pairs(const world_answer &found) {
  std::vector<index_pair> out;
  for (const touching_bodies &t : found.touching)
    out.insert(out.end(), t.found.count, {t.a, t.b});
  return out;
}

} // namespace meetc::bench
