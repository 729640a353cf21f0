#include "gen/poly/scheme.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <tuple>

namespace meetc::poly {
namespace {
constexpr std::size_t most_tried = 9; // terms of a sum of which only the most frequent variable is tried
}

bool is_power_of_two(std::int64_t c) {
  return std::has_single_bit(static_cast<std::uint64_t>(std::abs(c)));
}

std::pair<packed, packed> odd_and_even(const packed &p) {
  std::pair<packed, packed> out;
  for (const packed_term &t : p)
    (t.coefficient % 2 ? out.first : out.second).push_back(t);
  return out;
}

int scheme_table::value(const packed &definition) {
  const auto [it, fresh] = values_.try_emplace(definition, static_cast<int>(ranks_.size()));
  if (fresh)
    ranks_.push_back(rank(definition));
  return it->second;
}

int scheme_table::rank(product_of f) const {
  int out = 0;
  for (; f != 0; f = rest_of(f))
    out |= rank(first_factor(f));
  return out;
}
int scheme_table::rank(const packed &p) const {
  int out = 0;
  for (const packed_term &t : p)
    out |= rank(t.of);
  return out;
}

long scheme_table::product_cost(const packed_term &t) const {
  long out = 0;
  int all = 0, parts = 0, of_pair = 0;
  std::array<int, 4> count{};
  for (product_of f = t.of; f != 0; f = rest_of(f)) {
    const int r = rank(first_factor(f));
    ++count[static_cast<std::size_t>(r)];
    all |= r;
  }
  // The factors of one object are joined first.
  for (int r = 0; r < 3; ++r)
    if (const int n = count[static_cast<std::size_t>(r)]) {
      out += (n - 1) * unit(r);
      ++parts;
    }
  of_pair = parts + count[3];
  out += of_pair > 1 ? (of_pair - 1) * unit(all) : 0;
  return out + (is_power_of_two(t.coefficient) ? 0 : unit(all));
}

long scheme_table::terms_cost(const packed &p) const {
  long out = 0;
  std::array<int, 4> parts{};
  for (const packed_term &t : p) {
    out += product_cost(t);
    ++parts[static_cast<std::size_t>(rank(t.of))];
  }
  int joined = parts[3];
  for (std::size_t r = 0; r < 3; ++r)
    if (parts[r] > 0) {
      out += (parts[r] - 1) * unit(static_cast<int>(r));
      ++joined;
    }
  return out + (joined - 1) * unit(rank(p));
}

// The variables in two or more terms; of a sum with `all_below` terms or more only the most frequent, and of these the one
// that belongs to most.
std::vector<int> scheme_table::most_frequent(const packed &p, std::size_t all_below) const {
  std::vector<std::pair<int, int>> counts; // by variable
  for (const packed_term &t : p) {
    int last = -1;
    for (product_of f = t.of; f != 0; f = rest_of(f)) {
      const int v = first_factor(f);
      if (v == last)
        continue;
      last = v;
      const auto it = std::find_if(counts.begin(), counts.end(), [&](const auto &c) { return c.first == v; });
      if (it == counts.end())
        counts.emplace_back(v, 1);
      else
        ++it->second;
    }
  }
  std::erase_if(counts, [](const auto &c) { return c.second < 2; });
  std::sort(counts.begin(), counts.end(), [&](const auto &x, const auto &y) {
    return std::tuple(-x.second, -rank(x.first), x.first) < std::tuple(-y.second, -rank(y.first), y.first);
  });
  if (p.size() >= all_below && counts.size() > 1)
    counts.erase(counts.begin() + 1, counts.end());
  std::vector<int> out;
  for (const auto &c : counts)
    out.push_back(c.first);
  return out;
}

long scheme_table::estimate(const packed &p) const {
  if (p.empty())
    return 0;
  if (p.size() == 1)
    return product_cost(p[0]);
  const std::int64_t g = content(p);
  if (!is_power_of_two(g))
    return estimate(divided(p, g)) + unit(rank(p));
  const std::vector<int> v = most_frequent(p, 0);
  if (v.empty())
    return terms_cost(p);
  const packed inside = quotient(p, factor(v[0])), outside = remainder(p, factor(v[0]));
  return estimate(inside) + unit(rank(v[0]) | rank(inside)) + estimate(outside) + (outside.empty() ? 0 : unit(rank(p)));
}

scheme_table::step scheme_table::best_step(const packed &p) {
  step best;
  best.cost = terms_cost(p);
  for (const int v : most_frequent(p, most_tried)) {
    const packed inside = quotient(p, factor(v)), outside = remainder(p, factor(v));
    const long c = cost(inside) + unit(rank(v) | rank(inside)) + cost(outside) + (outside.empty() ? 0 : unit(rank(p)));
    if (c < best.cost)
      best = {step::type::take_out, v, c};
  }
  if (const auto [odd, even] = odd_and_even(p); !odd.empty() && even.size() > 1)
    if (const long c = cost(odd) + cost(even) + unit(rank(p)); c <= best.cost)
      best = {step::type::apart, -1, c};
  return best;
}

const scheme_table::step &scheme_table::step_of(const packed &p) {
  if (const auto it = steps_.find(p); it != steps_.end())
    return it->second;
  const step found = best_step(p);
  return steps_.emplace(p, found).first->second;
}

long scheme_table::cost(const packed &p) {
  if (p.empty())
    return 0;
  const std::int64_t g = content(p);
  const bool free = is_power_of_two(g);
  if (p.size() == 1)
    return product_cost(p[0]);
  return step_of(divided(p, g)).cost + (free ? 0 : unit(rank(p)));
}

} // namespace meetc::poly
