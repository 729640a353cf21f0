#include "gen/ir/residue.hpp"

#include "gen/ir/evaluate.hpp"
#include "gen/ir/fold.hpp"

#include <stdexcept>

namespace meetc::ir {
namespace {
using word = std::uint64_t;

word plus(word a, word b, word p) {
  const word sum = a + b; // below 2^62
  return sum < p ? sum : sum - p;
}
word times(word a, word b, word p) {
  __extension__ using wide = unsigned __int128;
  return static_cast<word>(static_cast<wide>(a) * b % p);
}

struct domain {
  using value = word;
  word prime;
  int point;

  value input(const node_ref &, int number) const { return residue_input(point, number) % prime; }
  value constant(const node_ref &, const rational &q) const { return residue(q, prime); }
  value negate(const node_ref &, value x) const { return x == 0 ? 0 : prime - x; }
  value add(const node_ref &, value x, value y) const { return plus(x, y, prime); }
  value subtract(const node_ref &at, value x, value y) const { return plus(x, negate(at, y), prime); }
  value multiply(const node_ref &, value x, value y) const { return times(x, y, prime); }
  value fused(const node_ref &, value x, value y, value z) const { return plus(times(x, y, prime), z, prime); }
};

} // namespace

word residue(const rational &q, word prime) {
  const mpz_class p(std::to_string(prime));
  mpz_class inverse;
  if (mpz_invert(inverse.get_mpz_t(), q.get_den_mpz_t(), p.get_mpz_t()) == 0)
    throw std::logic_error("a prime of the residues divides a denominator");
  mpz_class r = q.get_num() * inverse % p;
  if (r < 0)
    r += p;
  return std::stoull(r.get_str());
}

word residue_input(int point, int input) {
  // SplitMix64 (Steele, Lea and Flood 2014), a bijection of 64-bit words.
  word z = (static_cast<word>(point) << 32 | static_cast<word>(input)) * 0x9e3779b97f4a7c15U + 0x9e3779b97f4a7c15U;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
  z = (z ^ z >> 27) * 0x94d049bb133111ebU;
  return (z ^ z >> 31) % residue_primes[1];
}

std::vector<residue_list> residues(const program &p) {
  std::vector<residue_list> out(p.results.size());
  for (int point = 0; point < residue_points; ++point)
    for (const word prime : residue_primes) {
      const auto values = fold_results(p, domain{prime, point});
      for (std::size_t i = 0; i < out.size(); ++i)
        out[i].push_back(values[i]);
    }
  return out;
}

residue_list residues(const poly::poly &p) {
  residue_list out;
  const std::vector<poly::term> terms = p.terms();
  for (int point = 0; point < residue_points; ++point)
    for (const word prime : residue_primes) {
      word sum = 0;
      for (const poly::term &t : terms) {
        word product = residue(t.coefficient, prime);
        for (const poly::power &f : t.factors)
          for (int i = 0; i < f.exponent; ++i)
            product = times(product, residue_input(point, f.variable) % prime, prime);
        sum = plus(sum, product, prime);
      }
      out.push_back(sum);
    }
  return out;
}

residue_list residues(const std::vector<rational> &at_points) {
  residue_list out;
  for (const rational &q : at_points)
    for (const word prime : residue_primes)
      out.push_back(residue(q, prime));
  return out;
}

bool same_values(const program &a, const program &b, const poly::ring &inputs) {
  if (a.results.size() != b.results.size())
    return false;
  if (const auto x = short_polys(a, inputs))
    if (const auto y = short_polys(b, inputs))
      return *x == *y;
  return residues(a) == residues(b);
}

bool same_values(const program &a, const std::vector<poly::poly> &b, const poly::ring &inputs) {
  if (a.results.size() != b.size())
    return false;
  if (const auto x = short_polys(a, inputs))
    return *x == b;
  const auto have = residues(a);
  for (std::size_t i = 0; i < b.size(); ++i)
    if (have[i] != residues(b[i]))
      return false;
  return true;
}

} // namespace meetc::ir
