#include "meet/app/world/world_on.hpp"

#include "meet/app/input/failure.hpp"

#if MEETC_WITH_CUDA
#include "cga/cga_cuda.hpp"
#include "meet/core/device/world.hpp"
#endif

namespace meetc::app {

#if MEETC_WITH_CUDA
struct world_on::there {
  device on;
  device_world bodies;
  explicit there(const world &of) : on(cga::cuda::catalogue()), bodies(on, of) {}
};

world_on::world_on(processor on, const world &of) : of_(of) {
  if (on == processor::cuda)
    try {
      there_ = std::make_unique<there>(of);
    } catch (const device_error &e) {
      throw failure(e.what(), no_device);
    }
}

world_answer world_on::touching(const world_options &options) {
  if (!there_)
    return of_.touching(options);
  try {
    return there_->bodies.touching(options);
  } catch (const device_error &e) {
    throw failure(e.what(), no_device);
  }
}

std::string world_on::device_name() const {
  return there_ ? there_->on.facts().name : "";
}
#else
struct world_on::there {};

world_on::world_on(processor, const world &of) : of_(of) {}

world_answer world_on::touching(const world_options &options) {
  return of_.touching(options);
}

std::string world_on::device_name() const {
  return "";
}
#endif

world_on::~world_on() = default;

} // namespace meetc::app
