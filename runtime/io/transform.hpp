// Moves the elements of a file before they are rounded to float32.
//
// Every operation is done in double, in a fixed order and without fused multiply-add, then each coordinate is
// rounded once: the float32 numbers that result are the input whose answer is exact.
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

// What the program calls them; messages do too.
inline constexpr const char *scale_option = "--scale-b", *matrix_option = "--matrix-b",
                            *translate_option = "--translate-b";

// Applied in the order scale, matrix, translate. A member that is present counts as a transform even if it
// changes nothing: decimals are then read as double, and without any they round from text straight to
// float32.
struct transform {
  std::optional<double> scale;                  // finite and above 0
  std::optional<std::array<double, 12>> matrix; // row-major 3x4: ((m00 x + m01 y) + m02 z) + m03
  std::optional<std::array<double, 3>> translate;

  bool any() const { return scale || matrix || translate; }
  std::string options() const; // those that are present: "--scale-b, --translate-b"
  // Throws io::error where a number breaks the rules above.
  void check() const;
  std::array<double, 3> point(std::array<double, 3> p) const;
};

// How much a matrix scales lengths, where it is a similarity, turned or mirrored: its columns are equally
// long and at right angles, to 2^-48 of their squared length (sixteen units in the last place: decimals with
// 17 digits, and a product of some rotations computed in double, pass). The answer is the first column's
// length, sqrt((m00*m00 + m10*m10) + m20*m20) in double. None for any other matrix.
std::optional<double> similarity_scale(const std::array<double, 12> &matrix);

// What moves one row of a kind, by its fields' roles: x, y, z in a row are a point, a length takes the scale
// and then the matrix's similarity_scale(), in double, and is rounded once.
class row_transform {
public:
  // Throws io::error, beginning with `file`, where the kind cannot be moved so: a length with a matrix that
  // is no similarity, any transform with a field of another role.
  row_transform(const kind_info &kind, const transform &move, const std::string &file);

  // kind.fields numbers in, as many out. The result may be infinite or NaN; the caller refuses that.
  void apply(std::span<const double> in, std::span<float> out) const;

private:
  transform move_;
  std::vector<role> roles_; // empty: nothing moves
  double matrix_scale_ = 1;
};

// The point moved and rounded; may be infinite or NaN.
std::array<float, 3> round_point(const transform &move, const std::array<double, 3> &read);

// "x is inf, not finite", and more where the number as read was finite: the transform that made it so.
std::string describe_non_finite(std::string_view field, double read, float result, const transform &move);

} // namespace meetc::io

#endif
