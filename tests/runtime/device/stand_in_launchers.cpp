// The launchers for lists of pairs, on the host: see stand_in.cpp. They use the CPU's own tables, so a comparison pair
// by pair is trivial; the truth, the counting and the queries on sets are not.
#include <cga/cga_cuda.hpp>
#include <cga/cga_runtime.hpp>

#include <cstring>

namespace {

const meetc::predicate_info *named(const char *name) {
  const meetc::catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i)
    if (std::strcmp(all.predicates[i].name, name) == 0)
      return &all.predicates[i];
  return nullptr;
}
cudaError_t launch(meetc::decide_function f, const float *a, const float *b, const meetc::index_pair *pairs,
                   std::size_t n, meetc::answer *out) {
  f(a, b, pairs, n, out);
  return cudaSuccess;
}

} // namespace

#define MEETC_STAND_IN(name)                                                                                           \
  cudaError_t name::decide(::meetc::rung r, const float *a, const float *b, const ::meetc::index_pair *pairs,          \
                           std::size_t n, ::meetc::answer *out, cudaStream_t) {                                        \
    return launch(named(#name)->decide[static_cast<int>(r)], a, b, pairs, n, out);                                     \
  }                                                                                                                    \
  cudaError_t name::certify(::meetc::rung r, const float *a, const float *b, const ::meetc::index_pair *pairs,         \
                            std::size_t n, ::meetc::answer *out, cudaStream_t) {                                       \
    return launch(named(#name)->certify[static_cast<int>(r)], a, b, pairs, n, out);                                    \
  }

namespace cga::cuda {
MEETC_STAND_IN(segment_segment)
MEETC_STAND_IN(point_triangle)
MEETC_STAND_IN(segment_triangle)
MEETC_STAND_IN(triangle_triangle)
MEETC_STAND_IN(sphere_sphere)
MEETC_STAND_IN(ball_ball)
MEETC_STAND_IN(ball_segment)
MEETC_STAND_IN(sphere_segment)
MEETC_STAND_IN(ball_triangle)
MEETC_STAND_IN(sphere_triangle)
MEETC_STAND_IN(box_box)
} // namespace cga::cuda
