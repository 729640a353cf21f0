// Predicates with one mistake, to see whether the families find it.
#ifndef MEETC_TESTS_EXTREMES_MUTANTS_HPP
#define MEETC_TESTS_EXTREMES_MUTANTS_HPP

#include "tests/extremes/families/subjects.hpp"

namespace meetc::extremes_test {

enum class mutation : std::uint8_t {
  none,           // the harness by itself finds nothing
  quarter_factor, // every bound K M is a quarter of it: by fp32, fp64, fp64x2
  quarter_box,    // the same for the box form: by its per-object and its static bounds
  equal_points,   // any two equal points make every sign zero: by fp32
  degree_above,   // values are taken for multiples of g^(k+1): by fp64 and fp64x2
  degree_below,   // of g^(k-1): the same
  wider_window    // exact arithmetic is trusted for some bits more: by the exact rung
};
inline constexpr mutation mutations[] = {mutation::none,         mutation::quarter_factor, mutation::quarter_box,
                                         mutation::equal_points, mutation::degree_above,   mutation::degree_below,
                                         mutation::wider_window};
const char *name_of(mutation m);

// The rungs, as bits, that claim a wrong sign for a mutated predicate. Only those that the mutation concerns are run.
unsigned wrong_signs(const subject &s, mutation m, const float *a, const float *b, float side);

} // namespace meetc::extremes_test

#endif
