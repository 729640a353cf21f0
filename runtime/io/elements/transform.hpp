// Moves the elements of a file, after their numbers were rounded to float32.
//
// Every operation is in double, in a fixed order and without fused multiply-add; then each coordinate is rounded once, as
// the library does with a pose. The resulting float32 numbers are the input for which the answer is exact. Everything here
// works under any floating-point control word.
#ifndef MEETC_IO_ELEMENTS_TRANSFORM_HPP
#define MEETC_IO_ELEMENTS_TRANSFORM_HPP

#include "meet/io/elements/element_set.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::io {

// Applied in the order scale, matrix, translate. A transform that changes nothing changes no bit.
struct transform {
  std::optional<double> scale;                  // finite and above 0
  std::optional<std::array<double, 12>> matrix; // row-major 3x4: ((m00 x + m01 y) + m02 z) + m03
  std::optional<std::array<double, 3>> translate;
  char side = 'b'; // the letter of the options that messages name

  bool any() const { return scale || matrix || translate; }
  std::string option(std::string_view what) const; // "--scale-b"
  std::string options() const;                     // the ones that are present: "--scale-b, --translate-b"
  // Throws io::error where a number breaks the rules above.
  void check() const;
  std::array<double, 3> point(std::array<double, 3> p) const;
};

// Sixteen units in the last place of a double, which decimals with 17 digits and a product of some rotations computed in double
// satisfy; and of a float.
inline constexpr double similarity_slack = 0x1p-48, similarity_slack_float32 = 0x1p-19;

// The factor by which a matrix scales lengths if it is a similarity, perhaps with a rotation or a reflection: its
// columns have equal lengths and right angles, to `slack` of their squared length. The result is the length of the
// first column, sqrt((m00*m00 + m10*m10) + m20*m20) in double. None for any other matrix.
std::optional<double> similarity_scale(const std::array<double, 12> &matrix, double slack = similarity_slack);

// A number that a transform moved out of float32.
struct misplaced {
  std::size_t row = 0; // of the set's data: a vertex, a facet or an element
  int field = 0;       // of the row
  std::string what;    // "y is inf, not finite in float32 after --scale-b (read as 1e+20)"
};

// Moves all numbers of a set by the roles of its kind's fields, on several threads. Consecutive x, y, z are a point; a length
// is multiplied by the scale and then by the matrix's similarity_scale(), in double, and rounded once. Returns the first
// number that is then not finite; the set is of no use in that case. Throws io::error, beginning with `file`, where the kind
// cannot be moved in this way: a length with a matrix that is not a similarity, a box with one that does not keep the
// axes, or any transform with a field of another role.
std::optional<misplaced> move_set(element_set &set, const transform &move, const std::string &file, int threads);

// The point, moved and rounded. It may be infinite or NaN.
std::array<float, 3> round_point(const transform &move, const std::array<double, 3> &read);

// "x is inf, not finite" for a number that was read so; "(read as 1e+39)" follows where it is finite in double.
std::string describe_non_finite(std::string_view field, double read, float result);

} // namespace meetc::io

#endif
