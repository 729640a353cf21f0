// Every emitted stage of the shipped scene with the compiler's own analysis of it, behind function pointers: run in
// tiny precision, and run in integers.
#ifndef MEETC_TESTS_BOUNDS_STAGES_HPP
#define MEETC_TESTS_BOUNDS_STAGES_HPP

#include "gen/driver.hpp"
#include "tests/gen/bound/counting.hpp"
#include "tests/gen/bound/tiny.hpp"

#include <meetc/decide/boxes.hpp>
#include <meetc/decide/decide.hpp>
#include <string>
#include <vector>

namespace meetc::bounds_test {

using meetc::int128;

// The stored numbers of a pair, object A's first: integers, each worth 2^scale.
struct sample {
  std::vector<std::int64_t> numbers;
  int scale = 0;
};

struct stage_case {
  std::string name; // "segment_triangle, rare", "segment_triangle, rare, unfused"
  int inputs_a, inputs_b, signs;
  int degree, growth, window, floor_fp32, floor_fp64, box_lowest, box_highest;
  bool mixed, fused;
  const lower::kernel *kernel;
  const ir::program *code;
  const bound::kernel_bounds *analysed;
  const bound::stage_bounds *bounds;
  meetc::factors (*factor)(int);
  meetc::box_factor (*box)(int);
  int (*degree_of)(int);
  unsigned (*zero_if)(int);
  unsigned (*coincident)(const float *, const float *);
  // Values and magnitudes by sign, with leaves of at least `floor` (0: none), in tiny::format.
  void (*in_tiny)(const sample &s, double floor, tiny *v, tiny *m);
  // The exact values, in units of 2^(scale degree), and the exact magnitudes of the leaves as tiny computes
  // them.
  void (*in_integers)(const sample &s, double floor, int128 *v, int128 *m);
  // The values that the exact rung's window form computes, as alternating high and low words.
  void (*in_fp64)(const sample &s, double *words);
  // The roundings of each value and of each magnitude, in counted's arithmetic.
  void (*count)(counted *v, counted *m);

  int inputs() const { return inputs_a + inputs_b; }
  // Inputs below 2^bits keep every value in an int128.
  int bits() const { return (124 - growth) / degree; }
};

const compilation &shipped_scene();
const std::vector<stage_case> &all_stages(); // in the schedule with fma
const std::vector<stage_case> &both_schedules();

} // namespace meetc::bounds_test

#endif
