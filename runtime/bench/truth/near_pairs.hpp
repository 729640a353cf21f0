// bench/truth/near_pairs.hpp: pairs of elements of any two kinds, near to or far from a contact, at any scale and place.
//
// Problem: a rung's errors depend on the size of the numbers, on how far they lie from the origin, and on how near the
// pair is to a contact. All three are to be chosen, for every predicate of a catalogue.
// Method: kinds are known by their hulls and pads (kind_info). A random pair has its points in the cube [-1, 1)^3. A
// near one is built around a contact at the origin: the element a lies on one side of a plane, b on the other, and a part
// of each (one, two or three points of its hull) lies on the plane with the origin in its middle. All numbers are chosen
// so that this is exact in float: the plane's normal is a vector of integers whose length is an integer (1, 2, 2; 2, 3, 6;
// ...), a pad is a multiple of that length, and the points of the parts lie on a lattice in the plane. Then one element is
// moved along the normal by 2^-bits, forth or back. Scaling by a power of two is exact until it under- or overflows. Moving
// to another place is not, so pairs there are only as near as float allows.
// Limits: an element with a point at the origin can be moved by any small length, others by no less than 2^-24 or so. What
// the truth of a pair is, the exact rung says of the rounded numbers.
#ifndef MEETC_BENCH_TRUTH_NEAR_PAIRS_HPP
#define MEETC_BENCH_TRUTH_NEAR_PAIRS_HPP

#include "meetc/support.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace meetc::bench {

struct pair_difficulty {
  int scale = 0;                  // all numbers are multiplied by 2^scale, from -126 to 125
  double offset = 0;              // each coordinate is moved by this many sizes, before scaling
  bool near = false;              // around a contact
  int bits_from = 0, bits_to = 0; // near: one element is moved by 2^-bits to 2^(1-bits), bits evenly from this range
};

struct element_pairs {
  const predicate_info *by = nullptr;
  std::vector<float> a, b; // rows; pair i is row i with row i
  std::size_t count = 0;
};

// Whether pairs can be made for the predicate: the hulls of both kinds are known.
bool can_make_pairs(const predicate_info &p);

// The same on every machine. Throws std::invalid_argument where can_make_pairs() is false.
element_pairs make_pairs(const predicate_info &p, std::size_t n, const pair_difficulty &d, std::uint64_t seed);

} // namespace meetc::bench

#endif
