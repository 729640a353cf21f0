#include "gen/poly/change.hpp"

#include <algorithm>
#include <cstdlib>

namespace meetc::poly {
namespace {

constexpr std::int64_t largest = std::int64_t{1} << 40; // coefficient; a change multiplies it by 2^16 at most

int exponent(product_of f, int v) {
  int out = 0;
  for (; f != 0; f = rest_of(f))
    out += first_factor(f) == v;
  return out;
}

product_of without(product_of f, int v, int w) {
  product_of out = 0;
  for (; f != 0; f = rest_of(f))
    if (const int x = first_factor(f); x != v && x != w)
      out = times(out, factor(x));
  return out;
}

product_of power_of(int v, int exponent) {
  product_of out = 0;
  for (int i = 0; i < exponent; ++i)
    out = times(out, factor(v));
  return out;
}

} // namespace

changed change(const packed &p, const variable_pair &by) {
  int highest = 0;
  for (const packed_term &t : p)
    highest = std::max(highest, exponent(t.of, by.v) + exponent(t.of, by.w));
  std::vector<packed_term> out;
  for (const packed_term &t : p) {
    const int a = exponent(t.of, by.v), b = exponent(t.of, by.w);
    // (plus + minus)^a (plus - minus)^b: the coefficient of plus^(a + b - k) minus^k.
    std::vector<std::int64_t> c{1};
    for (int i = 0; i < a + b; ++i) {
      std::vector<std::int64_t> next(c.size() + 1);
      for (std::size_t k = 0; k < c.size(); ++k) {
        next[k] += c[k];
        next[k + 1] += i < a ? c[k] : -c[k];
      }
      c = std::move(next);
    }
    const product_of rest = without(t.of, by.v, by.w);
    const auto power_of_two =
        static_cast<std::int64_t>(std::uint64_t{1} << static_cast<unsigned>(std::max(highest - a - b, 0)));
    for (int k = 0; k <= a + b; ++k)
      if (const std::int64_t x = c[static_cast<std::size_t>(k)])
        out.push_back({times(rest, times(power_of(by.plus, a + b - k), power_of(by.minus, k))),
                       t.coefficient * x * power_of_two});
  }
  return {joined(std::move(out)), highest};
}

std::vector<variable_pair> shortening_pairs(std::vector<packed> all, const std::vector<int> &group, int next) {
  std::vector<variable_pair> out;
  std::vector<char> taken(group.size());
  const auto paired = [&](std::size_t v) { return group[v] >= 0 && !taken[v]; };
  for (;;) {
    std::ptrdiff_t best_gain = 0;
    variable_pair best{};
    for (std::size_t v = 0; v < group.size(); ++v)
      for (std::size_t w = v + 1; w < group.size(); ++w) {
        if (!paired(v) || !paired(w) || group[v] != group[w])
          continue;
        const variable_pair by{static_cast<int>(v), static_cast<int>(w), next, next + 1};
        std::ptrdiff_t gain = 0;
        for (const packed &p : all)
          gain += static_cast<std::ptrdiff_t>(p.size()) - static_cast<std::ptrdiff_t>(change(p, by).of.size());
        if (gain > best_gain) {
          best_gain = gain;
          best = by;
        }
      }
    if (best_gain == 0)
      return out;
    for (packed &p : all) {
      p = change(p, best).of;
      p = divided(p, content(p));
      if (std::any_of(p.begin(), p.end(), [](const packed_term &t) { return std::abs(t.coefficient) > largest; }))
        return out;
    }
    out.push_back(best);
    taken[static_cast<std::size_t>(best.v)] = taken[static_cast<std::size_t>(best.w)] = 1;
    next += 2;
  }
}

} // namespace meetc::poly
