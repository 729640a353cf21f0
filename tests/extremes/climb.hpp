// A search for the pair whose fp32 sign is wrong by the largest share of its proven bound.
//
// Worst cases of a bound are rare: no random family comes near them. This search climbs: it changes one number, moves
// another to where the exact value changes its sign, and keeps the change if a wrong computed value now makes up more
// of the bound. A share of 1 would break the bound; one above 1/4 shows that a quarter of the bound would not suffice.
#ifndef MEETC_TESTS_EXTREMES_CLIMB_HPP
#define MEETC_TESTS_EXTREMES_CLIMB_HPP

#include "tests/extremes/families/subjects.hpp"

namespace meetc::extremes_test {

enum class bound_form : std::uint8_t { magnitude, per_object, whole_box };

struct summit {
  double share = 0; // |computed| / bound, where the computed value has a wrong sign
  pair_of_rows rows;
};
// Ends after this number of starts, or when the share is large enough.
summit climb(const subject &s, bound_form form, random_numbers &random, int starts, double enough);

} // namespace meetc::extremes_test

#endif
