// The module meetc._native.
#include "meet/core/query/find.hpp"
#include "meet/core/views/usage_error.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/faults.hpp"
#include <cga/cga_runtime.hpp>

#include <pybind11/stl.h>

#include <cstdlib>
#include <tuple>

namespace meetc::python {

namespace py = pybind11;

namespace {

constexpr const char *rung_names[] = {"fp32", "fp64", "fp64x2", "exact", "certified"};

using predicate_row = std::tuple<std::string, std::string, std::string, std::string, bool>;

std::vector<predicate_row> predicates() {
  std::vector<predicate_row> out;
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i) {
    const predicate_info &p = all.predicates[i];
    out.emplace_back(p.name, p.mode, p.a->name, p.b->name, p.contacts != nullptr);
  }
  return out;
}

std::vector<std::pair<std::string, std::string>> kinds() {
  std::vector<std::pair<std::string, std::string>> out;
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.kind_count; ++i)
    out.emplace_back(all.kinds[i].name, all.kinds[i].csv);
  return out;
}

// Before 2.12 pybind11 misreads the types of NumPy 2's arrays.
void require_numpy() {
  const auto version = py::module_::import("numpy").attr("__version__").cast<std::string>();
  if (PYBIND11_VERSION_HEX < 0x020C0000 && std::strtol(version.c_str(), nullptr, 10) >= 2)
    throw py::import_error(
        "meetc was compiled with pybind11 " PYBIND11_TOSTRING(PYBIND11_VERSION_MAJOR) "." PYBIND11_TOSTRING(
            PYBIND11_VERSION_MINOR) ", which does not know NumPy " +
        version + ": take pybind11 2.12 or later, or NumPy 1");
}

} // namespace

const kind_info &kind_named(std::string_view name) {
  return find_kind(cga::catalogue(), name);
}

const predicate_info &predicate_named(std::string_view name) {
  return find_predicate(cga::catalogue(), name);
}

rung rung_named(std::string_view name) {
  for (int i = 0; i < 5; ++i)
    if (name == rung_names[i])
      return static_cast<rung>(i);
  throw usage_error("no precision '" + std::string(name) + "'");
}

} // namespace meetc::python

PYBIND11_MODULE(_native, m) {
  using namespace meetc::python;
  m.doc() = "The compiled part of meetc; the package's own functions call it.";
  require_numpy();
  m.attr("version") = MEETC_PACKAGE_VERSION;
  m.attr("pybind11") = pybind11::make_tuple(PYBIND11_VERSION_MAJOR, PYBIND11_VERSION_MINOR);
  bind_faults(m);
  bind_sets(m);
  bind_queries(m);
  bind_evaluate(m);
  bind_files(m);
  bind_world(m);
  bind_contacts(m);
  bind_self(m);
  bind_report(m);
  bind_polygons(m);
  m.attr("with_cuda") = MEETC_WITH_CUDA != 0;
#if MEETC_WITH_CUDA
  bind_device(m);
#endif
  m.def("predicates", &predicates);
  m.def("kinds", &kinds);
}
