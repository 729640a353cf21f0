// A device that another part of the program has reset: the attributes that a kernel was given are forgotten, and must be set
// again.
#include "engine.hpp"

#include <cga/cga_cuda.hpp>

namespace cuda_test {

bool answers_after_reset() {
  using namespace meetc;
  engine random(70);
  const predicate_info &p = predicate_named("ball_ball");
  const rows_of x = random_rows(*p.a, 3000, {1, 0.1, 1, 0}, random),
                y = random_rows(*p.b, 3000, {1, 0.1, 1, 0}, random);
  const auto pairs = [&] {
    device on(cga::cuda::catalogue());
    device_set a(on, view_of(x), *p.a), b(on, view_of(y), *p.b);
    return collide(on, a, b, p, rung::certified).pairs;
  };
  const std::vector<index_pair> before = pairs();
  if (before.empty() || cudaDeviceReset() != cudaSuccess)
    return false;
  return same_list(before, pairs());
}

} // namespace cuda_test
