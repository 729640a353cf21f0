#include "meet/core/world/world.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/faults.hpp"

#include <cga/cga_runtime.hpp>

namespace meetc::python {

namespace {

std::uint32_t add(world &to, const std::string &name, const std::shared_ptr<prepared> &shape, const py::array &at,
                  const std::optional<py::array> &owner) {
  const std::span<const std::uint32_t> owners = owners_of(owner);
  return to.add(name, shape, place_of(at, shape->kind()), {owners.begin(), owners.end()});
}

answer_kind wanted(const std::string &name) {
  return name == "any" ? answer_kind::any : name == "pairs" ? answer_kind::pairs : answer_kind::count;
}

world_answer asked(const world &w, world_options &options, const std::string &precision, int threads) {
  options.precision = rung_named(precision);
  options.threads = threads;
  options.progress = check_signals();
  const py::gil_scoped_release others_run;
  return w.touching(options);
}

// The two bodies, the number of their pairs, and with want "pairs" these, for each two that touch.
py::list touching(const world &w, const std::vector<std::uint32_t> &of, const std::string &precision,
                  const std::string &want, int threads) {
  world_options options;
  options.of = of;
  options.want = wanted(want);
  options.first = options.want == answer_kind::any;
  world_answer found = asked(w, options, precision, threads);
  py::list out;
  for (touching_bodies &t : found.touching) {
    const auto rows = static_cast<py::ssize_t>(t.found.pairs.size());
    out.append(py::make_tuple(t.a, t.b, t.found.count, as_array<std::int32_t>(std::move(t.found.pairs), {rows, 2})));
  }
  return out;
}

// The two bodies, how the one lies in the other, and where that is unknown, the reason.
py::list nested(const world &w, const std::vector<std::uint32_t> &of, const std::string &precision, int threads) {
  constexpr const char *names[] = {"a inside b", "b inside a", "overlapping", "unknown"};
  world_options options;
  options.of = of;
  options.want = answer_kind::any;
  options.nested = true;
  py::list out;
  for (const nested_bodies &n : asked(w, options, precision, threads).nested)
    out.append(py::make_tuple(n.a, n.b, names[static_cast<int>(n.how)], n.why));
  return out;
}

} // namespace

void bind_world(py::module_ &module) {
  py::class_<world>(module, "World", "Bodies by their numbers. It is changed and asked by one thread at a time.")
      .def(py::init([](const std::string &mode) { return world(cga::catalogue(), mode); }), py::arg("mode"))
      .def("add", &add, py::arg("name"), py::arg("shape"), py::arg("pose"), py::arg("owner"))
      .def(
          "move",
          [](world &w, std::uint32_t body, const py::array &at) { w.move(body, place_of(at, w.shape(body).kind())); },
          py::arg("body"), py::arg("pose"))
      .def("ignore", &world::ignore, py::arg("a"), py::arg("b"), py::arg("ignored"))
      .def("touching", &touching, py::arg("of"), py::arg("precision"), py::arg("want"), py::arg("threads"))
      .def("nested", &nested, py::arg("of"), py::arg("precision"), py::arg("threads"));
}

} // namespace meetc::python
