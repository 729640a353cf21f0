#include "meet/core/views/collinear.hpp"

#include <meetc/decide/bytecode.hpp>

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

bool collinear(const float *row) {
  return may_be_collinear(row) && collinear_in_integers(row);
}

} // namespace meetc
