// The steps that make hits of candidates, one after another on a stream. They do not know how a candidate was found.
#ifndef MEETC_CUDA_CASCADE_HPP
#define MEETC_CUDA_CASCADE_HPP

#include <meetc/cuda/table.hpp>

namespace meetc::cuda {

// The lists of pairs between two steps. All counters are 0 at first but that of the candidates.
struct cascade_lists {
  pair_list candidates; // pairs of slots whose boxes touch; later steps write over them
  pair_list kept;       // those that the reject stage keeps
  unsigned long long
      *unsure; // bounded_rungs numbers: the pairs that fp32, fp64 and double-double left to the next rung
};

// Enqueues them. A list that was too short is told by its count; nothing that was found then means anything. Returns
// cudaErrorInvalidValue where the scene does not ask for the rung.
inline cudaError_t decide(const predicate_launchers &p, rung precision, const float *rows_a, const float *rows_b,
                          const cascade_lists &lists, const pair_list &hits, cudaStream_t stream) {
  const cascade_steps steps = steps_of(precision);
  if (steps.count == 0)
    return cudaErrorInvalidValue;
  pair_list in = lists.candidates, out = lists.kept;
  const auto run = [&](step which) {
    const cudaError_t e = p.pairs.run(which, rows_a, rows_b, in, hits, out, stream);
    const pair_list done = in;
    in = out, out = done;
    return e;
  };
  cudaError_t e = cudaSuccess;
  if (precision == rung::certified && p.rejects)
    e = run(step::reject);
  for (int s = 0; s < steps.count && e == cudaSuccess; ++s) {
    out.count = lists.unsure + s;
    e = run(steps.of[s]);
  }
  return e;
}

} // namespace meetc::cuda

#endif
