// The signs of the largest predicates on a device, and its arithmetic.
#include "same_signs.hpp"

#include <cga/ball_triangle.hpp>
#include <cga/cga_cuda.hpp>
#include <cga/triangle_triangle.hpp>

namespace cuda_test {

long same_signs() {
  return same<cga::triangle_triangle>("triangle_triangle") + same<cga::ball_triangle>("ball_triangle");
}

// The arithmetic of this translation unit and of the launchers' own.
long sound_arithmetic() {
  const buffer<unsigned> faults(2);
  check(meetc::launch_self_test(faults.data(), nullptr), "self-test");
  check(cga::cuda::self_test(faults.data() + 1, nullptr), "self-test of the launchers");
  check(cudaDeviceSynchronize(), "self-test");
  const std::vector<unsigned> found = faults.read();
  std::printf("self-test here     %s\nself-test there    %s\n", meetc::text_of_faults(found[0]),
              meetc::text_of_faults(found[1]));
  return (found[0] != 0) + (found[1] != 0);
}

} // namespace cuda_test
