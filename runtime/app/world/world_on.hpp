// app/world/world_on.hpp: asks a world on the processor that a user has named.
#ifndef MEETC_APP_WORLD_WORLD_ON_HPP
#define MEETC_APP_WORLD_WORLD_ON_HPP

#include "meet/app/query/device_pairs.hpp"
#include "meet/core/world/world.hpp"

#include <memory>
#include <string>

namespace meetc::app {

class world_on {
public:
  // `of` must outlive this. The best processor is the CPU, which has answered before a device has started. Throws failure, with
  // exit code no_device, as touching() does where the device fails.
  world_on(processor on, const world &of);
  ~world_on();

  world_answer touching(const world_options &options);
  // "NVIDIA H200"; empty: the CPU is asked.
  std::string device_name() const;

private:
  struct there;
  const world &of_;
  std::unique_ptr<there> there_; // null: the CPU
};

} // namespace meetc::app

#endif
