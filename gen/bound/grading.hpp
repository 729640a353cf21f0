// Groups of the stored numbers of a pair, each with a grid of its own.
//
// Problem: the exact rung computes in integers, and float32 numbers are integers times a power of two. A polynomial keeps its
// sign if its numbers are divided by such powers only where all its terms are divided by the same one. A plane N . x = d has
// a sign N . c - d whose terms have two numbers and one.
// Method: number i has a weight w(i, j) >= 0 in each group j, and its grid is the product of the groups' steps, each to the
// power of the weight. That divides all terms alike if the terms of each sign have one degree in each group. Such weights are
// the solutions of linear equations, one for each two terms of a sign. In a basis of them, some numbers have the weight 1 in a
// group of their own, and all others have sums of these weights: here N and c are groups, and d is of both. Where no basis
// has whole weights that are not negative, one group with small positive weights is looked for.
// Limits: coordinates of positions have equal weights, since they are subtracted from each other. Weights are at most
// most_weight in sum. Signs that are homogeneous as they stand have no groups.
#pragma once
#include "gen/poly/local_origin.hpp"

#include <optional>

namespace meetc::bound {

inline constexpr int most_weight = 6;

struct grading {
  // By input, by group; those of an input that no sign reads are 0. Empty: all numbers lie on one grid.
  std::vector<std::vector<int>> weights;

  int groups() const { return weights.empty() ? 1 : static_cast<int>(weights.front().size()); }
  // The weights of all inputs in one group.
  std::vector<int> of_group(int group) const;
  // Their sums over all groups.
  std::vector<int> total() const;
};

// The groups of these polynomials in the stored numbers, or nothing if there are none.
std::optional<grading> find_grading(const std::vector<const poly::poly *> &signs, const poly::local_origin &local);

} // namespace meetc::bound
