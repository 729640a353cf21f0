// In how many points lines meet a sphere: the sign of B^2 of their meets, as in the paper.
#include <cga/cga_runtime.hpp>
#include <cstdio>
#include <meet/core/query/evaluate.hpp>

int main() {
  // Three lines along x, each through two points, and one sphere; packed rows in the order of the spec.
  const float lines[] = {0, 0, 0, 1, 0, 0, 0, 2, 0, 1, 2, 0, 0, 3, 0, 1, 3, 0}, sphere[] = {5, 0, 0, 2};
  const meetc::formula_info &square = meetc::formula_named(cga::catalogue(), "norm2(meet(sphere, line))");
  meetc::column of_sphere[4], of_lines[6];
  meetc::columns_of(sphere, of_sphere);
  meetc::columns_of(lines, of_lines);
  for (meetc::column &number : of_sphere)
    number.stride = 0; // one sphere for all lines
  const meetc::operand_columns operands[] = {{of_sphere, 3}, {of_lines, 3}};
  float values[3];
  float *const out[] = {values};
  meetc::evaluate(square, operands, out);
  for (const float b2 : values)
    std::printf("B^2 = %g: %s\n", b2, b2 > 0 ? "two points" : b2 == 0 ? "one point" : "none");
}
