// python/device/dlpack.hpp: the array in a capsule of DLPack, on whatever device it lies.
#ifndef MEETC_PYTHON_DEVICE_DLPACK_HPP
#define MEETC_PYTHON_DEVICE_DLPACK_HPP

#include <pybind11/pybind11.h>

namespace meetc::python {

// Address, shape, strides in bytes, and type as NumPy writes it ("<f4"); last what keeps the memory alive. The capsule cannot
// be used again. Throws pybind11::type_error where it has been used, or where it holds vectors.
pybind11::tuple from_dlpack(const pybind11::capsule &capsule);

} // namespace meetc::python

#endif
