// Opens a device, which may or may not exist.
#include <cell/cell_cuda.hpp>
#include <cell/cell_every_pair.hpp>
#include <cstdio>
#include <meet/core/device/every_pair/engine.hpp>

int main() {
  try {
    meetc::device on(cell::cuda::catalogue());
    const meetc::every_pair::engine brute(on, cell::every_pair::catalogue());
    std::printf("device: ready\n");
  } catch (const meetc::missing_device &e) {
    std::printf("device: %s\n", e.what());
  }
  // A failure of memory has a type of its own.
  try {
    meetc::check(cudaErrorMemoryAllocation, "asking for memory");
  } catch (const meetc::device_memory_error &e) {
    std::printf("memory: %s\n", e.what());
  }
}
