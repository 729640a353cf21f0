#include "gen/algebra/metric.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace meetc::algebra {
namespace {
blade_sum collect(const std::map<blade, rational> &sum) {
  blade_sum out;
  for (const auto &[at, weight] : sum)
    if (weight != 0)
      out.push_back({at, weight});
  return out;
}

// The sign of the outer product of blades whose vectors stand in basis order.
int sign_in_basis_order(blade a, blade b) {
  if (a & b)
    return 0;
  int swaps = 0;
  for (blade rest = a >> 1; rest; rest >>= 1)
    swaps += std::popcount(rest & b);
  return swaps % 2 ? -1 : 1;
}

// By grade, then by their vectors in basis order: e1^e2, e1^e3, ...
bool in_reading_order(blade a, blade b) {
  if (grade(a) != grade(b))
    return grade(a) < grade(b);
  const blade differ = a ^ b;
  return differ && (a & (differ & (~differ + 1)));
}
} // namespace

int grade(blade b) {
  return std::popcount(b);
}

metric::metric(std::vector<std::string> names, std::vector<std::vector<rational>> squares,
               const std::vector<std::vector<int>> &order)
    : names_(std::move(names)), squares_(std::move(squares)) {
  const std::size_t blades = std::size_t{1} << names_.size();
  plain_.of.resize(blades * blades);
  plain_.known.resize(blades * blades);
  factors_.resize(blades);
  signs_.assign(blades, 1);
  for (std::size_t b = 0; b < blades; ++b)
    for (int i = 0; i < vectors(); ++i)
      if (b >> i & 1)
        factors_[b].push_back(i);
  take_order(order);
  if (!same_signs_)
    ordered_ = plain_;
}

void metric::take_order(const std::vector<std::vector<int>> &order) {
  std::vector<blade> listed;
  for (const std::vector<int> &vectors : order) {
    blade b = 0;
    int sign = 1;
    for (const int v : vectors) {
      sign *= sign_in_basis_order(b, blade{1} << v);
      b |= blade{1} << v;
    }
    factors_[b] = vectors;
    signs_[b] = sign;
    same_signs_ = same_signs_ && sign == 1;
    listed.push_back(b);
  }
  std::vector<blade> all(factors_.size());
  std::iota(all.begin(), all.end(), blade{0});
  std::sort(all.begin(), all.end(), in_reading_order);
  rank_.resize(all.size());
  auto next = listed.begin();
  for (std::size_t place = 0; place < all.size(); ++place) {
    const bool is_listed = std::find(listed.begin(), listed.end(), all[place]) != listed.end();
    rank_[is_listed ? *next++ : all[place]] = static_cast<int>(place);
  }
}

int metric::outer_sign(blade a, blade b) const {
  const int plain = sign_in_basis_order(a, b);
  return plain == 0 || same_signs_ ? plain : plain * sign(a) * sign(b) * sign(a | b);
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
    if (const int s = sign_in_basis_order(single, at))
      sum[at | single] += s * weight;
    for (const auto &[inner, w] : contract(v, at))
      sum[inner] += w * weight;
  }
  return collect(sum);
}

const blade_sum &metric::geometric(blade a, blade b) const {
  if (same_signs_)
    return in_basis_order(a, b);
  const std::size_t slot = (std::size_t{a} << vectors()) | b;
  if (ordered_.known[slot])
    return ordered_.of[slot];
  blade_sum result = in_basis_order(a, b);
  for (blade_term &t : result)
    t.weight *= sign(a) * sign(b) * sign(t.at);
  ordered_.known[slot] = true;
  return ordered_.of[slot] = std::move(result);
}

const blade_sum &metric::in_basis_order(blade a, blade b) const {
  const std::size_t slot = (std::size_t{a} << vectors()) | b;
  if (plain_.known[slot])
    return plain_.of[slot];
  blade_sum result;
  if (a == 0) {
    result = {{b, 1}};
  } else {
    const int first = std::countr_zero(a);
    const blade rest = a & (a - 1);
    std::map<blade, rational> sum;
    for (const auto &[at, weight] : vector_times(first, in_basis_order(rest, b)))
      sum[at] += weight;
    for (const auto &[at, weight] : contract(first, rest))
      for (const auto &[inner, w] : in_basis_order(at, b))
        sum[inner] -= weight * w;
    result = collect(sum);
  }
  plain_.known[slot] = true;
  return plain_.of[slot] = std::move(result);
}

std::string metric::name(blade b, const char *between) const {
  std::string out;
  for (const int i : factors(b))
    out += (out.empty() ? "" : between) + names_[static_cast<std::size_t>(i)];
  return out.empty() ? "1" : out;
}

} // namespace meetc::algebra
