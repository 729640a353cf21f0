#include "meet/core/views/collinear.hpp"

#include <meetc/decide/bytecode.hpp>

#include <cmath>

namespace meetc {
namespace {

// By the cross product of two edges in integers that are wide enough.
bool collinear_in_integers(const float *row) {
  const grid g = grid_of(row, 9);
  // Differences need one more bit, and the difference of two products another one.
  const int limbs = (2 * (g.bits() + 1) + 1) / 64 + 1;
  std::uint64_t registers[13][9];
  for (int i = 0; i < 9; ++i)
    to_limbs(row[i], g.low, limbs, registers[i]);
  bool zero = true;
  for (std::uint16_t k = 0; k < 3; ++k) {
    using enum opcode;
    const auto l = static_cast<std::uint16_t>((k + 1) % 3);
    const auto of = [](int corner, std::uint16_t axis) { return static_cast<std::uint16_t>(3 * corner + axis); };
    const instruction cross[] = {{subtract, 9, of(1, k), k}, {subtract, 10, of(2, l), l}, {multiply, 11, 9, 10},
                                 {subtract, 9, of(1, l), l}, {subtract, 10, of(2, k), k}, {multiply, 12, 9, 10},
                                 {subtract, 11, 11, 12},     {take_sign, 0, 11, 0}};
    sign s = sign::zero;
    for (const instruction &t : cross)
      execute(t, limbs, registers, &s);
    zero = zero && s == sign::zero;
  }
  return zero;
}

} // namespace

// In doubles a difference of floats and a product of two have relative errors of 2^-53 each, and nothing under- or overflows:
// a difference of products is off by at most 2^-50 times the sum of their magnitudes.
bool collinear(const float *row) {
  const auto edge = [row](int corner, int axis) {
    return static_cast<double>(row[3 * corner + axis]) - static_cast<double>(row[axis]);
  };
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    const double x = edge(1, k) * edge(2, l), y = edge(1, l) * edge(2, k);
    if (std::fabs(x - y) > 0x1p-50 * (std::fabs(x) + std::fabs(y)))
      return false;
  }
  return collinear_in_integers(row);
}

} // namespace meetc
