#include "gen/poly/modulo.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

namespace meetc::poly {
namespace {

constexpr int most_random = 12;                         // steps in a row that do not shorten
constexpr std::int64_t largest = std::int64_t{1} << 36; // coefficient; those of a relation are below 2^24

using move = std::tuple<std::size_t, product_of, std::int64_t>; // relation, multiplier, factor

// The moves that cancel a term of p with a term of highest degree of a relation.
std::vector<move> moves(const packed &p, const std::vector<packed> &relations) {
  std::vector<move> out;
  const int highest = degree(p);
  for (std::size_t r = 0; r < relations.size(); ++r) {
    const int top = degree(relations[r]);
    for (const packed_term &q : relations[r]) {
      if (degree(q.of) != top)
        continue;
      for (const packed_term &t : p)
        if (degree(t.of) <= highest && divides(q.of, t.of) && t.coefficient % q.coefficient == 0)
          out.emplace_back(r, divided(t.of, q.of), t.coefficient / q.coefficient);
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

} // namespace

packed subtracted(const packed &p, const packed &q, product_of multiplier, std::int64_t factor) {
  std::vector<packed_term> all = p;
  for (const packed_term &t : q)
    all.push_back({times(t.of, multiplier), -factor * t.coefficient});
  return joined(std::move(all));
}

reduced shortened(const packed &p, const std::vector<packed> &relations, unsigned seed) {
  reduced best{p, {}};
  packed at = p;
  std::map<std::pair<std::size_t, product_of>, std::int64_t> taken;
  std::mt19937 random(seed);
  const auto fits = [&](const move &m) {
    return degree(relations[std::get<0>(m)]) + degree(std::get<1>(m)) <= most_factors;
  };
  for (int idle = 0; idle <= (seed ? most_random : 0);) {
    struct option {
      move by;
      packed result;
    };
    std::vector<option> options;
    for (const move &m : moves(at, relations)) {
      if (!fits(m))
        continue;
      packed next = subtracted(at, relations[std::get<0>(m)], std::get<1>(m), std::get<2>(m));
      if (next.size() <= at.size() &&
          std::all_of(next.begin(), next.end(), [](const packed_term &t) { return std::abs(t.coefficient) < largest; }))
        options.push_back({m, std::move(next)});
    }
    if (options.empty())
      break;
    const auto shorter = [](const option &x, const option &y) { return x.result.size() < y.result.size(); };
    const auto shortest = std::min_element(options.begin(), options.end(), shorter);
    option *chosen = &*shortest;
    if (shortest->result.size() == at.size()) {
      if (!seed)
        break;
      chosen = &options[random() % options.size()];
    } else if (seed) {
      // A random one of those that shorten.
      std::vector<option *> good;
      for (option &o : options)
        if (o.result.size() < at.size())
          good.push_back(&o);
      chosen = good[random() % good.size()];
    }
    at = std::move(chosen->result);
    taken[{std::get<0>(chosen->by), std::get<1>(chosen->by)}] += std::get<2>(chosen->by);
    ++idle;
    if (at.size() < best.of.size()) {
      idle = 0;
      best.of = at;
      best.steps.clear();
      for (const auto &[by, c] : taken)
        if (c != 0)
          best.steps.push_back({by.first, by.second, c});
    }
  }
  return best;
}

} // namespace meetc::poly
