// python/bindings.hpp: the parts of the module meetc._native. meetc/_native.pyi has their signatures.
#ifndef MEETC_PYTHON_BINDINGS_HPP
#define MEETC_PYTHON_BINDINGS_HPP

#include "meet/core/query/self_pairs.hpp"
#include "meetc/table/table.hpp"

#include <pybind11/pybind11.h>
#include <string_view>

namespace meetc::python {

void bind_sets(pybind11::module_ &module);
void bind_queries(pybind11::module_ &module);
void bind_evaluate(pybind11::module_ &module);
void bind_files(pybind11::module_ &module);
void bind_world(pybind11::module_ &module);
void bind_contacts(pybind11::module_ &module);
void bind_self(pybind11::module_ &module);
void bind_report(pybind11::module_ &module);
void bind_polygons(pybind11::module_ &module);
void bind_device(pybind11::module_ &module); // in a build with CUDA, as this:
void bind_evaluate_there(pybind11::module_ &module);

// Throw usage_error for a name that the shipped catalogue does not have.
const kind_info &kind_named(std::string_view name);
const predicate_info &predicate_named(std::string_view name);
rung rung_named(std::string_view name);
// Those that find where a mesh of triangles crosses itself.
const self_predicates &of_one_mesh();

} // namespace meetc::python

#endif
