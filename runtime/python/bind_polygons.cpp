#include "meet/io/polygon/triangulate.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"

#include <algorithm>
#include <numeric>

namespace meetc::python {

namespace {

// The place of each count in a flat list of counts and corners. The last place is that of the first count which is below
// `least` or beyond the list's end, or the size of the list where there is none.
py::array polygon_starts(const py::array &flat, std::int64_t least) {
  require_packed(flat, "i", 8, 1, "faces");
  const std::span<const std::int64_t> numbers = span_of<std::int64_t>(flat);
  std::vector<std::int64_t> out;
  std::size_t at = 0;
  for (; at < numbers.size(); at += 1 + static_cast<std::size_t>(numbers[at])) {
    out.push_back(static_cast<std::int64_t>(at));
    if (numbers[at] < least || static_cast<std::uint64_t>(numbers[at]) >= numbers.size() - at)
      return as_array<std::int64_t>(std::move(out));
  }
  out.push_back(static_cast<std::int64_t>(at));
  return as_array<std::int64_t>(std::move(out));
}

// Polygons as triangles: the corners of these, the polygon of each, and notes. `counts` are 3 and more; there are as many
// corners as they add up to, each below the number of rows of `points`.
py::tuple cut(const py::array &points, const py::array &corners, const py::array &counts, int threads) {
  require_packed(points, "f", 4, 2, "points");
  require_packed(corners, "iu", 4, 1, "corners");
  require_packed(counts, "iu", 4, 1, "counts");
  const std::span<const float> xyz = span_of<float>(points);
  const std::span<const std::uint32_t> vertices = span_of<std::uint32_t>(corners),
                                       each = span_of<std::uint32_t>(counts);
  const bool there = std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) { return v < xyz.size() / 3; });
  const bool three = std::all_of(each.begin(), each.end(), [](std::uint32_t n) { return n >= 3; });
  if (points.shape(1) != 3 || !there || !three ||
      std::accumulate(each.begin(), each.end(), std::size_t{0}) != vertices.size())
    throw py::type_error("corners: they do not fit points and counts");
  io::element_set set;
  {
    const py::gil_scoped_release others_run;
    set.data.assign(xyz.begin(), xyz.end());
    io::vertex_lists faces;
    faces.vertices.assign(vertices.begin(), vertices.end());
    faces.counts.assign(each.begin(), each.end());
    faces.lists = each.size();
    io::cut_polygons("faces", std::move(faces), threads, set);
  }
  const auto triangles = static_cast<py::ssize_t>(set.index.size() / 3);
  return py::make_tuple(as_array<std::uint32_t>(std::move(set.index), {triangles, 3}),
                        as_array<std::uint32_t>(std::move(set.owner)), set.notes);
}

} // namespace

void bind_polygons(py::module_ &module) {
  module.def("polygon_starts", &polygon_starts, py::arg("flat"), py::arg("least"));
  module.def("cut_polygons", &cut, py::arg("points"), py::arg("corners"), py::arg("counts"), py::arg("threads"));
}

} // namespace meetc::python
