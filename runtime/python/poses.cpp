#include "meet/python/poses.hpp"

#include "meet/core/sets/element_set.hpp"
#include "meet/core/threads/threads.hpp"
#include "meet/core/views/usage_error.hpp"
#include "meet/io/elements/transform.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace meetc::python {

namespace {

bool has_length(const kind_info &kind) {
  return std::any_of(kind.roles, kind.roles + kind.fields, [](role r) { return r == role::length; });
}

std::int64_t in_pose(const posed_query &q, const pose &at, int threads, collide_options options) {
  const box around = q.still.set().around;
  const prepared moved = posed(q.moved, at, {&around, 1}, {}, options.stop);
  if (moved.set().elements == 0)
    return 0;
  options.threads = threads;
  const prepared &a = q.still_first ? q.still : moved, &b = q.still_first ? moved : q.still;
  return static_cast<std::int64_t>(collide(a, b, q.predicate, q.precision, options).count);
}

} // namespace

pose pose_of(std::span<const double> matrix, const kind_info &kind) {
  std::array<double, 12> numbers;
  std::copy_n(matrix.begin(), 12, numbers.begin());
  pose out;
  std::copy_n(matrix.begin(), 12, out.m);
  if (!has_length(kind))
    return out;
  const std::optional<double> scale = io::similarity_scale(numbers);
  if (!scale)
    throw usage_error("the pose is no similarity, and a " + std::string(kind.name) +
                      " keeps its shape under these alone");
  out.length_scale = *scale;
  return out;
}

std::vector<std::int64_t> over_poses(const posed_query &q, std::span<const double> poses) {
  const kind_info &kind = *(q.still_first ? q.predicate.b : q.predicate.a);
  std::vector<pose> at;
  for (std::size_t i = 0; i < poses.size(); i += 12)
    at.push_back(pose_of(poses.subspan(i, 12), kind));
  const int threads = thread_count(q.options.threads);
  const int each = at.size() < static_cast<std::size_t>(threads) ? threads : 1;
  std::vector<std::int64_t> out(at.size());
  for_chunks(execution(each == 1 ? threads : 1, q.options.stop), at.size(), 1, [&](int, std::size_t i, std::size_t) {
    try {
      out[i] = in_pose(q, at[i], each, q.options);
    } catch (const input_error &e) {
      throw input_error(e.where, kind, "pose " + std::to_string(i) + ": ");
    }
  });
  return out;
}

} // namespace meetc::python
