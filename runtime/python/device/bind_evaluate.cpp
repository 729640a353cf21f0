#include "meet/core/device/evaluate.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/columns.hpp"
#include "meet/python/device/the_device.hpp"

#include <cga/cga_runtime.hpp>

namespace meetc::python {

namespace {

template <class Number>
py::array of_columns(const formula_info &f, std::span<const operand_columns> operands,
                     const std::optional<py::array> &rows) {
  formula_values<Number> values;
  {
    const py::gil_scoped_release others_run;
    values = rows ? evaluate<Number>(the_device(), f, operands, span_of<std::uint32_t>(*rows))
                  : evaluate<Number>(the_device(), f, operands);
  }
  return as_rows(f, std::move(values));
}

py::array evaluate_columns_there(const std::string &formula, const std::vector<std::vector<py::array>> &operands,
                                 const std::optional<py::array> &rows, bool wide) {
  const formula_info &f = formula_named(cga::catalogue(), formula);
  const formula_columns columns(operands);
  if (rows)
    require_packed(*rows, "iu", 4, 2, "rows");
  return wide ? of_columns<double>(f, columns.operands(), rows) : of_columns<float>(f, columns.operands(), rows);
}

template <class Number>
py::array of_pairs(const formula_info &f, const device_set &a, const device_set &b, std::span<const index_pair> pairs) {
  formula_values<Number> values;
  {
    const py::gil_scoped_release others_run;
    const device &on = the_device();
    device_memory<index_pair> there;
    {
      const auto lock = on.use();
      there.reserve(pairs.size(), "pairs");
      check(cudaMemcpyAsync(there.data(), pairs.data(), pairs.size_bytes(), cudaMemcpyHostToDevice, on.stream()),
            "pairs");
      check(cudaStreamSynchronize(on.stream()), "pairs");
    }
    values = evaluate<Number>(on, f, a, b, there.data(), pairs.size()).download();
  }
  return as_rows(f, std::move(values));
}

py::array evaluate_pairs_there(const std::string &formula, const device_set &a, const device_set &b,
                               const py::array &pairs, bool wide) {
  const formula_info &f = formula_named(cga::catalogue(), formula);
  const std::span<const index_pair> list = pairs_of(pairs);
  return wide ? of_pairs<double>(f, a, b, list) : of_pairs<float>(f, a, b, list);
}

} // namespace

void bind_evaluate_there(py::module_ &module) {
  module.def("evaluate_columns_there", &evaluate_columns_there, py::arg("formula"), py::arg("operands"),
             py::arg("rows"), py::arg("wide"));
  module.def("evaluate_pairs_there", &evaluate_pairs_there, py::arg("formula"), py::arg("a"), py::arg("b"),
             py::arg("pairs"), py::arg("wide"));
}

} // namespace meetc::python
