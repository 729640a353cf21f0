// python/columns.hpp: the operands of a formula as columns of NumPy's arrays, without a copy.
#ifndef MEETC_PYTHON_COLUMNS_HPP
#define MEETC_PYTHON_COLUMNS_HPP

#include "meet/core/query/evaluate.hpp"
#include "meet/python/arrays.hpp"

#include <algorithm>

namespace meetc::python {

// Lends the memory of arrays: float32, one dimension, a stride of whole numbers. Throws py::type_error for others.
class formula_columns {
public:
  explicit formula_columns(const std::vector<std::vector<py::array>> &operands) {
    for (const std::vector<py::array> &arrays : operands) {
      std::size_t objects = arrays.empty() ? 0 : ~std::size_t{0};
      std::vector<column> &of = columns_.emplace_back();
      for (const py::array &a : arrays) {
        const py::dtype type = a.dtype();
        if (type.kind() != 'f' || type.itemsize() != 4 || a.ndim() != 1 || a.strides(0) % 4 != 0)
          throw py::type_error("a column is a float32 array of one dimension with a stride of whole numbers");
        objects = std::min(objects, static_cast<std::size_t>(a.shape(0)));
        of.push_back({static_cast<const float *>(a.data()), a.strides(0) / 4});
      }
      objects_.push_back(objects);
    }
    for (std::size_t k = 0; k < columns_.size(); ++k)
      operands_.push_back({columns_[k], objects_[k]});
  }
  std::span<const operand_columns> operands() const { return operands_; }

private:
  std::vector<std::vector<column>> columns_;
  std::vector<std::size_t> objects_;
  std::vector<operand_columns> operands_;
};

// The values of a formula as rows: one for each coefficient.
template <class Number> py::array as_rows(const formula_info &f, formula_values<Number> &&values) {
  return as_array<Number>(std::move(values.numbers), {f.result_count, static_cast<py::ssize_t>(values.count)});
}

} // namespace meetc::python

#endif
