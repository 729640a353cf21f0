// Opens a device, which may or may not exist.
#include <cell/cell_cuda.hpp>
#include <core/device/collide.hpp>
#include <cstdio>

int main() {
  try {
    const meetc::device on(cell::cuda::catalogue());
    std::printf("device: ready\n");
  } catch (const meetc::device_error &e) {
    std::printf("device: %s\n", e.what());
  }
}
