#include "io/transform.hpp"

#include "core/moved_coordinate.hpp"
#include "core/plural.hpp"
#include "core/pose.hpp"
#include "io/error.hpp"
#include "io/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace meetc::io {

void transform::check() const {
  if (scale && !(std::isfinite(*scale) && *scale > 0))
    throw error(fmt::format("{}: the scale is {}; it must be finite and above 0", scale_option, *scale));
  if (matrix)
    for (const double m : *matrix)
      if (!std::isfinite(m))
        throw error(fmt::format("{}: the matrix holds {}; its 12 numbers must be finite", matrix_option, m));
  if (translate)
    for (const double t : *translate)
      if (!std::isfinite(t))
        throw error(fmt::format("{}: the translation holds {}; its 3 numbers must be finite", translate_option, t));
}

std::string transform::options() const {
  std::string out;
  for (const auto &[present, option] :
       {std::pair(scale.has_value(), scale_option), std::pair(matrix.has_value(), matrix_option),
        std::pair(translate.has_value(), translate_option)})
    if (present)
      out += fmt::format("{}{}", out.empty() ? "" : ", ", option);
  return out;
}

std::array<double, 3> transform::point(std::array<double, 3> p) const {
  if (scale)
    for (double &c : p)
      c *= *scale;
  if (matrix) {
    const std::array<double, 3> q = p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = moved_coordinate(matrix->data() + 4 * i, q[0], q[1], q[2]);
  }
  if (translate)
    for (std::size_t i = 0; i < 3; ++i)
      p[i] += (*translate)[i];
  return p;
}

std::optional<double> similarity_scale(const std::array<double, 12> &matrix) {
  double most = 0;
  for (std::size_t i = 0; i < 12; ++i)
    if (i % 4 < 3)
      most = std::max(most, std::abs(matrix[i]));
  if (!(most > 0))
    return std::nullopt;
  // A power of two brings it near 1, so that no product overflows or underflows.
  int exponent = 0;
  std::frexp(most, &exponent);
  const auto dot = [&](std::size_t i, std::size_t j) {
    const auto at = [&](std::size_t row, std::size_t column) {
      return std::ldexp(matrix[4 * row + column], -exponent);
    };
    return (at(0, i) * at(0, j) + at(1, i) * at(1, j)) + at(2, i) * at(2, j);
  };
  const double length2 = dot(0, 0), slack = 0x1p-48 * length2;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      if (!(std::abs(dot(i, j) - (i == j ? length2 : 0)) <= slack))
        return std::nullopt;
  return std::ldexp(std::sqrt(length2), exponent);
}

std::array<float, 3> round_point(const transform &move, const std::array<double, 3> &read) {
  const std::array<double, 3> p = move.any() ? move.point(read) : read;
  return {to_float32(p[0]), to_float32(p[1]), to_float32(p[2])};
}

row_transform::row_transform(const kind_info &kind, const transform &move, const std::string &file) : move_(move) {
  if (!move.any())
    return;
  if (move.matrix && lies_along_axes(kind) && !keeps_axes(move.matrix->data()))
    throw error(fmt::format("{}: {} does more than move and scale along the axes, and {} have their edges there", file,
                            matrix_option, plural(kind.name)));
  roles_.assign(kind.roles, kind.roles + kind.fields);
  for (std::size_t f = 0; f < roles_.size(); ++f) {
    if (roles_[f] == role::x && f + 2 < roles_.size() && roles_[f + 1] == role::y && roles_[f + 2] == role::z) {
      f += 2;
      continue;
    }
    if (roles_[f] != role::length)
      throw error(fmt::format("{}: a transform cannot move {}: number {} of a row is neither part of a point nor "
                              "a length",
                              file, plural(kind.name), f + 1));
    if (!move.matrix)
      continue;
    const std::optional<double> scale = similarity_scale(*move.matrix);
    if (!scale)
      throw error(fmt::format("{}: {} is no similarity (columns equally long and at right angles), so the {} have "
                              "no radius under it",
                              file, matrix_option, plural(kind.name)));
    matrix_scale_ = *scale;
  }
}

void row_transform::apply(std::span<const double> in, std::span<float> out) const {
  if (roles_.empty()) {
    for (std::size_t f = 0; f < in.size(); ++f)
      out[f] = to_float32(in[f]);
    return;
  }
  for (std::size_t f = 0; f < in.size(); ++f) {
    if (roles_[f] == role::length) {
      out[f] = to_float32((move_.scale ? in[f] * *move_.scale : in[f]) * matrix_scale_);
      continue;
    }
    const std::array<double, 3> p = move_.point({in[f], in[f + 1], in[f + 2]});
    for (std::size_t c = 0; c < 3; ++c)
      out[f + c] = to_float32(p[c]);
    f += 2;
  }
}

std::string describe_non_finite(std::string_view field, double read, float result, const transform &move) {
  if (!std::isfinite(read))
    return fmt::format("{} is {}, not finite", field, read);
  return fmt::format("{} is {}, not finite in float32{} (read as {})", field, result,
                     move.any() ? " after " + move.options() : "", read);
}

} // namespace meetc::io
