// Decides no pair, so it needs no device.
#include <cell/cell.hpp>
#include <cell/cell_cuda.hpp>
#include <cstdio>

int main() {
  const cudaError_t none =
      cell::cuda::ball_ball::decide(meetc::rung::exact, nullptr, nullptr, nullptr, 0, nullptr, nullptr);
  std::printf("launcher %d, hit %d\n", static_cast<int>(none), cell::ball_ball::hit({{0, 0, 0}, 1}, {{2, 0, 0}, 1}));
}
