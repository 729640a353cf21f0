#include "gen/poly/packed.hpp"

#include <algorithm>
#include <numeric>

namespace meetc::poly {
namespace {
constexpr std::int64_t largest = std::int64_t{1} << 24; // of a coefficient that is packed
}

int degree(product_of f) {
  int out = 0;
  for (; f != 0; f = rest_of(f))
    ++out;
  return out;
}

product_of times(product_of a, product_of b) {
  product_of out = 0;
  for (int at = 0; a != 0 || b != 0; at += lane_bits) {
    product_of &from = (a & 0xffff) >= (b & 0xffff) ? a : b;
    out |= (from & 0xffff) << at;
    from = rest_of(from);
  }
  return out;
}

bool divides(product_of divisor, product_of f) {
  for (; divisor != 0; f = rest_of(f)) {
    const product_of d = divisor & 0xffff, x = f & 0xffff;
    if (x < d)
      return false;
    if (x == d)
      divisor = rest_of(divisor);
  }
  return true;
}

product_of divided(product_of f, product_of divisor) {
  product_of out = 0;
  for (int at = 0; f != 0; f = rest_of(f)) {
    if ((f & 0xffff) == (divisor & 0xffff)) {
      divisor = rest_of(divisor);
      continue;
    }
    out |= (f & 0xffff) << at;
    at += lane_bits;
  }
  return out;
}

product_of common(product_of a, product_of b) {
  product_of out = 0;
  for (int at = 0; a != 0 && b != 0;) {
    const product_of x = a & 0xffff, y = b & 0xffff;
    if (x == y) {
      out |= x << at;
      at += lane_bits;
    }
    if (x >= y)
      a = rest_of(a);
    if (y >= x)
      b = rest_of(b);
  }
  return out;
}

packed joined(std::vector<packed_term> terms) {
  std::sort(terms.begin(), terms.end(), [](const packed_term &x, const packed_term &y) { return x.of < y.of; });
  packed out;
  for (const packed_term &t : terms)
    if (!out.empty() && out.back().of == t.of)
      out.back().coefficient += t.coefficient;
    else
      out.push_back(t);
  std::erase_if(out, [](const packed_term &t) { return t.coefficient == 0; });
  return out;
}

packed quotient(const packed &p, product_of divisor) {
  packed out;
  for (const packed_term &t : p)
    if (divides(divisor, t.of))
      out.push_back({divided(t.of, divisor), t.coefficient});
  std::sort(out.begin(), out.end());
  return out;
}

packed remainder(const packed &p, product_of divisor) {
  packed out;
  for (const packed_term &t : p)
    if (!divides(divisor, t.of))
      out.push_back(t);
  return out;
}

std::int64_t content(const packed &p) {
  std::int64_t g = 0;
  for (const packed_term &t : p)
    g = std::gcd(g, t.coefficient);
  return !p.empty() && p.front().coefficient < 0 ? -g : g;
}

packed divided(packed p, std::int64_t content) {
  if (content != 1)
    for (packed_term &t : p)
      t.coefficient /= content;
  return p;
}

int degree(const packed &p) {
  int out = 0;
  for (const packed_term &t : p)
    out = std::max(out, degree(t.of));
  return out;
}

std::vector<int> variables(const packed &p) {
  std::vector<int> out;
  for (const packed_term &t : p)
    for (product_of f = t.of; f != 0; f = rest_of(f))
      out.push_back(first_factor(f));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::optional<scaled_packed> pack(const poly &p) {
  const auto [content, primitive] = p.primitive();
  std::vector<packed_term> terms;
  for (const term &t : primitive.terms()) {
    const mpz_class c = t.coefficient.get_num();
    if (abs(c) > largest || primitive.in().size() > most_variables)
      return std::nullopt;
    product_of f = 0;
    int factors = 0;
    for (const power &q : t.factors) {
      factors += q.exponent;
      if (factors > most_factors)
        return std::nullopt;
      for (int i = 0; i < q.exponent; ++i)
        f = times(f, factor(q.variable));
    }
    terms.push_back({f, c.get_si()});
  }
  return scaled_packed{content, joined(std::move(terms))};
}

poly unpack(const packed &p, const ring &r) {
  std::vector<term> terms;
  for (const packed_term &t : p) {
    term out{rational(static_cast<long>(t.coefficient)), {}};
    for (product_of f = t.of; f != 0; f = rest_of(f))
      out.factors.push_back({first_factor(f), 1});
    terms.push_back(std::move(out));
  }
  return poly::from_terms(r, terms);
}

std::size_t packed_hash::operator()(const packed &p) const {
  std::uint64_t h = 0x9e3779b97f4a7c15U;
  const auto mix = [&](std::uint64_t x) {
    h = (h ^ x) * 0xbf58476d1ce4e5b9U;
    h ^= h >> 31;
  };
  for (const packed_term &t : p) {
    mix(static_cast<std::uint64_t>(t.of));
    mix(static_cast<std::uint64_t>(t.of >> 64));
    mix(static_cast<std::uint64_t>(t.coefficient));
  }
  return h;
}

} // namespace meetc::poly
