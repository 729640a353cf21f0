// A program in floating point: where it is exact, and how far it may be off.
#ifndef MEETC_TESTS_FUZZ_ROUNDING_HPP
#define MEETC_TESTS_FUZZ_ROUNDING_HPP

#include "gen/ir/arena.hpp"

#include <vector>

namespace meetc::fuzz {

using ir::rational;

// A type of floating point: its bits, and half of the least positive number as a bound of what underflow loses.
struct precision {
  int bits;
  double unit, lost;
};
inline constexpr precision double_precision{53, 0x1p-53, 0x1p-1074}, float_precision{24, 0x1p-24, 0x1p-149};

// Whether each constant and each value that the program computes from these inputs is a double, products in fused
// multiply-adds too. Then every order of rounding gives the exact results.
bool is_exact(const ir::program &p, const std::vector<rational> &inputs);

// A number that is computed: a bound of its exact magnitude, and of what the computed one differs.
struct bounded {
  double size, error;
};
// Each operation adds half a unit of its result's greatest magnitude; a fused multiply-add counts as two.
std::vector<bounded> error_bounds(const ir::program &p, const std::vector<bounded> &inputs, const precision &of);

} // namespace meetc::fuzz

#endif
