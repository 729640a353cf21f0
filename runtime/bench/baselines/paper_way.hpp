// bench/baselines/paper_way.hpp: three predicates as the paper computes them, in float32, to show what its basis costs.
//
// Source: "GPU Collision Detection in Conformal Geometric Space", Table 1 and Algorithms 1 to 3. Vectors have the
// coefficients of the orthonormal basis e1, e2, e3, e, e-bar, and planes and lines are formed from points as they lie in
// the world, not from differences with a local origin.
//   point p          2p + (p.p - 1) e + (p.p + 1) e-bar
//   sphere (dual)    2c + (c.c - r r - 1) e + (c.c - r r + 1) e-bar
//   plane (dual)     N + d e + d e-bar, with N = a x b + b x c + c x a and d = [a, b, c]
//   line             direction q - p and moment p x q; two lines pass by v.m' + v'.m
// Limits: the degenerate cases that the paper leaves open stay open. No answer is promised.
#ifndef MEETC_BENCH_BASELINES_PAPER_WAY_HPP
#define MEETC_BENCH_BASELINES_PAPER_WAY_HPP

#include "meetc/support.hpp"

#include <string_view>

namespace meetc::bench {

// For sphere_sphere, segment_triangle and triangle_triangle, on rows of the default scene's kinds; null for others.
decide_function paper_way(std::string_view predicate);

} // namespace meetc::bench

#endif
