// Plans the arithmetic that keeps a scene's tolerance, kernel by kernel.
//
// Problem: an answer may be wrong only where moving one operand by at most the tolerance changes it. Errors of signs say
// little about that. Where a line passes beyond the corner of a needle, by little from the line through the needle's edge,
// it may be far from the needle itself: signs within their bounds prove no short move, however small the bounds are.
// Method: the operands are moved instead of the signs. Each stored number is rounded to a grid, so that each point moves by
// at most e = sqrt(dimensions)/2 steps, and each pad by half a step; and the decision on the rounded operands is exact.
//   - Let A' and B' be the rounded operands, closed convex sets within e_A and e_B of A and B (Hausdorff). If A' and B'
//     touch, the distance of A and B is at most e_A + e_B, and a translation by it makes them touch. If they do not touch,
//     a plane parts them strictly, A and B overlap along its normal by less than e_A + e_B, and a translation by that parts
//     them. So k = 2 for equal errors, whatever the operands are: flat, needles, or parallel.
//   - Two spheres' surfaces touch if |r - s| <= d <= r + s, which rounding changes by at most e_A + e_B, and a move along
//     the line of their centres does the same. If r = s, then also when rounded, so that no hit becomes a nested miss.
//   - A surface around more than one point has no such proof: if both ends of a segment are on a sphere around its middle,
//     no short move takes the segment in, but rounding may.
// Within the scene's box, numbers on the grid are short integers, so that every value fits 64 or 128 bits.
//
// A predicate that compares the distance d of two points with a sum R of lengths needs no grid. Its value d^2 - R^2 has a
// magnitude of d^2 + R^2, so that a wrong sign says |d - R| (d + R) <= K (d + R)^2, up to underflow, and a move along the
// line of the points by K (d + R) mends it: k = 1.
#pragma once
#include "gen/lower/kernel/kernel.hpp"

#include <optional>
#include <string>

namespace meetc::lower {

struct tolerant_way {
  bool by_distance = false; // in plain fp32; else by the grid, in fp32 with its bound and then by integers
  bool beside_grid = false; // by distance, in a scene whose sets are rounded to its grid for other kernels
  int low = 0, bits = 0;    // the grid's step is 2^low, and no difference exceeds 2^bits steps
  int width = 0;            // of the longest integers: 64 or 128
  rational moves;           // what one motion of one operand has to be, at most, to mend a wrong answer
  rational reach;           // the largest |coordinate| after rounding; no length exceeds twice this
};

// The plan for a scene's tolerance.
struct tolerance_plan {
  std::optional<int> low;                        // the grid's step, if some kernel needs the grid
  std::vector<std::optional<tolerant_way>> ways; // by kernel; none for formulas, signs and what keeps no tolerance
  std::vector<std::string> refusals; // by kernel: why a predicate keeps none, where the scene has rungs that need none
};

// All of this presumes that a predicate says whether its operands touch, which only verify holds against geometry.
//
// Throws spec_error, at the scene's tolerance or at the kernel, where a predicate has no proof and the scene asks for no
// other rung: it says what the scene would have to state. bounds: by kernel, for kernels that consist of signs.
tolerance_plan plan_tolerance(const model &m, const lang::scene &s, const std::vector<kernel> &kernels,
                              const std::vector<std::optional<bound::kernel_bounds>> &bounds);

} // namespace meetc::lower
