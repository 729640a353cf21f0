#include "app/bench/device.hpp"

#include "app/failure.hpp"
#include "io/error.hpp"

#include <fmt/format.h>

namespace meet::app {

std::unique_ptr<bench_device> open_bench_device() {
  return nullptr; // this build decides pairs on the CPU
}

std::unique_ptr<bench_device> bench_device_named(const std::string &name) {
  if (name != "auto" && name != "cpu" && name != "cuda")
    throw failure(fmt::format("--device {}: unknown; known: auto, cpu, cuda", io::quote(name)));
  if (name == "cpu")
    return nullptr;
  std::unique_ptr<bench_device> device = open_bench_device();
  if (!device && name == "cuda")
    throw failure("--device cuda: this build decides pairs on the CPU; use --device cpu", no_device);
  return device;
}

} // namespace meet::app
