// Draws formulas: a definition of one to four parameters, and the kernel that applies it to kinds, perhaps through other
// calls.
#ifndef MEETC_TESTS_FUZZ_DRAW_HPP
#define MEETC_TESTS_FUZZ_DRAW_HPP

#include "tests/gen/fuzz/expression.hpp"
#include "tests/gen/fuzz/space.hpp"

#include <cstdint>

namespace meetc::fuzz {

struct formula {
  const space *in;
  long number;                           // names the definition: f12
  expression_ptr body;                   // over the parameters
  std::vector<expression_ptr> arguments; // by parameter, over the operands; each operand occurs once, in order
  std::vector<std::string> kinds;        // of the operands

  std::string function() const;   // "f12"
  std::string definition() const; // "A*B"
  std::string kernel() const;     // "f12(gp(g1, g1), even)"
  std::string text() const;       // both, and the algebra, to be read
};

// Calls `visit` with each formula that has one part less. Ends early where it returns true.
bool for_each_smaller(const formula &f, const std::function<bool(const formula &)> &visit);

// The same formula for the same seed and number.
formula draw(std::uint64_t seed, long number);

// The cost of expanding the formula, roughly and from above: the terms of the longest product, and the products of
// coefficients where its parts are values.
struct effort {
  double terms, products;
};
effort effort_of(const formula &f);

} // namespace meetc::fuzz

#endif
