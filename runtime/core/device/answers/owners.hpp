// core/device/answers/owners.hpp: the items that own elements, on a device.
#ifndef MEETC_CORE_DEVICE_ANSWERS_OWNERS_HPP
#define MEETC_CORE_DEVICE_ANSWERS_OWNERS_HPP

#include "meet/core/device/memory/memory.hpp"

#include <span>

namespace meetc::on_device {

// Enqueues. Without owners nothing is uploaded.
inline void upload_owners(std::span<const std::uint32_t> owners, device_memory<std::uint32_t> &to,
                          cudaStream_t stream) {
  if (owners.empty())
    return;
  to.reserve(owners.size(), "an owner map");
  check(cudaMemcpyAsync(to.data(), owners.data(), owners.size_bytes(), cudaMemcpyHostToDevice, stream),
        "uploading owners");
}

} // namespace meetc::on_device

#endif
