// The paper's Algorithms 1 to 3 on the meet, with every erratum as a switch. With all switches off it is the corrected
// procedure; each switch shows the effect of that erratum alone.
#ifndef MEETC_TESTS_PAPER_ALGORITHMS_HPP
#define MEETC_TESTS_PAPER_ALGORITHMS_HPP

#include "tests/paper/cga.hpp"

#include <array>

namespace meetc::paper_test {

using segment = std::array<vec, 2>;
using triangle = std::array<vec, 3>;

// ---- signs, each a coefficient of a meet or an outer product ----
int side(const triangle &t, const vec &p);                    // of plane ∨ point
int twist(const segment &s, const segment &e);                // of line ∨ line, on n
int turn(int k, const vec &a, const vec &b, const vec &c);    // of axis k ^ a ^ b ^ c ^ n
rational trivector(const vec &a, const vec &b, const vec &c); // Algorithm 1's: the determinant

// ---- closed decisions for every operand, degenerate ones too ----
bool segment_segment(const segment &s, const segment &e);
bool point_triangle(const vec &p, const triangle &t);

// The paper's printed version where it differs from the correct one.
struct algorithm_1_errata {
  bool raw_trivectors = false;  // A2: sign1 == sign2 compares the trivectors, not their signs
  bool strict = false;          // A3: the side signs must be > 0 or < 0, so edges and vertices are missed
  bool one_coefficient = false; // A4: "in the plane" tests the e3 eb coefficient only
  bool only_edges = false;      // A5: in the plane, only crossings with edges count
  bool assignment = false;      // A6: e3er = 0 as C reads it: assigns, and is false
};
// Whether the line is considered to lie in the triangle's plane, given that it is parallel to it.
bool taken_as_contained(const segment &s, const triangle &t, const algorithm_1_errata &errata);
bool parallel(const segment &s, const triangle &t); // a == 0
bool algorithm_1(const segment &s, const triangle &t, const algorithm_1_errata &errata = {});

// Whether all corners of t lie strictly on one side of the other's plane.
bool on_one_side(const triangle &other, const triangle &t);

struct algorithm_2_errata {
  bool negated_side_test = false; // B2: "if not VerifySameSidePoints then return 0"
  bool assignment = false;        // B4: out3 = 1 in the first condition
};
bool algorithm_2(const triangle &a, const triangle &b, const algorithm_2_errata &errata = {});

struct ball {
  vec centre;
  rational radius;
};
bool algorithm_3(const ball &a, const ball &b); // both moved by −a.centre; B² >= 0

} // namespace meetc::paper_test

#endif
