// The kinds that kernels need, with all worked out that a target writes of them: names, memory order, hulls, and how
// their blades are made.
#pragma once
#include "gen/lower/kernel.hpp"

#include <optional>

namespace meetc::lower {

struct lowered_kind {
  std::string name;
  int declared = 0;                // its place among the spec's kinds
  bool is_element = false;         // a predicate takes it
  std::vector<lang::field> fields; // of its struct, in memory order
  std::vector<stored_real> reals;  // its row
  int points = 0;                  // how many of the groups of reals are positions
  // The coefficients of its blade, and the ways to make it; nothing where no formula reads or gives it.
  std::vector<basis_blade> blades;
  std::vector<blade_maker> makers;
  // Of elements and of kinds with a rule, and only after enclose().
  std::optional<enclosure> enclosed;

  bool has_blade() const { return !blades.empty(); }
};

// The kinds of operands, results and constructors, each after those that it holds.
std::vector<lowered_kind> kinds_of(const model &m, const std::vector<kernel> &kernels);

// Throws spec_error where a predicate takes a kind that has no hull.
void enclose(const model &m, std::vector<lowered_kind> &kinds);

} // namespace meetc::lower
