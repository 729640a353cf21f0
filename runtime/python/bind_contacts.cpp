#include "meet/core/contacts/contacts.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/columns.hpp"
#include "meet/python/signals.hpp"

#include <cstddef>
#include <cstring>

namespace meetc::python {

namespace {

// A set as its arrays and its pose.
using set_arrays = std::tuple<py::array, std::optional<py::array>, std::optional<py::array>>;

struct side {
  view elements;
  pose at;

  side(const set_arrays &of, const kind_info &kind)
      : elements(view_of(kind, std::get<0>(of), std::get<1>(of))),
        at(std::get<2>(of) ? place_of(*std::get<2>(of), kind) : pose{}) {}
};

py::tuple lists(node_lists &&of) {
  return py::make_tuple(as_array<std::int64_t>(std::move(of.offsets)), as_array<std::int32_t>(std::move(of.nodes)));
}

py::array rows_of(touched_rows &&of) {
  const py::ssize_t wide = of.fields, numbers = static_cast<py::ssize_t>(of.rows.size());
  return as_array<float>(std::move(of.rows), {numbers / wide, wide});
}

// The rest of each part has no value, and what is pickled would differ from one call to the next.
std::vector<element_part> cleared(std::vector<element_part> &&parts) {
  constexpr std::size_t end = offsetof(element_part, carrier) + 1;
  for (element_part &part : parts)
    std::memset(reinterpret_cast<char *>(&part) + end, 0, sizeof part - end);
  return std::move(parts);
}

// The members of a contact_set, whose memory they take over.
template <class Real>
py::dict find(const side &a, const side &b, const predicate_info &predicate, std::span<const index_pair> pairs,
              bool embedded, int threads) {
  const std::size_t checked = embedded ? a.elements.elements + b.elements.elements : 0;
  contact_set<Real> c;
  stoppable(pairs.size() + checked, [&](const std::stop_token &stop) {
    c = contacts<Real>(a.elements, b.elements, predicate, pairs,
                       {.at_a = a.at,
                        .at_b = b.at,
                        .threads = threads,
                        .stop = stop,
                        .embedded_by = embedded ? &of_one_mesh() : nullptr});
  });
  const auto nodes = static_cast<py::ssize_t>(c.nodes()), pieces = static_cast<py::ssize_t>(c.pieces.size());
  py::dict out;
  out["codes"] = as_array<std::uint64_t>(std::move(c.codes));
  out["corners"] = lists(std::move(c.corners));
  out["points"] = as_array<Real>(std::move(c.points), {nodes, 3});
  out["on_a"] = as_array<element_part>(cleared(std::move(c.on_a)));
  out["on_b"] = as_array<element_part>(cleared(std::move(c.on_b)));
  out["pieces"] = as_array<std::int32_t>(std::move(c.pieces), {pieces, 2});
  out["polylines"] = lists(std::move(c.polylines));
  out["closed"] = as_array<bool>(std::move(c.closed));
  out["patches"] = lists(std::move(c.patches));
  out["patch_pairs"] = as_array<std::int32_t>(std::move(c.patch_pairs));
  out["single_nodes"] = as_array<std::int32_t>(std::move(c.single_nodes));
  const auto witnesses = static_cast<py::ssize_t>(c.witness_pairs.size());
  out["witness_pairs"] = as_array<std::int32_t>(std::move(c.witness_pairs));
  out["witnesses"] = as_array<Real>(std::move(c.witnesses), {witnesses, 3});
  out["embedded"] = c.embedded == embedding::unchecked ? py::object(py::none())
                                                       : py::object(py::bool_(c.embedded == embedding::embedded));
  out["rows"] = py::make_tuple(rows_of(std::move(c.rows_a)), rows_of(std::move(c.rows_b)));
  out["sources"] = as_array<std::int32_t>(std::move(c.sources), {nodes, 3});
  return out;
}

// `pairs`: of elements, in the order of the predicate's kinds.
py::dict contacts_of(const set_arrays &a, const set_arrays &b, const std::string &predicate, const py::array &pairs,
                     bool wide, bool embedded, int threads) {
  const predicate_info &by = predicate_named(predicate);
  const side of_a(a, *by.a), of_b(b, *by.b);
  const std::span<const index_pair> asked = pairs_of(pairs);
  return wide ? find<double>(of_a, of_b, by, asked, embedded, threads)
              : find<float>(of_a, of_b, by, asked, embedded, threads);
}

// The row of a ball, a segment or a triangle.
touched_rows one_row(const py::array &row, int carrier) {
  require_packed(row, "f", 4, 1, "row");
  const bool ball = row.size() == 4;
  const int corners = ball ? 0 : static_cast<int>(row.size()) / 3;
  const bool there = ball ? carrier <= double_root
                          : carrier < corners || (corners == 3 && carrier <= open_face) || carrier == first_edge;
  if ((!ball && row.size() != 6 && row.size() != 9) || !there)
    throw py::type_error("row: it has no such part");
  const std::span<const float> numbers = span_of<float>(row);
  touched_rows out;
  out.corners = corners, out.fields = static_cast<int>(row.size());
  out.elements = {0};
  out.rows.assign(numbers.begin(), numbers.end());
  return out;
}

// Numerator, denominator, root and radicand of each coordinate of a node, from the rows of its two elements and its label.
std::array<std::array<std::string, 4>, 3> exact_point(const py::array &a, const py::array &b, unsigned label) {
  if (label >= label_of(open_face, open_face))
    throw py::type_error("label: there is none of this number");
  const bool root = label_b(label) >= 2 && label_a(label) >= first_root;
  if (b.size() == 4 || (a.size() == 4 && (b.size() != 6 || (label_b(label) >= 2 && !root))))
    throw py::type_error("label: a ball and a segment have no such point");
  contact_set<double> one;
  one.rows_a = one_row(a, label_a(label));
  one.rows_b = one_row(b, label_b(label));
  one.sources = {{0, 0, label}};
  std::array<std::array<std::string, 4>, 3> out;
  std::array<decimal_fraction, 3> found = one.exact(0);
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = {std::move(found[k].numerator), std::move(found[k].denominator), std::move(found[k].root),
              std::move(found[k].radicand)};
  return out;
}

} // namespace

void bind_contacts(py::module_ &module) {
  PYBIND11_NUMPY_DTYPE(element_part, element, dimension, carrier);
  module.def("contacts", &contacts_of, py::arg("a"), py::arg("b"), py::arg("predicate"), py::arg("pairs"),
             py::arg("wide"), py::arg("embedded"), py::arg("threads"));
  module.def("exact_point", &exact_point, py::arg("a"), py::arg("b"), py::arg("label"));
}

} // namespace meetc::python
