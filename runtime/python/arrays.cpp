#include "meet/python/arrays.hpp"

#include "meet/python/poses.hpp"

#include <cstring>
#include <string>

namespace meetc::python {

namespace {

bool is_type(const py::array &array, const char *kinds, std::size_t bytes) {
  const py::dtype type = array.dtype();
  return std::strchr(kinds, type.kind()) && static_cast<std::size_t>(type.itemsize()) == bytes;
}

void require(bool holds, const std::string &what) {
  if (!holds)
    throw py::type_error(what);
}

} // namespace

view view_of(const kind_info &kind, const py::array &numbers, const std::optional<py::array> &index) {
  require(is_type(numbers, "f", 4) && numbers.ndim() == 2, "numbers: a float32 array of two dimensions is needed");
  const py::ssize_t wide = index ? 3 : kind.fields;
  require(numbers.shape(1) == wide, "numbers: a row has " + std::to_string(wide) + " columns");
  require(numbers.strides(1) == 4 || numbers.size() == 0, "numbers: the columns of a row are not packed");
  require(numbers.shape(0) < 2 || numbers.strides(0) >= 4 * wide, "numbers: a row begins before the last one ends");
  view out;
  out.data = static_cast<const float *>(numbers.data());
  out.vertices = out.elements = static_cast<std::size_t>(numbers.shape(0));
  out.stride_bytes = numbers.shape(0) < 2 ? 0 : static_cast<std::size_t>(numbers.strides(0));
  if (index) {
    require_packed(*index, "iu", 4, 2, "index");
    require(kind.points > 0 && index->shape(1) == kind.points, "index: a row has the points of the kind");
    out.index = static_cast<const std::uint32_t *>(index->data());
    out.elements = static_cast<std::size_t>(index->shape(0));
  }
  return out;
}

void require_packed(const py::array &array, const char *kinds, std::size_t bytes, int dimensions, const char *name) {
  require(is_type(array, kinds, bytes) && array.ndim() == dimensions && (array.flags() & py::array::c_style),
          std::string(name) + ": another type of array is needed");
}

pose place_of(const py::array &at, const kind_info &kind) {
  require_packed(at, "f", 8, 1, "pose");
  require(at.size() == 12, "pose: twelve numbers are needed");
  return pose_of(span_of<double>(at), kind);
}

std::span<const std::uint32_t> owners_of(const std::optional<py::array> &owner) {
  if (!owner)
    return {};
  require_packed(*owner, "iu", 4, 1, "owner");
  return span_of<std::uint32_t>(*owner);
}

std::span<const index_pair> pairs_of(const py::array &pairs) {
  require_packed(pairs, "iu", 4, 2, "pairs");
  if (pairs.shape(1) != 2)
    throw py::type_error("pairs: a row has two columns");
  return {static_cast<const index_pair *>(pairs.data()), static_cast<std::size_t>(pairs.shape(0))};
}

} // namespace meetc::python
