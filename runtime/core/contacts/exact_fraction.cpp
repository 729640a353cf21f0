// The exact coordinates of a node in decimal, in lowest terms.
#include "meet/core/contacts/contacts.hpp"
#include "meetc/contact/fraction.hpp"
#include "meetc/contact/root.hpp"

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
void add(whole &x, const whole &y) {
  x.resize(std::max(x.size(), y.size()) + 1);
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const uint128 sum = uint128{x[i]} + (i < y.size() ? y[i] : 0) + carry;
    x[i] = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64);
  }
  trim(x);
}
whole product(const whole &x, const whole &y) {
  whole out(x.size() + y.size(), 0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    uint128 carry = 0;
    for (std::size_t j = 0; j < y.size(); ++j) {
      carry += uint128{x[i]} * y[j] + out[i + j];
      out[i + j] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    out[i + y.size()] = static_cast<std::uint64_t>(carry);
  }
  trim(out);
  return out;
}
// The greatest whole number whose square is not above x.
whole square_root(const whole &x) {
  whole out;
  for (int bit = 32 * static_cast<int>(x.size()); bit-- > 0;) {
    whole one{1}, more = out;
    raise(one, bit);
    add(more, one);
    if (!less(x, product(more, more)))
      out = std::move(more);
  }
  return out;
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

// A whole number with a sign.
struct whole_number {
  whole size;
  bool negative;
};
std::string decimal(whole_number x) {
  const bool negative = x.negative && !x.size.empty();
  std::string out = decimal(std::move(x.size));
  if (negative)
    out.insert(0, 1, '-');
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
  return {decimal(whole_number{std::move(numerator), negative}), decimal(std::move(denominator))};
}

// The divisor that some numbers have in common, of which one at least is not 0.
whole common_divisor_of(const std::array<const whole *, 3> &numbers) {
  whole out;
  int twos = 0;
  for (const whole *const x : numbers) {
    if (x->empty())
      continue;
    const int here = twos_in(*x);
    whole odd = *x;
    lower(odd, here);
    twos = out.empty() ? here : std::min(twos, here);
    out = out.empty() ? std::move(odd) : common_divisor(std::move(out), std::move(odd));
  }
  raise(out, twos);
  return out;
}

whole_number sum(whole_number x, const whole_number &y) {
  if (x.negative == y.negative) {
    add(x.size, y.size);
    return x;
  }
  if (less(x.size, y.size)) {
    whole_number out = y;
    subtract(out.size, x.size);
    return out;
  }
  subtract(x.size, y.size);
  return x;
}

// (p + q sqrt(d)) / s 2^exponent
decimal_fraction root_in_lowest_terms(whole_number p, whole_number q, whole d, whole s, int exponent) {
  const whole root = square_root(d);
  if (q.size.empty() || product(root, root) == d) {
    const whole_number x = sum(std::move(p), {product(q.size, root), q.negative});
    return in_lowest_terms(x.size, std::move(s), exponent, x.negative);
  }
  const int fours = twos_in(d) / 2;
  lower(d, 2 * fours);
  raise(q.size, fours);
  if (exponent > 0)
    raise(p.size, exponent), raise(q.size, exponent);
  else
    raise(s, -exponent);
  const whole divisor = common_divisor_of({&p.size, &q.size, &s});
  for (whole *const x : {&p.size, &q.size, &s})
    *x = quotient(std::move(*x), divisor);
  return {decimal(std::move(p)), decimal(std::move(s)), decimal(std::move(q)), decimal(std::move(d))};
}
decimal_fraction exact_root(const float *ball, const float *segment, int which, int k) {
  root_integers<float> integers(ball, segment);
  const auto parts = integers.root(which, k);
  const auto size = [](const auto &x) { return from_limbs(x.limbs, x.n); };
  return root_in_lowest_terms({size(parts.p), parts.p.negative}, {size(parts.q), parts.q.negative}, size(parts.d),
                              size(parts.s), integers.exponent());
}
decimal_fraction exact_number(float x) {
  const decoded d = decode(x);
  return in_lowest_terms(d.m == 0 ? whole{} : whole{d.m}, whole{1}, d.e, d.negative);
}

} // namespace

template <class Real> std::array<decimal_fraction, 3> contact_set<Real>::exact(std::size_t node) const {
  if (node >= sources.size())
    throw std::out_of_range("contacts: there is no node " + std::to_string(node) + " of " +
                            std::to_string(sources.size()));
  const auto element = [](const touched_rows &of, std::uint32_t row) {
    return contact_element{of.rows.data() + static_cast<std::size_t>(of.fields) * row, of.corners};
  };
  const node_source &s = sources[node];
  const contact_element a = element(rows_a, s.a), b = element(rows_b, s.b);
  std::array<decimal_fraction, 3> out;
  if (a.corners == 0) {
    for (int k = 0; k < 3; ++k)
      out[static_cast<std::size_t>(k)] = label_b(s.label) < 2 ? exact_number(b.row[3 * label_b(s.label) + k])
                                                              : exact_root(a.row, b.row, label_a(s.label), k);
    return out;
  }
  const label_points at(a, b, s.label);
  if (!at.q) {
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = exact_number(at.p[k]);
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
