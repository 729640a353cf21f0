#include "meet/core/sets/prepared.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/signals.hpp"

namespace meetc::python {

namespace {

std::shared_ptr<prepared> prepare_arrays(const std::string &kind, const py::array &numbers,
                                         const std::optional<py::array> &index, const std::optional<py::array> &at,
                                         int threads) {
  const kind_info &of = kind_named(kind);
  const view elements = view_of(of, numbers, index);
  const pose place = at ? place_of(*at, of) : pose{};
  std::shared_ptr<prepared> out;
  stoppable(elements.elements, [&](const std::stop_token &stop) {
    out = std::make_shared<prepared>(prepare(elements, of, place, threads, nullptr, stop));
  });
  return out;
}

} // namespace

void bind_sets(py::module_ &module) {
  py::class_<prepared, std::shared_ptr<prepared>>(module, "Prepared", "A set that is ready to collide.")
      .def_property_readonly("elements", &prepared::elements)
      .def("bounds", [](const prepared &set) {
        std::vector<float> ends(6);
        set.bounds(ends.data(), ends.data() + 3);
        return as_array<float>(std::move(ends), {2, 3});
      });
  module.def("prepare", &prepare_arrays, py::arg("kind"), py::arg("numbers"), py::arg("index"), py::arg("pose"),
             py::arg("threads"));
}

} // namespace meetc::python
