// python/worlds.hpp: the answers about bodies, as methods of a class of Python.
#ifndef MEETC_PYTHON_WORLDS_HPP
#define MEETC_PYTHON_WORLDS_HPP

#include "meet/core/views/usage_error.hpp"
#include "meet/core/world/world.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace meetc::python {

inline answer_kind wanted(const std::string &name) {
  return name == "any" ? answer_kind::any : name == "pairs" ? answer_kind::pairs : answer_kind::count;
}

// How one body lies in the other, by the values of nesting.
inline constexpr std::array<const char *, 4> nesting_names{"a inside b", "b inside a", "overlapping", "unknown"};
inline nesting nesting_named(std::string_view name) {
  const auto at = std::ranges::find(nesting_names, name);
  if (at == nesting_names.end())
    throw usage_error("no way to lie in another body: " + std::string(name));
  return static_cast<nesting>(at - nesting_names.begin());
}

// Asks a world, or one on a device, without the interpreter's lock, until a handler of a signal raises something.
template <class World> using ask_bodies = world_answer (*)(World &, world_options &);

// The two bodies, the number of their pairs, and with want "pairs" these, for each two that touch.
template <class World, ask_bodies<World> Ask>
py::list touching_bodies_of(World &w, const std::vector<std::uint32_t> &of, const std::string &precision,
                            const std::string &want, int threads) {
  world_options options;
  options.of = of;
  options.want = wanted(want);
  options.first = options.want == answer_kind::any;
  options.precision = rung_named(precision);
  options.threads = threads;
  world_answer found = Ask(w, options);
  py::list out;
  for (touching_bodies &t : found.touching) {
    const auto rows = static_cast<py::ssize_t>(t.found.pairs.size());
    out.append(py::make_tuple(t.a, t.b, t.found.count, as_array<std::int32_t>(std::move(t.found.pairs), {rows, 2})));
  }
  return out;
}

// The two bodies, how the one lies in the other, and where that is unknown, the reason.
template <class World, ask_bodies<World> Ask>
py::list nested_bodies_of(World &w, const std::vector<std::uint32_t> &of, const std::string &precision, int threads) {
  world_options options;
  options.of = of;
  options.want = answer_kind::any;
  options.nested = true;
  options.precision = rung_named(precision);
  options.threads = threads;
  py::list out;
  for (const nested_bodies &n : Ask(w, options).nested)
    out.append(py::make_tuple(n.a, n.b, nesting_names[static_cast<std::size_t>(n.how)], n.why));
  return out;
}

template <auto Ask, class World, class... Holder> void bind_bodies(py::class_<World, Holder...> &to) {
  to.def("touching", &touching_bodies_of<World, Ask>, py::arg("of"), py::arg("precision"), py::arg("want"),
         py::arg("threads"));
  to.def("nested", &nested_bodies_of<World, Ask>, py::arg("of"), py::arg("precision"), py::arg("threads"));
}

} // namespace meetc::python

#endif
