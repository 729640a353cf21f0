// python/device/the_device.hpp: the CUDA device on which the package's queries run.
#ifndef MEETC_PYTHON_DEVICE_THE_DEVICE_HPP
#define MEETC_PYTHON_DEVICE_THE_DEVICE_HPP

#include "meet/core/device/memory/device.hpp"

namespace meetc::python {

// The current device, found when it is first needed. Throws device_error where there is none, and after a fork.
const device &the_device();

} // namespace meetc::python

#endif
