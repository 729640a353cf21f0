// app/device_pairs.hpp: where pairs are decided, and the pairs of two sets on the CUDA device.
#ifndef MEETC_APP_DEVICE_PAIRS_HPP
#define MEETC_APP_DEVICE_PAIRS_HPP

#include "core/collide.hpp"

#include <string>
#include <string_view>

namespace meetc::app {

enum class processor : std::uint8_t { cpu, cuda };

// "auto" is the CPU: see docs/gpu.md for what would have to be large before a device pays for its start. Throws
// failure where the name is none, or where this build has no CUDA.
processor processor_named(std::string_view name);

struct device_pairs {
  result found;
  std::string device, model; // "NVIDIA H200"; what the filter assumes of it: "wgmma-f16-f32", "none"
  double device_seconds = 0; // kernels alone
  double start_seconds = 0;  // until the device was ready and the sets there
};

// Throws failure, with exit code no_device, where there is no device, or it fails or lacks the memory.
device_pairs pairs_on_device(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
                             const collide_options &options);

} // namespace meetc::app

#endif
