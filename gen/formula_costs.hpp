// The costs of a scene's formulas, beside counts that other generators publish.
#pragma once
#include "gen/driver.hpp"
#include "gen/ir/count.hpp"

#include <map>

namespace meetc {

// Counts of other generators, as a file gives them:
//   generators = ['one', 'another']
//   [counts]
//   'norm2(meet(S, T))' = ['15/11', '']
// By the formula's text: multiplications/additions, one for each generator, or nothing.
struct published_counts {
  std::vector<std::string> generators;
  std::map<std::string, std::vector<std::string>> of;
  std::map<std::string, location> where; // of the same, in the file
};
// Throws spec_error where the file holds something else, or names a formula twice.
published_counts read_published(const std::string &path);

// The operations of the cheapest of a formula's programs, on blades or on stored numbers.
ir::counts cheapest(const lower::formula &f);

// The cost of one formula.
struct formula_cost {
  std::string text;
  ir::counts whole;                     // of its cheapest program
  std::optional<ir::counts> per_object; // where one operand is prepared
  std::size_t bytes;                    // of its operands and values as float32
};
std::vector<formula_cost> formula_costs(const compilation &c);

// A row for each formula: multiplications/additions, scalings by powers of two, both for each object of a prepared operand,
// bytes, nanoseconds by its text where there are any, and the counts of others.
std::string formula_table(const std::vector<formula_cost> &costs, const std::map<std::string, double> &nanoseconds,
                          const published_counts &beside);
// Throws spec_error where `beside` has counts of a formula that is none of these.
void require_asked(const published_counts &beside, const std::vector<formula_cost> &costs);

} // namespace meetc
