#include "meet/core/query/find.hpp"
#include "meet/core/query/self_pairs.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/signals.hpp"

#include <cga/cga_runtime.hpp>
#include <neighbours/neighbours_runtime.hpp>

namespace meetc::python {

namespace {

// Pairs of elements, and the elements without area.
py::tuple self(const std::shared_ptr<prepared> &set, const py::array &numbers, const std::optional<py::array> &index,
               const std::optional<py::array> &owner, bool merge, int threads) {
  const view elements = view_of(set->kind(), numbers, index);
  self_options options;
  options.threads = threads;
  options.merge = merge;
  options.owner = owners_of(owner);
  self_result found;
  stoppable(elements.elements, [&](const std::stop_token &stop) {
    options.stop = stop;
    found = self_pairs(*set, elements, of_one_mesh(), options);
  });
  const auto rows = static_cast<py::ssize_t>(found.pairs.size());
  return py::make_tuple(as_array<std::int32_t>(std::move(found.pairs), {rows, 2}),
                        as_array<std::int32_t>(std::move(found.degenerate)));
}

} // namespace

const self_predicates &of_one_mesh() {
  static const self_predicates by{find_predicate(cga::catalogue(), "triangle_triangle"),
                                  find_predicate(neighbours::catalogue(), "beyond_corner"),
                                  find_predicate(neighbours::catalogue(), "beyond_edge")};
  return by;
}

void bind_self(py::module_ &module) {
  module.def("self_pairs", &self, py::arg("set"), py::arg("numbers"), py::arg("index"), py::arg("owner"),
             py::arg("merge"), py::arg("threads"));
}

} // namespace meetc::python
