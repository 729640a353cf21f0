// Signs whose numbers have groups, on a device: the same as on the CPU.
#include "tests/runtime/device/kernels/same_signs.hpp"

#include <exception>
#include <groups/header_only.hpp>

int main() {
  using namespace cuda_test;
  if (no_device())
    return skipped;
  try {
    const long differences = same<groups::squared_sphere_plane_sign>("sphere, plane") +
                             same<groups::squared_circle_plane_sign>("circle, plane") +
                             same<groups::squared_point_pair_plane_sign>("point pair, plane") +
                             same<groups::squared_circle_circle_sign>("circle, circle") +
                             same<groups::line_in_plane>("line in plane") +
                             same<groups::circle_on_sphere>("circle on sphere");
    std::printf("%ld differences between CPU and device\n", differences);
    return differences ? 1 : 0;
  } catch (const std::exception &e) {
    std::printf("error: %s\n", e.what());
    return 1;
  }
}
