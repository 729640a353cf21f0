// The host keeps the model of the matrix units.
#pragma once
#include <meetc/every_pair/table.hpp>

namespace meetc::every_pair {

inline cudaError_t probe(probe_result *out, cudaStream_t) {
  *out = {0, 0, 1, 1};
  return cudaSuccess;
}

} // namespace meetc::every_pair
