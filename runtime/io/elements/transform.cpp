#include "meet/io/elements/transform.hpp"

#include "meet/core/threads/threads.hpp"
#include "meet/core/views/moved_coordinate.hpp"
#include "meet/core/views/nouns.hpp"
#include "meet/core/views/pose.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/text/number.hpp"
#include <meetc/environment/control_word.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace meetc::io {

namespace {

// The functions below do the work of those of transform.hpp, which call them under a guard of the control word.

void check_numbers(const transform &of) {
  if (of.scale && !(std::isfinite(*of.scale) && *of.scale > 0))
    throw error(fmt::format("{}: the scale is {}; it must be finite and above 0", of.option("scale"), *of.scale));
  if (of.matrix)
    for (const double m : *of.matrix)
      if (!std::isfinite(m))
        throw error(fmt::format("{}: the matrix holds {}; its numbers must be finite", of.option("matrix"), m));
  if (of.translate)
    for (const double t : *of.translate)
      if (!std::isfinite(t))
        throw error(
            fmt::format("{}: the translation holds {}; its 3 numbers must be finite", of.option("translate"), t));
}

std::array<double, 3> moved_point(const transform &by, std::array<double, 3> p) {
  if (by.scale)
    for (double &c : p)
      c *= *by.scale;
  if (by.matrix) {
    const std::array<double, 3> q = p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = moved_coordinate(by.matrix->data() + 4 * i, q[0], q[1], q[2]);
  }
  if (by.translate)
    for (std::size_t i = 0; i < 3; ++i)
      p[i] += (*by.translate)[i];
  return p;
}

std::optional<double> scale_of(const std::array<double, 12> &matrix, double within) {
  double most = 0;
  for (std::size_t i = 0; i < 12; ++i)
    if (i % 4 < 3)
      most = std::max(most, std::abs(matrix[i]));
  if (!(most > 0))
    return std::nullopt;
  // A power of two brings the largest number near 1, so that no product overflows or underflows.
  int exponent = 0;
  std::frexp(most, &exponent);
  const auto dot = [&](std::size_t i, std::size_t j) {
    const auto at = [&](std::size_t row, std::size_t column) {
      return std::ldexp(matrix[4 * row + column], -exponent);
    };
    return (at(0, i) * at(0, j) + at(1, i) * at(1, j)) + at(2, i) * at(2, j);
  };
  const double length2 = dot(0, 0), slack = within * length2;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      if (!(std::abs(dot(i, j) - (i == j ? length2 : 0)) <= slack))
        return std::nullopt;
  return std::ldexp(std::sqrt(length2), exponent);
}

std::array<float, 3> rounded_point(const transform &by, const std::array<double, 3> &read) {
  const std::array<double, 3> p = moved_point(by, read);
  return {to_float32(p[0]), to_float32(p[1]), to_float32(p[2])};
}

// Moves one row of a kind.
class row_transform {
public:
  // Throws io::error for a kind that cannot be moved.
  row_transform(const kind_info &kind, const transform &move, const std::string &file) : move_(move) {
    const std::string option = move.option("matrix");
    if (move.matrix && lies_along_axes(kind) && !keeps_axes(move.matrix->data()))
      throw error(fmt::format("{}: {} does more than move and scale along the axes, and {} have their edges there",
                              file, option, plural_of(kind.name)));
    roles_.assign(kind.roles, kind.roles + kind.fields);
    for (std::size_t f = 0; f < roles_.size(); ++f) {
      if (roles_[f] == role::x && f + 2 < roles_.size() && roles_[f + 1] == role::y && roles_[f + 2] == role::z) {
        f += 2;
        continue;
      }
      if (roles_[f] != role::length)
        throw error(fmt::format("{}: a transform cannot move {}: number {} of a row is neither part of a point nor "
                                "a length",
                                file, plural_of(kind.name), f + 1));
      if (!move.matrix)
        continue;
      const std::optional<double> scale = scale_of(*move.matrix, similarity_slack);
      if (!scale)
        throw error(fmt::format("{}: {} is no similarity (columns equally long and at right angles), so the {} have "
                                "no radius under it",
                                file, option, plural_of(kind.name)));
      matrix_scale_ = *scale;
    }
  }
  // A transform of points.
  explicit row_transform(const transform &move) : move_(move), roles_{role::x, role::y, role::z} {}

