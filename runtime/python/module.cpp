// The module meetc._native.
#include "meet/core/query/find.hpp"
#include "meet/core/views/usage_error.hpp"
#include "meet/python/bindings.hpp"
#include "meet/python/faults.hpp"
#include <cga/cga_runtime.hpp>

#include <pybind11/stl.h>

#include <tuple>

namespace meetc::python {

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
  m.attr("version") = MEETC_PACKAGE_VERSION;
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
