#include "gen/algebra/metric.hpp"

#include <bit>

namespace meetc::algebra {
namespace {
blade_sum collect(const std::map<blade, rational> &sum) {
  blade_sum out;
  for (const auto &[at, weight] : sum)
    if (weight != 0)
      out.push_back({at, weight});
  return out;
}
} // namespace

int grade(blade b) {
  return std::popcount(b);
}

metric::metric(std::vector<std::string> names, std::vector<std::vector<rational>> squares)
    : names_(std::move(names)), squares_(std::move(squares)) {
  const std::size_t blades = std::size_t{1} << names_.size();
  table_.resize(blades * blades);
  known_.resize(blades * blades);
}

int metric::outer_sign(blade a, blade b) {
  if (a & b)
    return 0;
  int swaps = 0;
  for (blade rest = a >> 1; rest; rest >>= 1)
    swaps += std::popcount(rest & b);
  return swaps % 2 ? -1 : 1;
}

blade_sum metric::contract(int v, blade b) const {
  blade_sum out;
  int sign = 1;
  for (int i = 0; i < vectors(); ++i)
    if (b >> i & 1) {
      if (product(v, i) != 0)
        out.push_back({b & ~(blade{1} << i), sign * product(v, i)});
      sign = -sign;
    }
  return out;
}

blade_sum metric::vector_times(int v, const blade_sum &b) const {
  std::map<blade, rational> sum;
  const blade single = blade{1} << v;
  for (const auto &[at, weight] : b) {
    if (const int s = outer_sign(single, at))
      sum[at | single] += s * weight;
    for (const auto &[inner, w] : contract(v, at))
      sum[inner] += w * weight;
  }
  return collect(sum);
}

const blade_sum &metric::geometric(blade a, blade b) const {
  const std::size_t slot = (std::size_t{a} << vectors()) | b;
  if (known_[slot])
    return table_[slot];
  blade_sum result;
  if (a == 0) {
    result = {{b, 1}};
  } else {
    const int first = std::countr_zero(a);
    const blade rest = a & (a - 1);
    std::map<blade, rational> sum;
    for (const auto &[at, weight] : vector_times(first, geometric(rest, b)))
      sum[at] += weight;
    for (const auto &[at, weight] : contract(first, rest))
      for (const auto &[inner, w] : geometric(at, b))
        sum[inner] -= weight * w;
    result = collect(sum);
  }
  known_[slot] = true;
  return table_[slot] = std::move(result);
}

std::string metric::name(blade b, const char *between) const {
  std::string out;
  for (int i = 0; i < vectors(); ++i)
    if (b >> i & 1)
      out += (out.empty() ? "" : between) + names_[static_cast<std::size_t>(i)];
  return out.empty() ? "1" : out;
}

bool in_reading_order(blade a, blade b) {
  if (grade(a) != grade(b))
    return grade(a) < grade(b);
  const blade differ = a ^ b;
  return differ && (a & (differ & (~differ + 1)));
}

} // namespace meetc::algebra
