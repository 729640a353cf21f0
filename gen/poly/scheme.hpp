// The price of a sum of products, and the Horner scheme that has it.
//
// Method: a variable that occurs in several terms is taken out, p = v * quotient + rest, and both parts are treated alike.
// estimate() takes the most frequent variable; step_of() tries all of them in short sums, and remembers what it found. Terms
// whose coefficients are all even are apart, as in x + 2 (y + z), where that costs nothing. Products with powers of two and
// negations are free, as in gen/ir/count.hpp.
#pragma once
#include "gen/poly/packed.hpp"
#include "gen/poly/price.hpp"

#include <unordered_map>

namespace meetc::poly {

// Variables with their residency, as numbers whose bitwise or joins two of them: the leaves, and values made of them.
class scheme_table {
public:
  scheme_table(std::vector<int> leaf_ranks, price by) : ranks_(std::move(leaf_ranks)), by_(by) {}

  // The variable of a value, which is the same for the same definition.
  int value(const packed &definition);
  bool has_room() const { return ranks_.size() + 1 < most_variables; }
  int rank(int variable) const { return ranks_[static_cast<std::size_t>(variable)]; }

  // How a sum with coprime coefficients is computed.
  struct step {
    enum class type { terms, take_out, apart } kind = type::terms;
    int variable = -1; // take_out
    long cost = 0;
  };
  const step &step_of(const packed &p);
  long cost(const packed &p);
  // The cost of a quick scheme, for comparisons.
  long estimate(const packed &p) const;

private:
  std::vector<int> ranks_;
  price by_;
  std::unordered_map<packed, int, packed_hash> values_;
  std::unordered_map<packed, step, packed_hash> steps_;

  int rank(product_of f) const;
  int rank(const packed &p) const;
  long unit(int rank) const { return by_ == price::pair && rank == 3 ? 256 : 1; }
  long product_cost(const packed_term &t) const;
  long terms_cost(const packed &p) const;
  std::vector<int> most_frequent(const packed &p, std::size_t all_below) const;
  step best_step(const packed &p);
};

// The terms with odd coefficients, and the others.
std::pair<packed, packed> odd_and_even(const packed &p);
bool is_power_of_two(std::int64_t c);

} // namespace meetc::poly
