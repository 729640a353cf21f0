#include "meet/python/faults.hpp"

#include "meet/core/sets/prepared.hpp"
#include "meet/io/files/error.hpp"

namespace meetc::python {

namespace py = pybind11;

namespace {

const char *name_of(fault_kind kind) {
  switch (kind) {
  case fault_kind::none:
  case fault_kind::view:
    break;
  case fault_kind::index:
    return "index";
  case fault_kind::value:
  case fault_kind::unheld:
    return "value";
  case fault_kind::moved:
  case fault_kind::rounded:
    return "moved";
  case fault_kind::rule:
    return "rule";
  }
  return "view";
}

// They live as long as the interpreter: the translator may run when the module is gone.
PyObject *fault_type = nullptr;
PyObject *file_fault_type = nullptr;

void raise(const input_error &e) {
  const py::object made = py::handle(fault_type)(e.what());
  made.attr("kind") = name_of(e.where.kind);
  made.attr("element") = e.where.element;
  made.attr("field") = e.where.field;
  made.attr("value") = e.where.value;
  made.attr("index") = e.where.index;
  made.attr("rule") = e.where.rule ? e.where.rule : "";
  PyErr_SetObject(fault_type, made.ptr());
}

} // namespace

void bind_faults(py::module_ &module) {
  fault_type = py::exception<input_error>(module, "Fault", PyExc_ValueError).release().ptr();
  file_fault_type = py::exception<io::error>(module, "FileFault", PyExc_ValueError).release().ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown)
        std::rethrow_exception(thrown);
    } catch (const input_error &e) {
      raise(e);
    } catch (const io::error &e) {
      PyErr_SetString(file_fault_type, e.what());
    }
  });
}

} // namespace meetc::python
