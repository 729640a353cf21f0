// Rational operands for every case of the proof, judged by gen/oracle, which is independent of all signs.
#ifndef MEETC_TESTS_DECISIONS_ROUND_WITNESSES_HPP
#define MEETC_TESTS_DECISIONS_ROUND_WITNESSES_HPP

#include "tests/decisions/round/decision.hpp"

namespace meetc::decisions_round {

struct witness {
  std::vector<rational> a, b;     // rows, in store order
  std::vector<rational> products; // the values of the variables of gram::ring()
  std::string where;              // its case of the proof
};

// Operands from a small lattice, whose radius reaches the nearest or the farthest point exactly if that distance is
// rational, and slightly more or less. The same seed gives the same list.
std::vector<witness> witnesses(const emitted &e, int count, unsigned seed);

// All possible cases of witnesses of the predicate.
std::vector<std::string> cases_of(const emitted &e);

// The answer by exact distances of hulls; for the single sign, whether the point is in the ball.
bool touching(const emitted &e, const witness &w);
// The signs of the stated atoms of a decision.
std::vector<int> signs_of(const decision &d, const witness &w);

} // namespace meetc::decisions_round

#endif
