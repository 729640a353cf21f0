// app/input/matrix.hpp: the matrix of a motion from the numbers that a user writes.
#ifndef MEETC_APP_INPUT_MATRIX_HPP
#define MEETC_APP_INPUT_MATRIX_HPP

#include <array>
#include <span>
#include <string>

namespace meetc::app {

// 12 numbers are a row-major 3x4 matrix, and 16 one of 4x4 whose last row is 0 0 0 1. Throws failure that begins with `where`
// for another number of them or another last row.
std::array<double, 12> matrix_of(std::span<const double> numbers, const std::string &where);

} // namespace meetc::app

#endif
