#include "meet/python/bindings.hpp"
#include "meet/python/columns.hpp"
#include "meet/python/signals.hpp"

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

// An array of a formula's values, one row for each column, and where these begin.
template <class Number> struct value_columns {
  py::array_t<Number> numbers;
  std::vector<Number *> columns;

  value_columns(const formula_info &f, std::size_t count)
      : numbers({static_cast<py::ssize_t>(f.result_count), static_cast<py::ssize_t>(count)}) {
    for (int k = 0; k < f.result_count; ++k)
      columns.push_back(numbers.mutable_data() + static_cast<std::size_t>(k) * count);
  }
  std::span<Number *const> all() const { return columns; }
};

template <class Number>
py::array on_columns(const formula_info &f, std::span<const operand_columns> operands,
                     const std::optional<py::array> &rows, int threads) {
  const std::size_t each = operands.size();
  const std::size_t count =
      rows ? static_cast<std::size_t>(rows->size()) / std::max<std::size_t>(each, 1) : common_objects(f, operands);
  const value_columns<Number> values(f, count);
  const auto listed = rows ? span_of<std::uint32_t>(*rows) : std::span<const std::uint32_t>();
  stoppable(count, [&](const std::stop_token &stop) {
    const execution on(threads, stop);
    if (count > 0 && rows)
      evaluate(f, operands, listed, values.all(), on);
    else if (count > 0)
      evaluate(f, operands, values.all(), on);
  });
  return values.numbers;
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
  const value_columns<Number> values(f, pairs.size());
  stoppable(pairs.size(),
            [&](const std::stop_token &stop) { evaluate(f, a, b, pairs, values.all(), execution(threads, stop)); });
  return values.numbers;
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
