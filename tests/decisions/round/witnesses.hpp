// Rational operands for every case of the proof, judged by gen/oracle, which shares nothing with any sign.
#ifndef MEETC_TESTS_DECISIONS_ROUND_WITNESSES_HPP
#define MEETC_TESTS_DECISIONS_ROUND_WITNESSES_HPP

#include "tests/decisions/round/decision.hpp"

namespace meetc::decisions_round {

struct witness {
  std::vector<rational> a, b;     // rows, in store order
  std::vector<rational> products; // the values of the variables of gram::ring()
  std::string where;              // the case of the proof that it is in
};

// Operands from a small lattice, whose radius reaches the nearest or the farthest point exactly where that is
// rational, and a little more or less. The same seed gives the same list.
std::vector<witness> witnesses(const emitted &e, int count, unsigned seed);

// Every case that witnesses of the predicate can be in.
std::vector<std::string> cases_of(const emitted &e);

// By exact distances of hulls. Of the lone sign: whether the point is in the ball.
bool touching(const emitted &e, const witness &w);
// Which signs the stated atoms of a decision have.
std::vector<int> signs_of(const decision &d, const witness &w);

} // namespace meetc::decisions_round

#endif
