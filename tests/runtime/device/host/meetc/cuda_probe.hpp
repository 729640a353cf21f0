// The host keeps the model of the matrix unit, and its arithmetic is tested elsewhere.
#pragma once
#include <meetc/cuda_table.hpp>
#include <meetc/self_test.hpp>

namespace meetc::cuda {

inline cudaError_t probe(probe_result *out, cudaStream_t) {
  *out = {0, 0, 0, 1, 1};
  return cudaSuccess;
}

} // namespace meetc::cuda
namespace meetc {

inline cudaError_t launch_self_test(unsigned *faults, cudaStream_t) {
  *faults = 0;
  return cudaSuccess;
}

} // namespace meetc
