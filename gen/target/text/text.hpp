// Kernels in readable form.
#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

// The polynomials; those of signs in differences.
std::string poly_text(const unit &u, std::size_t kernel);
// The values of a kernel of two operands as sums of products f(X) g(Y).
std::string separate_text(const unit &u, std::size_t kernel);
// The numbers of those products for all kernels of a unit.
std::string separate_table(const unit &u);
// Multiplications and additions of the programs of a kernel: all, those on one object alone, and those for the pair.
std::string counts_text(const unit &u, std::size_t kernel);
// The same for all kernels of a unit.
std::string counts_table(const unit &u);
// Programs as graphs, one line for each node.
std::string graph_text(const unit &u, std::size_t kernel);
// Programs in the order and with the names in which they are emitted.
std::string schedule_text(const unit &u, std::size_t kernel);
// Which arithmetic keeps the scene's tolerance, kernel by kernel.
std::string plan_text(const unit &u);
// The bounds of a kernel's signs as a table. Throws spec_error where there are none.
std::string bounds_table(const unit &u, std::size_t kernel);

} // namespace meetc::target
