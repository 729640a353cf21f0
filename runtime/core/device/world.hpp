// core/device/world.hpp: which bodies of a world touch, on a CUDA device.
//
// Each body that comes near another one is uploaded once, in its own frame, and is posed there when it has moved. The host
// compares the bounds of bodies, and finds the bodies inside others. Answers are those of world::touching(), but for
// candidates, which are counted as in core/device/collide.hpp.
#ifndef MEETC_CORE_DEVICE_WORLD_HPP
#define MEETC_CORE_DEVICE_WORLD_HPP

#include "meet/core/device/set/device_set.hpp"
#include "meet/core/world/world.hpp"

#include <optional>
#include <vector>

namespace meetc {

// One thread at a time asks it. Its memory on the device grows with the bodies that have come near others.
class device_world {
public:
  // `of` must outlive this. Between two questions bodies may be added, moved and ignored there.
  device_world(const device &on, const world &of) : on_(on), of_(of) {}

  // Options are those of world::touching(), without threads and box. Pairs of bodies are asked one after another. Throws what
  // that throws, and device_error; all elements of a body that is near another one must be finite in its pose.
  world_answer touching(const world_options &options = {});

private:
  struct body {
    device_set there;
    pose at; // of `there`
  };
  device on_;
  const world &of_;
  std::vector<std::optional<body>> bodies_; // by number

  void place(std::uint32_t number);
  world_answer ask(const world_options &options);
};

} // namespace meetc

#endif
