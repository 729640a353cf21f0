// A formula on columns of numbers, as a runtime knows it: plain data and functions, which name no shape.
//
// The operands of evaluation i are rows of columns: row i of each operand, or the rows that an index names. The values are
// columns again, one for each coefficient of the result.
#ifndef MEETC_TABLE_FORMULA_TABLE_HPP
#define MEETC_TABLE_FORMULA_TABLE_HPP

#include <cstddef>
#include <cstdint>

namespace meetc {

// One stored number of many objects: that of object i is data[i * stride]. Packed rows of n numbers are n columns of
// stride n; a stride of 0 gives every object the same number.
struct column {
  const float *data = nullptr;
  std::ptrdiff_t stride = 1;
};

// One operand: its kind, and the columns that it takes.
struct formula_operand {
  const char *kind;
  const char *numbers; // the names of its stored numbers in memory order, comma-separated
  int number_count;
};

struct formula_info {
  const char *name; // as the scene asks for it: "norm2(meet(sphere, sphere))"
  const formula_operand *operands;
  int operand_count;
  const char *results; // the names of the values, comma-separated: blades as "e1_e2", a number as the function's name
  int result_count;
  int number_count; // of all operands
  // Evaluations [0, n) in float32 and in float64, within the error that the formula's header states. `in` has number_count
  // columns, those of the first operand first; `out` has result_count columns of n numbers, which overlap nothing.
  // rows: null, and evaluation i takes row i of each operand; or n times operand_count indices, and it takes the row
  // rows[operand_count * i + k] of operand k.
  void (*float32)(const column *in, const std::uint32_t *rows, std::size_t n, float *const *out);
  void (*float64)(const column *in, const std::uint32_t *rows, std::size_t n, double *const *out);
};

} // namespace meetc

#endif
