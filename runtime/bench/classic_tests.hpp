// bench/classic_tests.hpp: the classic tests of one element against many, compiled for each instruction set.
//
// Problem: our kernels are compiled for several instruction sets, so what they are compared with must be as well.
// Method: classic_tests.cpp is compiled once more for each set, in a namespace of its own (meetc/instruction_set.hpp), and
// is reached through a table of functions. The tests read what they need in the form that suits each: packed rows, planes
// that were computed once, or columns, where each field of all rows lies together.
#ifndef MEETC_BENCH_CLASSIC_TESTS_HPP
#define MEETC_BENCH_CLASSIC_TESTS_HPP

#include <meetc/support.hpp>

#include <cstddef>

namespace meetc::baselines {

// A set for the classic tests. Columns have room for whole lanes: `stride` is a multiple of the widest.
struct classic_rows {
  const float *rows; // packed: 9 floats for a triangle, 4 for a ball
  const float
      *planes; // 4 for each triangle: its normal, and the offset with which its plane is normal . x + offset = 0
  const float *columns; // field f of row i at columns[f * stride + i]: the row's fields, then the plane's
  std::size_t stride;
};

// Row i of a against n rows of b from `from` on, a multiple of the widest lanes.
using classic_function = void (*)(const classic_rows &a, std::size_t i, const classic_rows &b, std::size_t from,
                                  std::size_t n, answer *out);

struct classic_table {
  instruction_set compiled_for;
  classic_function moller;           // epsilon 0, as published: each pair computes the planes
  classic_function moller_stored;    // with stored planes: the same test without what an object alone decides
  classic_function moller_lanes;     // the same in lanes; its answers are those of moller_stored
  classic_function guigue_devillers; // as published, in float
  classic_function balls;            // d^2 <= (r1 + r2)^2
  classic_function balls_lanes;      // the same in lanes, with the same answers
};

// Null where this build lacks the set or the processor does not run it.
const classic_table *classic_tests_for(instruction_set set);

} // namespace meetc::baselines

#endif
