#include "meet/python/bindings.hpp"
#include "meet/python/columns.hpp"

#include <cga/cga_runtime.hpp>

#include <algorithm>
#include <tuple>

namespace meetc::python {

namespace {

using formula_row =
    std::tuple<std::string, std::vector<std::pair<std::string, std::string>>, std::string>; // name, operands, results

std::vector<formula_row> formulas() {
  std::vector<formula_row> out;
  const catalogue &all = cga::catalogue();
  for (const formula_info &f : std::span(all.formulas, static_cast<std::size_t>(all.formula_count))) {
    std::vector<std::pair<std::string, std::string>> operands;
    for (const formula_operand &o : std::span(f.operands, static_cast<std::size_t>(f.operand_count)))
      operands.emplace_back(o.kind, o.numbers);
    out.emplace_back(f.name, std::move(operands), f.results);
  }
  return out;
}

template <class Number>
py::array on_columns(const formula_info &f, std::span<const operand_columns> operands,
                     const std::optional<py::array> &rows, int threads) {
  const std::size_t each = operands.size();
  const std::size_t count =
      rows ? static_cast<std::size_t>(rows->size()) / std::max<std::size_t>(each, 1) : common_objects(f, operands);
  const auto columns = static_cast<std::size_t>(f.result_count);
  std::vector<Number> numbers(count * columns);
  {
    const py::gil_scoped_release others_run;
    std::vector<Number *> into;
    for (std::size_t k = 0; k < columns; ++k)
      into.push_back(numbers.data() + k * count);
    if (count > 0 && rows)
      evaluate(f, operands, span_of<std::uint32_t>(*rows), std::span<Number *const>(into), threads);
    else if (count > 0)
      evaluate(f, operands, std::span<Number *const>(into), threads);
  }
  return as_array<Number>(std::move(numbers), {f.result_count, static_cast<py::ssize_t>(count)});
}

py::array evaluate_columns(const std::string &formula, const std::vector<std::vector<py::array>> &operands,
                           const std::optional<py::array> &rows, bool wide, int threads) {
  const formula_info &f = formula_named(cga::catalogue(), formula);
  const formula_columns columns(operands);
  if (rows)
    require_packed(*rows, "iu", 4, 2, "rows");
  return wide ? on_columns<double>(f, columns.operands(), rows, threads)
              : on_columns<float>(f, columns.operands(), rows, threads);
}

template <class Number>
py::array on_pairs(const formula_info &f, const prepared &a, const prepared &b, std::span<const index_pair> pairs,
                   int threads) {
  formula_values<Number> values;
  {
    const py::gil_scoped_release others_run;
    values = evaluate<Number>(f, a, b, pairs, threads);
  }
  return as_rows(f, std::move(values));
}

py::array evaluate_pairs(const std::string &formula, const prepared &a, const prepared &b, const py::array &pairs,
                         bool wide, int threads) {
  const formula_info &f = formula_named(cga::catalogue(), formula);
  const std::span<const index_pair> list = pairs_of(pairs);
  return wide ? on_pairs<double>(f, a, b, list, threads) : on_pairs<float>(f, a, b, list, threads);
}

} // namespace

void bind_evaluate(py::module_ &module) {
  module.def("formulas", &formulas);
  module.def("evaluate_columns", &evaluate_columns, py::arg("formula"), py::arg("operands"), py::arg("rows"),
             py::arg("wide"), py::arg("threads"));
  module.def("evaluate_pairs", &evaluate_pairs, py::arg("formula"), py::arg("a"), py::arg("b"), py::arg("pairs"),
             py::arg("wide"), py::arg("threads"));
}

} // namespace meetc::python
