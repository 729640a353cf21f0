// Decisions on lists of pairs.
//
// Each step reads one list and appends to others, so that the next step finds its pairs side by side. Included by nvcc only.
#ifndef MEETC_CUDA_STEPS_HPP
#define MEETC_CUDA_STEPS_HPP

#include <meetc/cuda/lists.hpp>
#include <meetc/decide/decide.hpp>
#include <meetc/decide/tolerant.hpp>

namespace meetc::cuda {

// Where answers go: an array with one answer for each pair, or two lists.
struct sink {
  answer *answers; // null: the lists
  pair_list yes, unsure;
};

// Rows of so few numbers are loaded together for all pairs of a lane; others would take too many registers.
template <class P> inline constexpr bool loads_together = P::inputs_a + P::inputs_b <= 8;

// in.count may be null: there are then in.capacity pairs.
template <class P, class Of>
__global__ void __launch_bounds__(step_threads) decide_kernel(const float *a, const float *b, pair_list in, sink to) {
  begin();
  __shared__ index_pair rooms[step_warps][waiting_pairs];
  waiting_list<> hits(to.yes, rooms[threadIdx.x / 32]);
  // A warp stays whole, since a lane without pairs takes part as well.
  for (list_share w(in); w.at < w.n; w.at += w.stride) {
    index_pair p[step_pairs] = {};
    unsigned yes = 0, unsure = 0;
    const auto take = [&](int k, answer x) {
      yes |= (x == answer::yes) << k;
      unsure |= (x == answer::unsure) << k;
      if (to.answers)
        to.answers[w.index(k)] = x;
    };
    if constexpr (loads_together<P>) {
      float rows_a[step_pairs][P::inputs_a], rows_b[step_pairs][P::inputs_b];
#pragma unroll
      for (int k = 0; k < step_pairs; ++k)
        if (w.index(k) < w.n)
          p[k] = in.pairs[w.index(k)];
#pragma unroll
      for (int k = 0; k < step_pairs; ++k)
        if (w.index(k) < w.n) {
          for (int i = 0; i < P::inputs_a; ++i)
            rows_a[k][i] = a[std::size_t{p[k].a} * P::inputs_a + i];
          for (int i = 0; i < P::inputs_b; ++i)
            rows_b[k][i] = b[std::size_t{p[k].b} * P::inputs_b + i];
        }
#pragma unroll
      for (int k = 0; k < step_pairs; ++k)
        if (w.index(k) < w.n)
          take(k, Of::of(rows_a[k], rows_b[k]));
    } else {
      MEETC_ROLLED
      for (int k = 0; k < step_pairs; ++k) {
        if (w.index(k) >= w.n)
          break;
        const index_pair q = in.pairs[w.index(k)];
        take(k, Of::of(a + std::size_t{q.a} * P::inputs_a, b + std::size_t{q.b} * P::inputs_b));
      }
#pragma unroll
      for (int k = 0; k < step_pairs; ++k)
        if ((yes | unsure) >> k & 1)
          p[k] = in.pairs[w.index(k)];
    }
    if (to.answers)
      continue;
    hits.append(yes, p);
    append(unsure, p, to.unsure);
  }
  if (!to.answers)
    hits.flush_block<step_warps>();
}

// The pairs that the reject stage, certified in fp32, does not rule out, and that equal points do not settle, are kept.
template <class P>
__global__ void __launch_bounds__(step_threads)
    reject_kernel(const float *a, const float *b, pair_list in, pair_list yes, pair_list kept) {
  begin();
  constexpr unsigned room = waiting_pairs / 2;
  __shared__ index_pair rooms[step_warps][2][room];
  waiting_list<room> list(kept, rooms[threadIdx.x / 32][0]), hits(yes, rooms[threadIdx.x / 32][1]);
  const bool standard = standard_environment();
  for (list_share w(in); w.at < w.n; w.at += w.stride) {
    index_pair p[step_pairs] = {};
    unsigned keep = 0, hit = 0;
#pragma unroll
    for (int k = 0; k < step_pairs; ++k)
      if (w.index(k) < w.n)
        p[k] = in.pairs[w.index(k)], keep |= 1U << k;
    if (standard) {
      MEETC_ROLLED
      for (unsigned left = keep; left; left &= left - 1) {
        const int k = __ffs(left) - 1;
        const index_pair q = in.pairs[w.index(k)];
        found_signs<P> found;
        const float *const row_a = a + std::size_t{q.a} * P::inputs_a, *const row_b =
                                                                           b + std::size_t{q.b} * P::inputs_b;
        const progress at = try_to_reject<P>(bounded_signs<P, in_fp32>(row_a, row_b), found);
        keep &= ~(static_cast<unsigned>(at != progress::open) << k);
        hit |= static_cast<unsigned>(at == progress::hit) << k;
      }
    }
    if constexpr (P::coincidences > 0)
      hits.append(hit, p);
    list.append(keep, p);
  }
  hits.flush();
  list.flush();
}

template <class P, class T> struct plain_step {
  __device__ static answer of(const float *a, const float *b) { return to_answer(decide<P>(plain_signs<P, T>(a, b))); }
};
template <class P> struct exact_step {
  __device__ static answer of(const float *a, const float *b) { return to_answer(decide_exact<P>(a, b)); }
};
template <class P, class A> struct certify_step {
  __device__ static answer of(const float *a, const float *b) {
    return standard_environment() ? certify<P, A>(a, b) : answer::unsure;
  }
};

// Decides the pairs that certify_fp32 leaves, a lane a pair. Pairs that a rung leaves unsure wait in shared memory until they
// fill the lanes.
template <class P>
__global__ void __launch_bounds__(step_threads)
    rest_kernel(const float *a, const float *b, pair_list in, pair_list yes, unsigned long long *left) {
  begin();
  constexpr unsigned room = 64;                     // a full warp, and what a full warp adds to fewer
  __shared__ index_pair rooms[step_warps][2][room]; // of those that fp64 and double-double leave
  index_pair(&waiting)[2][room] = rooms[threadIdx.x / 32];
  unsigned waits[2] = {0, 0}, passed[2] = {0, 0};
  const unsigned lane = threadIdx.x % 32;
  const unsigned long long n = *in.count < in.capacity ? *in.count : in.capacity,
                           stride = gridDim.x * std::size_t{step_threads};
  for (unsigned long long at = blockIdx.x * std::size_t{step_threads} + threadIdx.x / 32 * 32;;) {
    const bool ends = at >= n;
    int stage; // of the rungs
    if (waits[1] >= 32 || (ends && waits[0] == 0 && waits[1] > 0))
      stage = 2;
    else if (waits[0] >= 32 || (ends && waits[0] > 0))
      stage = 1;
    else if (!ends)
      stage = 0;
    else
      break;
    index_pair p[1] = {};
    bool there;
    if (stage == 0) {
      there = at + lane < n;
      if (there)
        p[0] = in.pairs[at + lane];
      at += stride;
    } else {
      unsigned &w = waits[stage - 1];
      const unsigned taken = w < 32 ? w : 32;
      w -= taken;
      there = lane < taken;
      if (there)
        p[0] = waiting[stage - 1][w + lane];
      __syncwarp();
    }
    answer x = answer::no;
    if (there) {
      const float *const row_a = a + std::size_t{p[0].a} * P::inputs_a, *const row_b =
                                                                            b + std::size_t{p[0].b} * P::inputs_b;
      x = stage == 0   ? certify_step<P, in_fp64>::of(row_a, row_b)
          : stage == 1 ? certify_step<P, in_fp64x2>::of(row_a, row_b)
                       : exact_step<P>::of(row_a, row_b);
    }
    append_hits(x == answer::yes, p, yes);
    const unsigned unsure = __ballot_sync(~0U, x == answer::unsure);
    if (unsure == 0) // always after the exact rung
      continue;
    if (x == answer::unsure)
      waiting[stage][waits[stage] + __popc(unsure & ((1U << lane) - 1))] = p[0];
    waits[stage] += __popc(unsure);
    passed[stage] += __popc(unsure);
    __syncwarp();
  }
  if (lane < 2 && passed[lane] > 0)
    atomicAdd(left + lane, static_cast<unsigned long long>(passed[lane]));
}

template <class P> struct certified_step {
  __device__ static answer of(const float *a, const float *b) { return to_answer(decide_certified<P>(a, b)); }
};

template <class P> struct tolerant_step {
  __device__ static answer of(const float *a, const float *b) { return to_answer(decide_tolerant<P>(a, b)); }
};

template <class P, class Of>
cudaError_t answer_list(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out,
                        cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const std::size_t wanted = (n + step_threads * step_pairs - 1) / (step_threads * step_pairs);
  const unsigned blocks = wanted < 0x7fffffff ? static_cast<unsigned>(wanted) : 0x7fffffff;
  const pair_list in{const_cast<index_pair *>(pairs), nullptr, n}; // which is only read
  return launch<decide_kernel<P, Of>>(blocks, step_threads, stream, a, b, in, sink{out, {}, {}});
}
template <class P, class Of>
cudaError_t decide_list(const float *a, const float *b, pair_list in, pair_list yes, pair_list unsure,
                        cudaStream_t stream) {
  return launch_step<decide_kernel<P, Of>>(stream, a, b, in, sink{nullptr, yes, unsure});
}

// The rungs that the scene asks for, as bits 1 << rung.
constexpr bool asks(unsigned rungs, rung r) {
  return (rungs >> static_cast<int>(r) & 1) != 0;
}

// The launchers of one predicate for lists of pairs of rows.
template <class P, unsigned Rungs>
cudaError_t decide_rows(rung which, const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out,
                        cudaStream_t stream) {
  switch (which) {
  case rung::fp32:
    if constexpr (asks(Rungs, rung::fp32))
      return answer_list<P, plain_step<P, float>>(a, b, pairs, n, out, stream);
    break;
  case rung::fp64:
    if constexpr (asks(Rungs, rung::fp64))
      return answer_list<P, plain_step<P, double>>(a, b, pairs, n, out, stream);
    break;
  case rung::fp64x2:
    if constexpr (asks(Rungs, rung::fp64x2))
      return answer_list<P, plain_step<P, double_double>>(a, b, pairs, n, out, stream);
    break;
  case rung::exact:
    if constexpr (asks(Rungs, rung::exact) || asks(Rungs, rung::certified))
      return answer_list<P, exact_step<P>>(a, b, pairs, n, out, stream);
    break;
  case rung::certified:
    if constexpr (asks(Rungs, rung::certified))
      return answer_list<P, certified_step<P>>(a, b, pairs, n, out, stream);
    break;
  case rung::tolerant:
    if constexpr (asks(Rungs, rung::tolerant) && keeps_tolerance<P>)
      return answer_list<P, tolerant_step<P>>(a, b, pairs, n, out, stream);
    break;
  }
  return cudaErrorInvalidValue;
}
template <class P>
cudaError_t certify_rows(rung which, const float *a, const float *b, const index_pair *pairs, std::size_t n,
                         answer *out, cudaStream_t stream) {
  switch (which) {
  case rung::fp32:
    return answer_list<P, certify_step<P, in_fp32>>(a, b, pairs, n, out, stream);
  case rung::fp64:
    return answer_list<P, certify_step<P, in_fp64>>(a, b, pairs, n, out, stream);
  case rung::fp64x2:
    return answer_list<P, certify_step<P, in_fp64x2>>(a, b, pairs, n, out, stream);
  default:
    return cudaErrorInvalidValue;
  }
}

template <class P, unsigned Rungs>
cudaError_t run(step which, const float *a, const float *b, pair_list in, pair_list yes, pair_list left,
                cudaStream_t stream) {
  constexpr bool certified = asks(Rungs, rung::certified);
  switch (which) {
  case step::reject:
    if constexpr (certified && P::reject_stage::atoms > 0)
      return launch_step<reject_kernel<P>>(stream, a, b, in, yes, left);
    break;
  case step::plain_fp32:
    if constexpr (asks(Rungs, rung::fp32))
      return decide_list<P, plain_step<P, float>>(a, b, in, yes, left, stream);
    break;
  case step::plain_fp64:
    if constexpr (asks(Rungs, rung::fp64))
      return decide_list<P, plain_step<P, double>>(a, b, in, yes, left, stream);
    break;
  case step::plain_fp64x2:
    if constexpr (asks(Rungs, rung::fp64x2))
      return decide_list<P, plain_step<P, double_double>>(a, b, in, yes, left, stream);
    break;
  case step::exact:
    if constexpr (asks(Rungs, rung::exact) || certified)
      return decide_list<P, exact_step<P>>(a, b, in, yes, left, stream);
    break;
  case step::tolerant:
    if constexpr (asks(Rungs, rung::tolerant) && keeps_tolerance<P>)
      return decide_list<P, tolerant_step<P>>(a, b, in, yes, left, stream);
    break;
  case step::certify_fp32:
    if constexpr (certified)
      return decide_list<P, certify_step<P, in_fp32>>(a, b, in, yes, left, stream);
    break;
  case step::certify_rest:
    if constexpr (certified)
      return launch_step<rest_kernel<P>>(stream, a, b, in, yes, left.count);
    break;
  }
  return cudaErrorInvalidValue;
}

} // namespace meetc::cuda

#endif
