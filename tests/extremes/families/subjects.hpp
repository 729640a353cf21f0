// The subjects of the tests: ten predicates of the shipped scene and its three lone signs, behind one type. box_box is left
// out: its signs are those of differences of two numbers, which no rounding changes.
#ifndef MEETC_TESTS_EXTREMES_SUBJECTS_HPP
#define MEETC_TESTS_EXTREMES_SUBJECTS_HPP

#include "check.hpp"
#include "tests/generated/judge/operands.hpp"

#include <string>
#include <string_view>

namespace meetc::extremes_test {

using generated_test::pair_of_rows;
using generated_test::random_numbers;
using generated_test::row;
using generated_test::shape;

// Answers are 0 and 1, or -1, 0 and 1 for a lone sign.
struct subject {
  const char *name;
  shape a, b;
  bool surface; // spheres count as surfaces, else as solids
  bool sign;    // one sign, not a decision
  outcome (*check)(const float *a, const float *b, float side, const int *known);
  int (*truth)(const float *a, const float *b);   // by the integers
  int (*hit)(const float *a, const float *b);     // the public entry point
  int (*decided)(const float *a, const float *b); // the exact rung
  int (*plain32)(const float *a, const float *b); // no bound: the sign of what was computed
  int (*plain64)(const float *a, const float *b);
  bool (*integers_hold)(const float *a, const float *b); // every sign is that of the value in rationals
  void (*run_all)(const float *a, const float *b);       // every rung, whatever it answers
};
std::span<const subject> subjects();

// Their types: f(P(), name).
template <class F> void for_each_type(F &&f) {
  generated_test::for_each_predicate([&](auto p) { f(typename decltype(p)::type(), p.name); });
  cga::for_each_sign([&](auto p) { f(typename decltype(p)::type(), p.name); });
}
// make(P()) for the subject's type.
template <class Make> auto for_type_of(const subject &s, Make &&make) {
  decltype(make(cga::ball_ball())) out{};
  for_each_type([&](auto p, std::string_view name) {
    if (name == s.name)
      out = make(p);
  });
  return out;
}

const subject &subject_named(const char *name);

// The side of the least box that holds the pair: a power of two that no difference of two coordinates and no
// radius exceeds. 0 where there is none in float32.
float box_side(shape a, const row &x, shape b, const row &y);

// As C++ hexadecimal floats, for use in a test.
std::string text(const pair_of_rows &p);

} // namespace meetc::extremes_test

#endif
