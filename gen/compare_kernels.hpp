// The kernels of scenes beside each other: the same kernel in two algebras, or under two definitions.
#pragma once
#include "gen/driver.hpp"

#include <string>
#include <vector>

namespace meetc {

// A kernel's operations for a pair as mul/add, its sign atoms, and the widest of their bounds in fp32, in units of the
// rounding 2^-24 of the sum of magnitudes. A formula has neither atoms nor a bound: empty.
struct kernel_figures {
  std::string name, operations, atoms, bound;
};

std::vector<kernel_figures> kernel_figures_of(const compilation &c); // compiled

// Rows of a table: the kernels by name in the order in which they first occur, with three columns for each scene.
std::vector<std::vector<std::string>> kernel_rows(const std::vector<std::string> &scenes,
                                                  const std::vector<std::vector<kernel_figures>> &all);

} // namespace meetc
