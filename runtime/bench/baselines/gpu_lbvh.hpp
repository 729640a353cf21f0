// bench/baselines/gpu_lbvh.hpp: the hierarchy of baseline_lbvh.hpp on the CUDA device.
#ifndef MEETC_BENCH_BASELINES_GPU_LBVH_HPP
#define MEETC_BENCH_BASELINES_GPU_LBVH_HPP

#include "meet/bench/baselines/gpu_baselines.hpp"
#include "meet/bench/baselines/lbvh.hpp"
#include "meet/core/device/memory/memory.hpp"
#include "meetc/table/table.hpp"

namespace meetc::bench {

// Leaves are the rows of one kind: balls of 4 fields, segments and boxes of 6, triangles of 9.
class gpu_lbvh {
public:
  // For up to this many elements. Throws device_error where memory does not suffice.
  gpu_lbvh(std::uint32_t elements, unsigned fields);

  // Enqueues: codes in this box, sort, rows in their order, nodes, boxes. Rows are finite.
  cudaError_t build(const float *rows, const baselines::lbvh_box &within, cudaStream_t stream);
  // Enqueues: each of n rows of A walks down, the test is made at the leaves in fp32, and pairs that it accepts are written, in
  // no order, up to `capacity` of them. Adds the number of all of them to *count. The test is that of one pair of kinds.
  cudaError_t query(baseline by, const float *a, std::uint32_t n, index_pair *pairs, unsigned long long capacity,
                    unsigned long long *count, cudaStream_t stream) const;
  // The same for the set with itself: each pair of two elements once.
  cudaError_t query_itself(baseline by, index_pair *pairs, unsigned long long capacity, unsigned long long *count,
                           cudaStream_t stream) const;

  // Enqueues: for each of n segments the number of the triangle that it hits first, by Möller-Trumbore in fp32 over nearer
  // children first, or all bits where it hits none.
  cudaError_t first(const float *segments, std::uint32_t n, std::uint32_t *first, cudaStream_t stream) const;

private:
  cudaError_t start(baseline by, const float *a, std::uint32_t n, bool itself, index_pair *pairs,
                    unsigned long long capacity, unsigned long long *count, cudaStream_t stream) const;

  std::uint32_t elements_;
  unsigned fields_;
  std::size_t space_bytes_ = 0;
  device_memory<std::uint32_t> codes_, sorted_, numbers_, order_, of_nodes_, of_leaves_, arrived_;
  device_memory<float> rows_;
  device_memory<baselines::lbvh_node> nodes_;
  device_memory<std::byte> space_;
};

} // namespace meetc::bench

#endif
