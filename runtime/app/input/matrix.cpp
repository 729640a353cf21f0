#include "meet/app/input/matrix.hpp"

#include "meet/app/input/failure.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meetc::app {

std::array<double, 12> matrix_of(std::span<const double> numbers, const std::string &where) {
  if (numbers.size() != 12 && numbers.size() != 16)
    throw failure(
        fmt::format("{}: 12 numbers expected, or 16, with commas between them, {} given", where, numbers.size()));
  for (std::size_t i = 12; i < numbers.size(); ++i)
    if (numbers[i] != (i == 15 ? 1 : 0))
      throw failure(fmt::format("{}: the last row of the 4x4 matrix is {},{},{},{}, not 0,0,0,1", where, numbers[12],
                                numbers[13], numbers[14], numbers[15]));
  std::array<double, 12> out{};
  std::copy_n(numbers.begin(), 12, out.begin());
  return out;
}

} // namespace meetc::app
