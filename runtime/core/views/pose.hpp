// core/views/pose.hpp: where a set stands.
#ifndef MEETC_CORE_VIEWS_POSE_HPP
#define MEETC_CORE_VIEWS_POSE_HPP

#include "meet/core/views/status.hpp"
#include "meetc/support.hpp"

namespace meetc {

// A row-major 3x4 matrix, whose arithmetic moved_coordinate() is; each coordinate is rounded once to float32. Lengths are
// multiplied by length_scale, which the caller takes from the similarity, in fp64, and are rounded once. In a kind of the plane
// z counts as 0. The identity changes no bit.
//
// With a grid, which is a power of two, every number is then rounded to its nearest multiple, of two to the even one. Each
// point moves by at most sqrt(3)/2 of it, and each length by a half. Closed sets that are hulls of points, padded by
// lengths, then answer as they would after a move of one of them by at most the sum of these over both (docs/tolerance.md).
struct pose {
  double m[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  double length_scale = 1;
  double grid = 0; // 0: nothing is rounded

  bool identity() const;
};

// Whether a grid is 0 or a power of two from 2^-149 to 2^127.
bool is_grid(double grid);

// The greatest distance by which one element of a pair must be moved so that the exact answer is that of the two elements
// rounded to the grid; gen/lower/tolerance.hpp has the proof. 0: no such move is known. It is not, where the surface around a
// point meets an element with several points: if both ends of a segment are on a sphere around its middle, no short move takes
// them in, and yet rounding may.
double moved_by_grid(const predicate_info &predicate, double grid);
// The largest grid for which that is at most `tolerance`; 0: there is none.
double grid_within(const predicate_info &predicate, double tolerance);

// Whether a pose can move every field of the kind: all are points x, y, z (or x, y) in this order, or lengths.
bool can_move(const kind_info &kind);

// Whether the element's edges lie along the axes, because points of its hull mix the coordinates of stored points, as a box's
// corners do.
bool lies_along_axes(const kind_info &kind);
// Whether a row-major 3x4 matrix maps such an element to its like: it scales along the axes, by factors that are not
// negative, and moves.
bool keeps_axes(const double *matrix);

// The ends between which the boxes of elements lie in this pose, where without it they lie in [lo, hi] and lengths are at most
// `longest`. Returns false, and no ends, where a number in the pose might not be finite.
//
// Proof: a coordinate lies between the sums of the least and of the greatest products. Let M be the sum of the magnitudes. The
// pose's six roundings in fp64 and those here lose less than 2^-48 M, the rounding to float32 loses 2^-24 of the rest, or
// 2^-150, and that of the box's end twice as much; a grid moves the number by at most a half of it. The slack is more than all
// of these.
bool ends_in(const pose &at, const float lo[3], const float hi[3], double longest, double least[3], double greatest[3]);

// Whether these ends prove that no element touches the box [from, to]. False where there are none.
bool proved_apart(const pose &at, const float lo[3], const float hi[3], double longest, const float from[3],
                  const float to[3]);

// ok, or why this pose does not go with this kind.
status movable(const kind_info &kind, const pose &at);

// Moves n rows of kind.fields floats in place. The pose must be movable(). The results may be infinite or NaN.
void move_rows(const kind_info &kind, const pose &at, float *rows, std::size_t n);

} // namespace meetc

#endif
