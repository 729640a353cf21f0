// python/signals.hpp: Ctrl-C, and whatever else a handler of a signal raises, during long work.
#ifndef MEETC_PYTHON_SIGNALS_HPP
#define MEETC_PYTHON_SIGNALS_HPP

#include <cstddef>
#include <functional>
#include <stop_token>

namespace meetc::python {

// For a query on a device, which stays on the calling thread, the progress of its options: takes the interpreter's lock, and
// throws what a handler raises.
std::function<void(double)> check_signals();

// Releases the interpreter's lock and does `work`, which uses nothing of Python. With many objects the work runs on another
// thread, and the calling one looks for signals meanwhile: what a handler raises requests the stop, and is thrown when the
// work has ended.
void stoppable(std::size_t objects, const std::function<void(const std::stop_token &)> &work);

} // namespace meetc::python

#endif
