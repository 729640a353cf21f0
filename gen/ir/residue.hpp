// Values of programs modulo two primes of 61 bits.
//
// Problem: a program can be short and its polynomials too long to write down, as for a product of products. Whether two
// programs have equal values must be known all the same.
// Method: both are evaluated at the same 20 points modulo 2^61 - 1 and modulo 2^61 - 31. A polynomial of degree d other than
// zero vanishes at a random point modulo p with probability at most d / p (Schwartz 1980, Zippel 1979), and so in all with
// less than (d / 2^60)^40. The points are fixed, so that a run is repeated to the byte.
#pragma once
#include "gen/ir/arena.hpp"

#include <optional>

namespace meetc::ir {

inline constexpr std::array<std::uint64_t, 2> residue_primes{(std::uint64_t{1} << 61) - 1,
                                                             (std::uint64_t{1} << 61) - 31};
inline constexpr int residue_points = 20;

// q modulo p. Throws std::logic_error where p divides the denominator.
std::uint64_t residue(const rational &q, std::uint64_t prime);
// The number that input `input` has at one of the points: an integer below both primes.
std::uint64_t residue_input(int point, int input);

// The values of a function of the inputs: point by point, and for each point both primes.
using residue_list = std::vector<std::uint64_t>;
std::vector<residue_list> residues(const program &p); // by result
residue_list residues(const poly::poly &p);           // variable i of its ring is input i
// The same for values that another evaluation found at the points: the value at residue_input(point, i) for each point.
residue_list residues(const std::vector<rational> &at_points);

// Whether the results are the same functions of the inputs: by their polynomials where these are short enough to expand,
// and else by their residues.
bool same_values(const program &a, const program &b, const poly::ring &inputs);
bool same_values(const program &a, const std::vector<poly::poly> &b, const poly::ring &inputs);

} // namespace meetc::ir
