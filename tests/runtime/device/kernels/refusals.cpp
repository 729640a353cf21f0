// The messages for devices and drivers that cannot be used, one line each. No such device is needed to test them.
#include <cstdio>
#include <meet/core/device/memory/device.hpp>
#include <string>

namespace {
int wrong = 0;
void expect(const std::string &said, const std::string &wanted) {
  if (said.find(wanted) == std::string::npos || (wanted.empty() && !said.empty()) ||
      said.find('\n') != std::string::npos || (!said.empty() && said.find("(--device cpu)") == std::string::npos)) {
    std::printf("said '%s', not '%s'\n", said.c_str(), wanted.c_str());
    ++wrong;
  }
}
} // namespace

int main() {
  const meetc::device_facts new_one{"GPU A", 9, 0, 132, 1}, old_one{"GPU B", 7, 5, 40, 1}, none;
  expect(meetc::refusal(cudaSuccess, 1, 13000, new_one), "");
  expect(meetc::refusal(cudaSuccess, 1, 13000, old_one),
         "the CUDA device GPU B has compute capability 7.5 and 8.0 is needed");
  expect(meetc::refusal(cudaSuccess, 0, 13000, none), "there is no CUDA device here");
  expect(meetc::refusal(cudaErrorNoDevice, 0, 13000, none), "there is no CUDA device here");
  expect(meetc::refusal(cudaErrorInsufficientDriver, 0, 0, none), "there is no CUDA device here");
  expect(meetc::refusal(cudaErrorInsufficientDriver, 0, 11040, none),
         "the CUDA driver is for CUDA 11.4 and this build needs ");
  expect(meetc::refusal(cudaErrorSystemNotReady, 0, 13000, none), "CUDA: looking for a device: ");
  std::printf("%d wrong\n", wrong);
  return wrong != 0;
}
