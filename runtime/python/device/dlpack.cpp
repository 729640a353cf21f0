#include "meet/python/device/dlpack.hpp"

#include <cstdint>
#include <string>

namespace meetc::python {

namespace py = pybind11;

namespace {

// As DLPack's version 0 lays them out, which __dlpack__() gives where no version is asked for.
struct tensor {
  void *data;
  std::int32_t device_kind, device;
  std::int32_t dimensions;
  std::uint8_t type;
  std::uint8_t bits;
  std::uint16_t lanes;
  const std::int64_t *shape, *strides; // in elements; no strides: packed
  std::uint64_t offset;
};
struct managed_tensor {
  tensor of;
  void *context;
  void (*deleter)(managed_tensor *);
};

constexpr const char *unused = "dltensor", *used = "used_dltensor";

} // namespace

py::tuple from_dlpack(const py::capsule &capsule) {
  if (!PyCapsule_IsValid(capsule.ptr(), unused))
    throw py::type_error("the capsule holds no array of DLPack, or has been used");
  auto *const managed = static_cast<managed_tensor *>(PyCapsule_GetPointer(capsule.ptr(), unused));
  const tensor &t = managed->of;
  if (t.lanes != 1 || t.type > 2)
    throw py::type_error("the array of DLPack holds no plain numbers");
  PyCapsule_SetName(capsule.ptr(), used);
  const py::capsule owner(managed, [](void *p) {
    auto *const m = static_cast<managed_tensor *>(p);
    if (m->deleter)
      m->deleter(m);
  });
  const std::int64_t bytes = t.bits / 8;
  py::list shape, strides;
  std::int64_t packed = bytes;
  for (std::int32_t i = t.dimensions; i-- > 0;) {
    shape.insert(0, t.shape[i]);
    strides.insert(0, t.strides ? t.strides[i] * bytes : packed);
    packed *= t.shape[i];
  }
  const std::string type = std::string("<") + "iuf"[t.type] + std::to_string(bytes);
  const auto address = reinterpret_cast<std::uintptr_t>(t.data) + t.offset;
  return py::make_tuple(address, py::tuple(shape), py::tuple(strides), type, owner);
}

} // namespace meetc::python
