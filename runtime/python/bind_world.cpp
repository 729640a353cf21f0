#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/signals.hpp"
#include "meet/python/worlds.hpp"

#include <cga/cga_runtime.hpp>

namespace meetc::python {

namespace {

std::uint32_t add(world &to, const std::string &name, const std::shared_ptr<prepared> &shape, const py::array &at,
                  const std::optional<py::array> &owner) {
  const std::span<const std::uint32_t> owners = owners_of(owner);
  return to.add(name, shape, place_of(at, shape->kind()), {owners.begin(), owners.end()});
}

world_answer ask(world &w, world_options &options) {
  std::size_t elements = 0;
  for (std::uint32_t body = 0; body < w.size(); ++body)
    elements += w.shape(body).elements();
  world_answer found;
  stoppable(elements, [&](const std::stop_token &stop) {
    options.stop = stop;
    found = w.touching(options);
  });
  return found;
}

} // namespace

void bind_world(py::module_ &module) {
  py::class_<world, std::shared_ptr<world>> of(
      module, "World", "Bodies by their numbers. It is changed and asked by one thread at a time.");
  of.def(py::init([](const std::string &mode) { return std::make_shared<world>(cga::catalogue(), mode); }),
         py::arg("mode"))
      .def("add", &add, py::arg("name"), py::arg("shape"), py::arg("pose"), py::arg("owner"))
      .def(
          "move",
          [](world &w, std::uint32_t body, const py::array &at) { w.move(body, place_of(at, w.shape(body).kind())); },
          py::arg("body"), py::arg("pose"))
      .def("ignore", &world::ignore, py::arg("a"), py::arg("b"), py::arg("ignored"));
  bind_bodies<&ask>(of);
}

} // namespace meetc::python
