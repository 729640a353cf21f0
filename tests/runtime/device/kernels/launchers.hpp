// Every predicate's launchers for lists of pairs, by name.
#pragma once
#include <cga/cga_cuda.hpp>

#include <cstring>
#include <stdexcept>
#include <string>

namespace cuda_test {

using launcher = cudaError_t (*)(meetc::rung, const float *, const float *, const meetc::index_pair *, std::size_t,
                                 meetc::answer *, cudaStream_t);

struct launchers {
  const char *name;
  launcher decide, certify;
};

inline const launchers &launchers_of(const char *name) {
  static const launchers all[] = {
      {"segment_segment", cga::cuda::segment_segment::decide, cga::cuda::segment_segment::certify},
      {"point_triangle", cga::cuda::point_triangle::decide, cga::cuda::point_triangle::certify},
      {"segment_triangle", cga::cuda::segment_triangle::decide, cga::cuda::segment_triangle::certify},
      {"triangle_triangle", cga::cuda::triangle_triangle::decide, cga::cuda::triangle_triangle::certify},
      {"sphere_sphere", cga::cuda::sphere_sphere::decide, cga::cuda::sphere_sphere::certify},
      {"ball_ball", cga::cuda::ball_ball::decide, cga::cuda::ball_ball::certify},
      {"ball_segment", cga::cuda::ball_segment::decide, cga::cuda::ball_segment::certify},
      {"sphere_segment", cga::cuda::sphere_segment::decide, cga::cuda::sphere_segment::certify},
      {"ball_triangle", cga::cuda::ball_triangle::decide, cga::cuda::ball_triangle::certify},
      {"sphere_triangle", cga::cuda::sphere_triangle::decide, cga::cuda::sphere_triangle::certify},
      {"box_box", cga::cuda::box_box::decide, cga::cuda::box_box::certify}};
  for (const auto &row : all)
    if (std::strcmp(row.name, name) == 0)
      return row;
  throw std::runtime_error(std::string("no launcher for ") + name);
}

// Whether a device's answer is another one than the CPU's. bounded: the number of the bounded rung, or -1 for the rungs
// that are never unsure. The CPU runs the rungs in fp32 and fp64 in lanes, and may be unsure of other pairs. In fp32 the
// device decides all that lanes do.
inline bool differ(meetc::answer cpu, meetc::answer device, int bounded) {
  const auto unsure = meetc::answer::unsure;
  if (bounded < 0 || bounded > 1 || (cpu != unsure && device != unsure))
    return cpu != device;
  return bounded == 0 && device == unsure && cpu != unsure;
}

} // namespace cuda_test
