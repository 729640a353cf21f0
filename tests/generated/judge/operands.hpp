// Families of operands, from harmless to hostile. Each makes a pair of rows for any two shapes.
#ifndef MEETC_TESTS_GENERATED_OPERANDS_HPP
#define MEETC_TESTS_GENERATED_OPERANDS_HPP

#include "tests/generated/judge/numbers.hpp"
#include "tests/generated/judge/predicates.hpp"

#include <span>

namespace meetc::generated_test {

struct pair_of_rows {
  row a, b;
};

struct family {
  const char *name;
  pair_of_rows (*make)(shape a, shape b, random_numbers &random);
};

// Every row is finite, every radius >= 0, and every box in order.
std::span<const family> families();

// Makes of a box's corners, which may be any two opposite ones, the least and the greatest. Other rows stay as they are.
void put_in_order(shape kind, row &r);

// The row times 2^k, rounded where necessary. Beyond float32 it is the largest number.
row scaled(const row &r, int k);
// The row's points moved by t along each axis, rounded to float32.
row moved(shape kind, const row &r, const float t[3]);
// Gives a, a sphere, and b if it is one, radii at which the two just touch, or a step away from that, at the nearest or
// the farthest point as computed in double.
void graze(shape a, shape b, pair_of_rows &p, random_numbers &random);
// f, or a finite neighbour some steps away.
float stepped(float f, int steps);

} // namespace meetc::generated_test

#endif
