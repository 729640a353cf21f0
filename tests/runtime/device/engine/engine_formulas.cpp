// Formulas on a device: column by column, with one object for all, and on listed rows, against the CPU's, bit for bit where
// that fuses.
#include "engine.hpp"

#include "meet/core/device/evaluate.hpp"

#include <cmath>
#include <cstring>

namespace cuda_test {
namespace {

using namespace meetc;

// The catalogue whose lanes fuse as a device does; null: none runs here.
const catalogue *fusing() {
  for (const instruction_set set : {instruction_set::avx2, instruction_set::avx512})
    if (const catalogue *c = cga::catalogue_for(set))
      return c;
#if defined(__FMA__) || defined(__aarch64__)
  return &cga::catalogue();
#else
  return nullptr;
#endif
}

template <class Number>
void of_formula(comparison &with, const formula_info &f, std::size_t n, int layout, engine &random) {
  std::vector<std::vector<float>> numbers;
  std::vector<column> columns;
  for (int k = 0; k < f.number_count; ++k) {
    const bool one = layout == 1 && k < f.operands[0].number_count;
    const std::ptrdiff_t stride = one ? 0 : layout == 2 ? 3 : 1;
    numbers.emplace_back(one ? 1 : n * 3);
    for (float &x : numbers.back())
      x = std::ldexp(static_cast<float>(random() % 16777216) - 8388608.0F, static_cast<int>(random() % 5) - 23);
    columns.push_back({numbers.back().data(), stride});
  }
  std::vector<operand_columns> operands;
  for (int k = 0, first = 0; k < f.operand_count; first += f.operands[k++].number_count)
    operands.push_back({std::span(columns).subspan(static_cast<std::size_t>(first),
                                                   static_cast<std::size_t>(f.operands[k].number_count)),
                        n});
  std::vector<std::uint32_t> rows;
  for (std::size_t i = 0; n && i < (n + 5) * operands.size(); ++i)
    rows.push_back(static_cast<std::uint32_t>(random() % n));
  const auto compare = [&](const formula_values<Number> &there, std::size_t count, const char *what, const auto &here) {
    std::vector<Number> want(count * static_cast<std::size_t>(f.result_count));
    std::vector<Number *> out;
    for (std::size_t k = 0; k < static_cast<std::size_t>(f.result_count); ++k)
      out.push_back(want.data() + k * count);
    here(out);
    with.require("formulas",
                 there.numbers.size() == want.size() &&
                     std::memcmp(there.numbers.data(), want.data(), want.size() * sizeof(Number)) == 0,
                 std::string(f.name) + " " + what);
  };
  compare(evaluate<Number>(with.on(), f, operands), n, "by columns",
          [&](const std::vector<Number *> &out) { evaluate(f, operands, out); });
  compare(evaluate<Number>(with.on(), f, operands, rows), rows.size() / operands.size(), "on rows",
          [&](const std::vector<Number *> &out) { evaluate(f, operands, rows, out); });
}

} // namespace

void formula_scenes(comparison &with, const settings &s) {
  const catalogue *const c = fusing();
  if (!c) {
    std::puts("formulas: not compared, since no code of this processor fuses");
    return;
  }
  engine random(s.seed);
  for (int i = 0; i < c->formula_count; ++i)
    for (const std::size_t n : {0, 1, 255, 257, s.small ? 600 : 300000})
      for (const int layout : {0, 1, 2}) {
        of_formula<float>(with, c->formulas[i], n, layout, random);
        of_formula<double>(with, c->formulas[i], n, layout, random);
      }
  with.require("formulas", c->formula_count > 20, "hardly any");
}

} // namespace cuda_test
