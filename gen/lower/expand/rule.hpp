// The rule that a valid element of a kind obeys, and what follows from it for signs.
//
// Problem: B^2 of a point pair and a plane is |p - q|^2 times the product of the sides of p and q. Where only the sign is
// wanted, the first factor is wasted work, if it is known to be positive.
// Method: a kind's `where` says so for its elements ('r > 0', 'p != q'). A polynomial is positive on valid operands if,
// written in differences, each of its terms is a positive number times even powers and numbers that are not negative, and
// if among the terms are squares that do not all vanish: those of the components of a vector between two points that
// differ, of a vector that is not 0, or numbers that are positive.
// Limits: that one point is not above another ('low <= high') is checked of elements, and says nothing of signs here. The
// condition is sufficient, not necessary. It is exact: nothing is dropped that may be zero on valid operands.
// On operands that are not valid, a sign without its positive factors means nothing.
#pragma once
#include "gen/lower/expand/model.hpp"
#include "gen/poly/local_origin.hpp"

#include <optional>

namespace meetc::lower {

struct element_rule {
  enum class type : std::uint8_t { not_negative, positive, not_zero, differ, not_above } kind;
  // Stored numbers of the kind: one that is compared with 0, or those of which one is not 0; or two points, by axis.
  std::vector<int> x, y;
  std::string text; // as the spec says it: "r >= 0"
};

// The rule of a kind's `where`. Throws spec_error where it is not a rule.
std::optional<element_rule> rule_of(const model &m, const lang::kind &k);

// Whether a row of stored numbers obeys a rule. x is not above y if no coordinate is greater.
bool obeys(const std::optional<element_rule> &rule, const std::vector<rational> &row);

// The signs of a kernel's stored numbers that are known by the rules of all operands.
struct known_signs {
  const poly::local_origin *local = nullptr; // borrowed; none: nothing is known
  std::vector<int> not_negative, positive;   // base variables; the former contain the latter
  std::vector<std::vector<int>> not_zero;    // numbers of which one is not zero, as local variables

  // Adds a rule for an operand whose stored numbers begin at `first`.
  void add(const element_rule &rule, int first);
  // Whether p > 0 on all valid operands, by the condition above.
  bool is_positive(const poly::poly &p) const;
};

} // namespace meetc::lower
