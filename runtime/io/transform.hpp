// Moves the elements of a file before they are rounded to float32.
//
// Every operation is in double, in a fixed order and without fused multiply-add; then each coordinate is rounded once.
// The resulting float32 numbers are the input for which the answer is exact.
#ifndef MEETC_IO_TRANSFORM_HPP
#define MEETC_IO_TRANSFORM_HPP

#include "meetc/support.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::io {

// The names of the options, which messages use as well.
inline constexpr const char *scale_option = "--scale-b", *matrix_option = "--matrix-b",
                            *translate_option = "--translate-b";

// Applied in the order scale, matrix, translate. A member that is present counts as a transform even if it changes
// nothing: decimals are then read as double. Without a transform they are rounded directly from text to float32.
struct transform {
  std::optional<double> scale;                  // finite and above 0
  std::optional<std::array<double, 12>> matrix; // row-major 3x4: ((m00 x + m01 y) + m02 z) + m03
  std::optional<std::array<double, 3>> translate;

  bool any() const { return scale || matrix || translate; }
  std::string options() const; // the ones that are present: "--scale-b, --translate-b"
  // Throws io::error where a number breaks the rules above.
  void check() const;
  std::array<double, 3> point(std::array<double, 3> p) const;
};

// The factor by which a matrix scales lengths if it is a similarity, perhaps with a rotation or a reflection: its
// columns have equal lengths and right angles, to 2^-48 of their squared length (sixteen units in the last place, which
// decimals with 17 digits and a product of some rotations computed in double satisfy). The result is the length of the
// first column, sqrt((m00*m00 + m10*m10) + m20*m20) in double. There is none for any other matrix.
std::optional<double> similarity_scale(const std::array<double, 12> &matrix);

// Moves one row of a kind by the roles of its fields. Consecutive x, y, z are a point; a length is multiplied by the
// scale and then by the matrix's similarity_scale(), in double, and rounded once.
class row_transform {
public:
  // Throws io::error, beginning with `file`, where the kind cannot be moved in this way: a length with a matrix that is
  // not a similarity, a box with one that does not keep the axes, or any transform with a field of another role.
  row_transform(const kind_info &kind, const transform &move, const std::string &file);

  // Takes kind.fields numbers and returns as many. The result may be infinite or NaN; the caller refuses that.
  void apply(std::span<const double> in, std::span<float> out) const;

private:
  transform move_;
  std::vector<role> roles_; // empty: nothing moves
  double matrix_scale_ = 1;
};

// The point, moved and rounded. It may be infinite or NaN.
std::array<float, 3> round_point(const transform &move, const std::array<double, 3> &read);

// "x is inf, not finite", followed by the transform where the number was finite as read.
std::string describe_non_finite(std::string_view field, double read, float result, const transform &move);

} // namespace meetc::io

#endif
