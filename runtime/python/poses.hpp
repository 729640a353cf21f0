// python/poses.hpp: one set against another one in many poses.
#ifndef MEETC_PYTHON_POSES_HPP
#define MEETC_PYTHON_POSES_HPP

#include "meet/core/query/collide.hpp"

#include <span>
#include <vector>

namespace meetc::python {

// The pose of twelve numbers, row by row, for this kind. Throws usage_error where the kind has a length and the
// matrix is no similarity.
pose pose_of(std::span<const double> matrix, const kind_info &kind);

struct posed_query {
  const prepared &still, &moved; // the second without a pose
  const predicate_info &predicate;
  bool still_first; // whether the set that does not move is the predicate's first
  rung precision;
  collide_options options; // any or count; nothing is told of progress
};

// For each pose of 12 numbers the number of pairs; 0 or 1 for answer_kind::any. The moved set is posed, and not prepared again
// (meetc::posed). Threads share the poses, unless there are fewer of these.
std::vector<std::int64_t> over_poses(const posed_query &q, std::span<const double> poses);

} // namespace meetc::python

#endif