  std::size_t fields() const { return roles_.size(); }

  // Returns the first field that is then not finite, with its former value in `read`; -1: none.
  int apply(float *row, float &read) const {
    for (std::size_t f = 0; f < roles_.size(); ++f) {
      if (roles_[f] == role::length) {
        const float before = row[f];
        const double length = static_cast<double>(before);
        row[f] = to_float32((move_.scale ? length * *move_.scale : length) * matrix_scale_);
        if (!std::isfinite(row[f]))
          return read = before, static_cast<int>(f);
        continue;
      }
      const float before[3] = {row[f], row[f + 1], row[f + 2]};
      const std::array<float, 3> p = rounded_point(
          move_, {static_cast<double>(before[0]), static_cast<double>(before[1]), static_cast<double>(before[2])});
      for (std::size_t c = 0; c < 3; ++c)
        row[f + c] = p[c];
      for (std::size_t c = 0; c < 3; ++c)
        if (!std::isfinite(p[c]))
          return read = before[c], static_cast<int>(f + c);
      f += 2;
    }
    return -1;
  }

private:
  const transform &move_;
  std::vector<role> roles_;
  double matrix_scale_ = 1;
};

// The name of a number in a row of the kind, as its CSV header has it.
std::string_view field_name(const kind_info &kind, int field) {
  std::string_view names = kind.csv;
  for (; field > 0; --field)
    names.remove_prefix(names.find(',') + 1);
  return names.substr(0, names.find(','));
}

std::optional<misplaced> move_rows_of(element_set &set, const transform &move, const std::string &file, int threads) {
  if (!move.any())
    return std::nullopt;
  const bool points = !set.index.empty();
  const row_transform rows = points ? row_transform(move) : row_transform(*set.kind, move, file);
  constexpr std::size_t at_once = 1 << 12;
  const std::size_t n = set.data.size() / rows.fields();
  std::vector<std::optional<misplaced>> faults(n / at_once + 1);
  for_chunks(threads, n, at_once, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float *const row = &set.data[rows.fields() * i];
      float read = 0;
      const int field = rows.apply(row, read);
      if (field < 0)
        continue;
      const bool in_point = points || (set.kind->points > 0 && set.kind->roles[field] != role::length);
      const std::string_view name = in_point ? std::string_view("xyz").substr(static_cast<std::size_t>(field % 3), 1)
                                             : field_name(*set.kind, field);
      faults[begin / at_once] = {
          i, field,
          fmt::format("{} is {}, not finite in float32 after {} (read as {})", name, row[field], move.options(), read)};
      return;
    }
  });
  for (std::optional<misplaced> &f : faults)
    if (f)
      return std::move(f);
  return std::nullopt;
}

std::string non_finite(std::string_view field, double read, float result) {
  if (!std::isfinite(read))
    return fmt::format("{} is {}, not finite", field, read);
  return fmt::format("{} is {}, not finite in float32 (read as {})", field, result, read);
}

} // namespace

std::string transform::option(std::string_view what) const {
  return fmt::format("--{}-{}", what, side);
}

std::string transform::options() const {
  std::string out;
  for (const auto &[present, what] : {std::pair(scale.has_value(), "scale"), std::pair(matrix.has_value(), "matrix"),
                                      std::pair(translate.has_value(), "translate")})
    if (present)
      out += fmt::format("{}{}", out.empty() ? "" : ", ", option(what));
  return out;
}

void transform::check() const {
  under_standard_word([&] { check_numbers(*this); });
}

std::array<double, 3> transform::point(std::array<double, 3> p) const {
  return under_standard_word([&] { return moved_point(*this, p); });
}

std::optional<double> similarity_scale(const std::array<double, 12> &matrix, double slack) {
  return under_standard_word([&] { return scale_of(matrix, slack); });
}

std::optional<misplaced> move_set(element_set &set, const transform &move, const std::string &file, int threads) {
  return under_standard_word([&] { return move_rows_of(set, move, file, threads); });
}

std::array<float, 3> round_point(const transform &move, const std::array<double, 3> &read) {
  return under_standard_word([&] { return rounded_point(move, read); });
}

std::string describe_non_finite(std::string_view field, double read, float result) {
  return under_standard_word([&] { return non_finite(field, read, result); });
}

} // namespace meetc::io
