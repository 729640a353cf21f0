// core/query/evaluate.hpp: the values of a formula, such as B and B² of a meet, for many objects.
//
// Three ways to say which objects: row i of every operand (column by column), listed rows, and the pairs that collide() finds
// in prepared sets. Numbers come and go as structures of arrays: a column for each stored number, and one for each
// coefficient of the value. Values have the error that the formula's header states; a NaN or an infinity among the numbers
// stays one where it is read. Values in float32 on AVX2, AVX-512, NEON and a CUDA device are the same, bit for bit; those of
// the baseline of x86-64, which has no fused multiply-add, may differ within the error.
#ifndef MEETC_CORE_QUERY_EVALUATE_HPP
#define MEETC_CORE_QUERY_EVALUATE_HPP

#include "meet/core/sets/prepared.hpp"
#include "meet/core/threads/execution.hpp"
#include "meetc/table/table.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace meetc {

// The formula that the scene asks for by this text, whatever its spaces; null: there is none.
const formula_info *find_formula(const catalogue &all, std::string_view text);
// The same; throws usage_error, which lists all, where there is none.
const formula_info &formula_named(const catalogue &all, std::string_view text);

// The objects of one operand: a column for each of its stored numbers.
struct operand_columns {
  std::span<const column> numbers;
  std::size_t objects = 0;
};

// Packed rows as columns; `into` has as many as a row has numbers.
void columns_of(const float *rows, std::span<column> into);

// Value i takes object i of every operand; all have as many objects. out: a column of as many numbers for each of
// formula.result_count, which overlap neither each other nor an operand. on: how many threads, 0 is all
// cores, and a token that may stop it. Throws usage_error where the operands are not as the formula's, and `cancelled`, after
// which out means nothing. All of these do.
void evaluate(const formula_info &formula, std::span<const operand_columns> operands, std::span<float *const> out,
              const execution &on = 0);
void evaluate(const formula_info &formula, std::span<const operand_columns> operands, std::span<double *const> out,
              const execution &on = 0);

// Value i takes object rows[k + i * operand_count] of operand k. Throws std::out_of_range for an object that is not there,
// before anything is written.
void evaluate(const formula_info &formula, std::span<const operand_columns> operands,
              std::span<const std::uint32_t> rows, std::span<float *const> out, const execution &on = 0);
void evaluate(const formula_info &formula, std::span<const operand_columns> operands,
              std::span<const std::uint32_t> rows, std::span<double *const> out, const execution &on = 0);

// The values of a formula: `columns` columns of `count` numbers, one after another.
template <class Number> struct formula_values {
  std::size_t count = 0;
  std::vector<Number> numbers;

  std::span<const Number> column(int k) const { return {numbers.data() + static_cast<std::size_t>(k) * count, count}; }
};

// The columns of all operands, one after another. Throws usage_error where the operands are not as the formula's,
// and, for values column by column, where they have different numbers of objects.
std::vector<column> columns_of(const formula_info &formula, std::span<const operand_columns> operands);
std::size_t common_objects(const formula_info &formula, std::span<const operand_columns> operands);
// Throws usage_error or std::out_of_range where these are no rows of the operands.
void require_rows(const formula_info &formula, std::span<const operand_columns> operands,
                  std::span<const std::uint32_t> rows, const execution &on = 0);

// The values for pairs of elements of two prepared sets, as they were posed when they were prepared: pairs[i].a is an element
// of a, the formula's first operand. out: as above. Throws usage_error where the formula does not take these two kinds, and
// std::out_of_range for an element that a set does not hold, before anything is written.
void evaluate(const formula_info &formula, const prepared &a, const prepared &b, std::span<const index_pair> pairs,
              std::span<float *const> out, const execution &on = 0);
void evaluate(const formula_info &formula, const prepared &a, const prepared &b, std::span<const index_pair> pairs,
              std::span<double *const> out, const execution &on = 0);
template <class Number>
formula_values<Number> evaluate(const formula_info &formula, const prepared &a, const prepared &b,
                                std::span<const index_pair> pairs, const execution &on = 0);

} // namespace meetc

#endif
