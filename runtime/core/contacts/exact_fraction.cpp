// The coordinates of a node as decimal fractions in lowest terms.
#include "meet/core/contacts/contacts.hpp"
#include "meetc/contact/fraction.hpp"

#include <algorithm>
#include <stdexcept>

namespace meetc {
namespace {

// A whole number that is not negative: limbs, least significant first, and none of them 0 at the end.
using whole = std::vector<std::uint64_t>;

void trim(whole &x) {
  while (!x.empty() && x.back() == 0)
    x.pop_back();
}
whole from_limbs(const std::uint64_t *limbs, int n) {
  whole x(limbs, limbs + n);
  trim(x);
  return x;
}
void raise(whole &x, int by) { // times 2^by
  x.insert(x.begin(), static_cast<std::size_t>(by / 64), 0);
  x.push_back(0);
  for (std::size_t i = x.size(); by % 64 != 0 && i-- > 1;)
    x[i] = x[i] << by % 64 | x[i - 1] >> (64 - by % 64);
  if (by % 64 != 0)
    x[0] <<= by % 64;
  trim(x);
}
int twos_in(const whole &x) {
  int n = 0;
  while (x[static_cast<std::size_t>(n / 64)] == 0)
    n += 64;
  while ((x[static_cast<std::size_t>(n / 64)] >> n % 64 & 1) == 0)
    ++n;
  return n;
}
void lower(whole &x, int by) { // divided by 2^by
  x.erase(x.begin(), x.begin() + by / 64);
  for (std::size_t i = 0; by % 64 != 0 && i < x.size(); ++i)
    x[i] = x[i] >> by % 64 | (i + 1 < x.size() ? x[i + 1] << (64 - by % 64) : 0);
  trim(x);
}
bool less(const whole &x, const whole &y) {
  return x.size() != y.size() ? x.size() < y.size()
                              : std::lexicographical_compare(x.rbegin(), x.rend(), y.rbegin(), y.rend());
}
void subtract(whole &x, const whole &y) { // y <= x
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::uint64_t from = x[i], what = i < y.size() ? y[i] : 0;
    x[i] = from - what - borrow;
    borrow = from < what || (from == what && borrow != 0) ? 1 : 0;
  }
  trim(x);
}
std::uint64_t divide(whole &x, std::uint64_t by) { // returns the remainder
  uint128 rest = 0;
  for (std::size_t i = x.size(); i-- > 0;) {
    rest = rest << 64 | x[i];
    x[i] = static_cast<std::uint64_t>(rest / by);
    rest %= by;
  }
  trim(x);
  return static_cast<std::uint64_t>(rest);
}
std::string decimal(whole x) {
  std::string out;
  constexpr std::uint64_t chunk = 1000000000000000000U;
  while (!x.empty()) {
    std::string digits = std::to_string(divide(x, chunk));
    std::reverse(digits.begin(), digits.end());
    if (!x.empty())
      digits.append(18 - digits.size(), '0');
    out += digits;
  }
  std::reverse(out.begin(), out.end());
  return out.empty() ? "0" : out;
}
// The greatest common divisor of two odd numbers.
whole common_divisor(whole x, whole y) {
  while (x != y) {
    whole &larger = less(x, y) ? y : x;
    subtract(larger, less(x, y) ? x : y);
    lower(larger, twos_in(larger));
  }
  return x;
}
// x / y, where nothing remains.
whole quotient(whole x, whole y) {
  whole out(x.size(), 0);
  int shift = 0;
  while (!less(x, y))
    raise(y, 1), ++shift;
  for (; shift-- > 0;) {
    lower(y, 1);
    if (!less(x, y)) {
      subtract(x, y);
      out[static_cast<std::size_t>(shift / 64)] |= std::uint64_t{1} << shift % 64;
    }
  }
  trim(out);
  return out;
}

// (numerator / denominator) 2^exponent in lowest terms.
decimal_fraction in_lowest_terms(whole numerator, whole denominator, int exponent, bool negative) {
  if (numerator.empty())
    return {"0", "1"};
  const int above = twos_in(numerator), below = twos_in(denominator), twos = exponent + above - below;
  lower(numerator, above), lower(denominator, below);
  const whole divisor = common_divisor(numerator, denominator);
  numerator = quotient(std::move(numerator), divisor), denominator = quotient(std::move(denominator), divisor);
  raise(twos > 0 ? numerator : denominator, twos > 0 ? twos : -twos);
  decimal_fraction out{decimal(std::move(numerator)), decimal(std::move(denominator))};
  if (negative)
    out.numerator.insert(0, 1, '-');
  return out;
}

} // namespace

template <class Real> std::array<decimal_fraction, 3> contact_set<Real>::exact(std::size_t node) const {
  if (node >= sources.size())
    throw std::out_of_range("contacts: there is no node " + std::to_string(node) + " of " +
                            std::to_string(sources.size()));
  const auto element = [](const touched_rows &of, std::uint32_t row) {
    return contact_element{of.rows.data() + std::size_t{3} * static_cast<std::size_t>(of.corners) * row, of.corners};
  };
  const node_source &s = sources[node];
  const label_points at(element(rows_a, s.a), element(rows_b, s.b), s.label);
  std::array<decimal_fraction, 3> out;
  if (!at.q) {
    for (std::size_t k = 0; k < 3; ++k) {
      const decoded d = decode(at.p[k]);
      const std::uint64_t m = d.m, one = 1;
      out[k] = in_lowest_terms(from_limbs(&m, 1), from_limbs(&one, 1), d.e, d.negative);
    }
    return out;
  }
  label_fraction fraction(at);
  for (int k = 0; k < 3; ++k) {
    const label_fraction::parts f = fraction.fraction(k);
    out[static_cast<std::size_t>(k)] = in_lowest_terms(
        from_limbs(f.numerator, f.limbs), from_limbs(f.denominator, f.limbs), fraction.exponent(), f.negative);
  }
  return out;
}

template std::array<decimal_fraction, 3> contact_set<float>::exact(std::size_t) const;
template std::array<decimal_fraction, 3> contact_set<double>::exact(std::size_t) const;

} // namespace meetc
