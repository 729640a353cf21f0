#include "meet/python/signals.hpp"

#include <chrono>
#include <exception>
#include <future>
#include <pybind11/pybind11.h>

namespace meetc::python {

namespace py = pybind11;

namespace {

constexpr std::size_t few = 1 << 10; // objects whose work is soon done, be it of all pairs: some milliseconds
constexpr std::chrono::milliseconds between_looks{50};

void require_no_signal() {
  const py::gil_scoped_acquire hold;
  if (PyErr_CheckSignals() != 0)
    throw py::error_already_set();
}

} // namespace

std::function<void(double)> check_signals() {
  return [](double) { require_no_signal(); };
}

void stoppable(std::size_t objects, const std::function<void(const std::stop_token &)> &work) {
  const py::gil_scoped_release others_run;
  if (objects < few) {
    work({});
    return;
  }
  std::stop_source stop;
  std::future<void> done = std::async(std::launch::async, [&] { work(stop.get_token()); });
  std::exception_ptr raised;
  while (!raised && done.wait_for(between_looks) == std::future_status::timeout)
    try {
      require_no_signal();
    } catch (...) {
      raised = std::current_exception();
      stop.request_stop();
    }
  try {
    done.get();
  } catch (...) {
    if (!raised)
      throw;
  }
  if (raised)
    std::rethrow_exception(raised);
}

} // namespace meetc::python
