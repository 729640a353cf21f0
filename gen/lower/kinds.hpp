// The kinds that kernels need, with all that a target writes about them: names, memory order, hulls, and how to compute
// their blades.
#pragma once
#include "gen/lower/analytic/analytic.hpp"

#include <optional>

namespace meetc::lower {

struct lowered_kind {
  std::string name;
  int declared = 0;                // its index among the spec's kinds
  bool is_element = false;         // a predicate on sets takes it
  std::vector<lang::field> fields; // the members of its struct, in memory order
  std::vector<stored_real> reals;  // its row
  int points = 0;                  // the number of positions among the groups of reals
  // The coefficients of its blade, and the ways to compute it; both empty if no formula reads or returns it.
  std::vector<basis_blade> blades;
  std::vector<blade_maker> makers;
  // For elements and kinds with a rule, after enclose().
  std::optional<enclosure> enclosed;

  bool has_blade() const { return !blades.empty(); }
};

// The kinds of operands, results and constructors, each after those that it contains.
std::vector<lowered_kind> kinds_of(const model &m, const std::vector<kernel> &kernels,
                                   const std::vector<analytic_kernel> &analytic = {});

// Whether there are sets of a predicate's operands: those of kinds without a hull cannot be searched.
bool on_sets(const kernel &k);

void enclose(const model &m, std::vector<lowered_kind> &kinds);

} // namespace meetc::lower
