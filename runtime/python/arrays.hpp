// python/arrays.hpp: NumPy arrays as views of elements, and vectors as NumPy arrays, both without a copy.
//
// The package's Python code turns what a user gives into arrays of the right type and shape, and names what is wrong. Here the
// same is required again, so that no call reads memory that an array does not have.
#ifndef MEETC_PYTHON_ARRAYS_HPP
#define MEETC_PYTHON_ARRAYS_HPP

#include "meet/core/views/pose.hpp"
#include "meet/core/views/view.hpp"
#include "meetc/table/table.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>
#include <span>
#include <vector>

namespace meetc::python {

namespace py = pybind11;

// Rows of numbers: float32, two dimensions, packed within a row, at any stride of 0 or more between rows.
// Indices: 32-bit integers in two dimensions, packed; where a number is negative, the index lies beyond all vertices.
view view_of(const kind_info &kind, const py::array &numbers, const std::optional<py::array> &index);

// Packed numbers of `bytes` bytes and this kind (a letter of numpy.dtype.kind). Throws py::type_error with `name`.
void require_packed(const py::array &array, const char *kinds, std::size_t bytes, int dimensions, const char *name);

template <class T> std::span<const T> span_of(const py::array &array) {
  return {static_cast<const T *>(array.data()), static_cast<std::size_t>(array.size())};
}

// A pose of twelve numbers in double. Throws what pose_of() throws.
pose place_of(const py::array &at, const kind_info &kind);

// The item of each element, 32-bit; empty without an array.
std::span<const std::uint32_t> owners_of(const std::optional<py::array> &owner);

// Rows of two elements, 32-bit.
std::span<const index_pair> pairs_of(const py::array &pairs);

// An array of As over the memory of a vector of numbers of the same size, which it then owns; an empty one has none.
template <class As, class T> py::array as_array(std::vector<T> &&numbers, std::vector<py::ssize_t> shape) {
  static_assert(sizeof(T) % sizeof(As) == 0);
  if (numbers.empty())
    return py::array(py::dtype::of<As>(), std::move(shape));
  auto *const held = new std::vector<T>(std::move(numbers));
  const py::capsule owner(held, [](void *p) { delete static_cast<std::vector<T> *>(p); });
  return py::array(py::dtype::of<As>(), std::move(shape), {}, held->data(), owner);
}
template <class As, class T> py::array as_array(std::vector<T> &&numbers) {
  const auto size = static_cast<py::ssize_t>(numbers.size());
  return as_array<As>(std::move(numbers), {size});
}

} // namespace meetc::python

#endif
