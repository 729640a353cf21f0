// front/rounded.hpp: doubles as rows of float32, with what rounding moves, or refused where it would move any.
#ifndef MEET_FRONT_ROUNDED_HPP
#define MEET_FRONT_ROUNDED_HPP

#include "meet/front/rows.hpp"
#include "meet/io/text/rounded.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <vector>

namespace meet {
namespace detail {

inline bool is_finite(double x) {
  return (std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) != 0x7ff;
}

[[noreturn]] inline void refuse(std::size_t row, std::size_t number, double given, float nearest, const char *why) {
  char digits[32];
  const std::string value(digits, std::to_chars(digits, digits + sizeof digits, given).ptr);
  meetc::fault f;
  f.kind = meetc::fault_kind::unheld;
  f.element = row;
  f.field = static_cast<int>(number);
  f.value = nearest;
  throw meetc::input_error(f, "row " + std::to_string(row) + ": number " + std::to_string(number) + " is " + value +
                                  ", " + why);
}

} // namespace detail

// Doubles in float32, and what that has moved. The rows are a range for a set.
template <std::size_t N> struct rounded_rows {
  std::vector<std::array<float, N>> rows;
  meetc::io::rounded_numbers moved;
};

namespace detail {

// refused: the answer to the first number that moves; null: it may.
template <std::size_t N> rounded_rows<N> to_floats(const place<double> &at, const char *refused) {
  rounded_rows<N> out;
  out.rows.resize(at.count);
  const auto *const bytes = reinterpret_cast<const char *>(at.data);
  for (std::size_t row = 0; row < at.count; ++row)
    for (std::size_t k = 0; k < N; ++k) {
      double given;
      std::memcpy(&given, bytes + row * at.stride_bytes + k * sizeof given, sizeof given);
      const auto nearest = static_cast<float>(given);
      const auto back = static_cast<double>(nearest);
      out.rows[row][k] = nearest;
      if (!is_finite(given) || back == given) // prepare() refuses what is not finite
        continue;
      if (!is_finite(back))
        refuse(row, k, given, nearest, "beyond float32");
      if (refused)
        refuse(row, k, given, nearest, refused);
      out.moved.add(given > back ? given - back : back - given);
    }
  return out;
}

template <class From> constexpr std::size_t numbers_of_row() {
  if constexpr (matrix<From>)
    return From::RowsAtCompileTime == 1 || From::ColsAtCompileTime == 1 ? 1 : numbers_together<From>;
  else if constexpr (range_of_objects<const From &>)
    return row_of<std::ranges::range_value_t<const From &>>::count;
  else
    return 0;
}
template <class From> auto to_floats(const From &from, const char *refused) {
  constexpr std::size_t n = numbers_of_row<From>();
  const place<double> at = place_in<n, double>(from, "rows");
  return meetc::under_standard_word([&] { return to_floats<n>(at, refused); });
}

} // namespace detail

// Rounds a range or matrix of doubles, or of rows of them, to the nearest float32, of two to the even one. Throws input_error
// where a finite number lies beyond float32.
template <class From> auto rounded(const From &from) {
  return detail::to_floats(from, nullptr);
}
// The same numbers in float32. Throws input_error with the row and the number of the first that float32 does not hold.
template <class From> auto unmoved(const From &from) {
  return detail::to_floats(from, "which no float32 is; meet::rounded() rounds");
}

} // namespace meet

#endif
