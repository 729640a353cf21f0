#include "meet/core/device/query/label_places.hpp"

#include "meet/core/device/memory/blocks.hpp"

#include <meetc/contact/place.hpp>
#include <meetc/cuda/launch.hpp>

#include <cmath>

namespace meetc::on_device {
namespace {

template <class Real> __global__ void __launch_bounds__(threads) place_kernel(place_job job, Real *points) {
  const Real none = static_cast<Real>(NAN); // no coordinate
  cuda::begin();
  for (std::size_t i = blockIdx.x * std::size_t{threads} + threadIdx.x; i < job.count;
       i += gridDim.x * std::size_t{threads}) {
    const node_source node = job.nodes[i];
    const contact_element a{job.a + std::size_t{3} * static_cast<unsigned>(job.corners_a) * node.a, job.corners_a},
        b{job.b + std::size_t{3} * static_cast<unsigned>(job.corners_b) * node.b, job.corners_b};
    const label_place<Real> place(label_points(a, b, node.label));
    for (int k = 0; k < 3; ++k) {
      Real x;
      points[3 * i + k] = place.find(k, x) ? x : none;
    }
  }
}

template <class Real> cudaError_t start(const place_job &job, Real *points, cudaStream_t stream) {
  return job.count == 0 ? cudaSuccess
                        : cuda::launch<place_kernel<Real>>(blocks_for(job.count), threads, stream, job, points);
}

} // namespace

cudaError_t place_labels(const place_job &job, float *points, cudaStream_t stream) {
  return start(job, points, stream);
}
cudaError_t place_labels(const place_job &job, double *points, cudaStream_t stream) {
  return start(job, points, stream);
}

} // namespace meetc::on_device
