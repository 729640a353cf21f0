// python/faults.hpp: the library's exceptions as those of Python.
#ifndef MEETC_PYTHON_FAULTS_HPP
#define MEETC_PYTHON_FAULTS_HPP

#include <pybind11/pybind11.h>

namespace meetc::python {

// Adds the exceptions Fault (of an element: kind, element, field, value, index and rule as attributes) and FileFault.
// Standard exceptions become ValueError, IndexError and MemoryError by pybind11 itself.
void bind_faults(pybind11::module_ &module);

} // namespace meetc::python

#endif
