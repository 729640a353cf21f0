// Bounds of the values of a program, for the exact rung, which computes in integers.
#pragma once
#include "gen/ir/arena.hpp"

namespace meetc::bound {

// If the inputs are integers below 2^bits in magnitude, a value is below 2^(degree * bits + bits_more). An input of weight w is
// below 2^(w * bits), and its degree is w.
struct growth {
  int degree = 0, bits_more = 0;
};

// The growth of every node that the results need, by id. Empty where the values are not homogeneous in the inputs or a
// constant is not an integer. With `differences`, 2^bits also bounds the differences of inputs. All weights are 1 if none is
// given.
std::vector<growth> growths(const ir::program &p, bool differences = false, const std::vector<int> &weights = {});

} // namespace meetc::bound
