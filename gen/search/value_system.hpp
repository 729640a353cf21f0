// Several polynomials at once, over leaves and over values made of them: a form from which a search for programs starts.
#pragma once
#include "gen/poly/poly.hpp"

#include <memory>

namespace meetc::search {

// Polynomials that are zero for all operands that count: because they define a value, or because a kind states so.
struct value_system {
  std::shared_ptr<poly::ring> numbers; // the leaves, then one variable for each value
  std::vector<poly::poly> values;      // value i, in the leaves and the values before it
  std::vector<poly::poly> outputs, relations;

  int leaves() const { return numbers->size() - static_cast<int>(values.size()); }
  poly::poly variable_of(std::size_t value) const {
    return poly::poly::variable(*numbers, leaves() + static_cast<int>(value));
  }
};

// The system of these outputs alone. They are in `leaves`, as relations are.
value_system system_of(const poly::ring &leaves, const std::vector<poly::poly> &outputs,
                       const std::vector<poly::poly> &relations = {});
// The same outputs with room for more values, which follow those that are there.
value_system with_values(const value_system &s, std::size_t more);

// Each value is primitive and has two or more terms; others are written out.
value_system simplified(const value_system &s);

// The polynomials of the leaves that p, which is in s.numbers, stands for.
std::vector<poly::poly> in_leaves(const value_system &s, const std::vector<poly::poly> &of, const poly::ring &leaves);

// v and w, leaves of one group, are replaced by v + w and v - w where that shortens the outputs; nothing where it does not.
// group[v]: of leaf v; -1 where it stays.
std::optional<value_system> with_pairs(const value_system &s, const std::vector<int> &group);

} // namespace meetc::search
