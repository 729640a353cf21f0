// The question of capsules.cpp, on a CUDA device.
#include "scene.hpp"

#include <cell/cell_cuda.hpp>
#include <cell/cell_runtime.hpp>
#include <meet/core/device/collide.hpp>

int main() try {
  const meetc::device gpu(cell::cuda::catalogue());
  const meetc::predicate_info &touch = meetc::find_predicate(cell::catalogue(), "ball_capsule");
  const std::vector<cell::sphere<float>> balls = lattice();
  meetc::device_set a(gpu, meet::elements_of(*touch.a, balls).view, *touch.a);
  meetc::device_set b(gpu, meet::elements_of(*touch.b, arm).view, *touch.b);
  print(meetc::collide(gpu, a, b, touch, meetc::rung::certified).pairs);
} catch (const meetc::device_error &e) {
  std::printf("device: %s\n", e.what());
  return 3;
}
