// Decisions on lists of pairs.
//
// Each step reads one list and appends to others, so that the next step finds its pairs side by side. Only the device
// knows how long a list is: kernels are launched for the whole device and walk the list in strides. Included by nvcc
// only.
#ifndef MEETC_CUDA_STEPS_HPP
#define MEETC_CUDA_STEPS_HPP

#include <meetc/cuda_launch.hpp>
#include <meetc/cuda_lists.hpp>
#include <meetc/near.hpp>
#include <meetc/tolerant.hpp>

namespace meetc::cuda {

inline constexpr int step_threads = 128, step_warps = step_threads / 32;
// Enqueues a step for the whole device.
template <auto Kernel, class... Arguments> cudaError_t launch_step(cudaStream_t stream, const Arguments &...arguments) {
  return launch<Kernel>(blocks_at_once<Kernel, step_threads>(), step_threads, stream, arguments...);
}

// Where answers go: an array with one answer for each pair, or two lists.
struct sink {
  answer *answers; // null: the lists
  pair_list yes, unsure;
};

// The number of pairs that a lane takes at once from a long list: their rows are loaded together, and counters are
// updated less often. From a short list a lane takes one pair, so that all lanes have work.
inline constexpr int step_pairs = 4;

// The share of a list that a warp takes at a time, and where it begins.
struct walk {
  unsigned long long n, at, stride;
  unsigned each; // pairs for a lane
  // `times`: the number of pairs in each entry of the list.
  __device__ explicit walk(const pair_list &l, unsigned times = 1)
      : n((l.count && *l.count < l.capacity ? *l.count : l.capacity) * times) {
    const unsigned long long lanes = gridDim.x * std::size_t{step_threads};
    each = n >= lanes * step_pairs ? step_pairs : 1;
    at = (blockIdx.x * std::size_t{step_threads} + threadIdx.x / 32 * 32) * each;
    stride = lanes * each;
  }
  // The index of this lane's pair k; n or more if it has no such pair.
  __device__ unsigned long long index(unsigned k) const { return k < each ? at + threadIdx.x % 32 + 32 * k : n; }
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
  for (walk w(in); w.at < w.n; w.at += w.stride) {
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

// Pair i of the pairs of slots in a list of pairs of objects; false if a group has no such slot.
__device__ inline bool slots_of(const index_pair *objects, unsigned long long i, const operand &a, const operand &b,
                                index_pair &p) {
  if (a.by == grouping::single) {
    p = objects[i];
    return true;
  }
  const index_pair q = objects[i / (group_size * group_size)];
  const auto within = static_cast<std::uint32_t>(i % (group_size * group_size));
  const index_pair slots{q.a * group_size + within / group_size, q.b * group_size + within % group_size};
  const bool there = slots.a < a.elements && slots.b < b.elements;
  p = there ? slots : index_pair{0, 0};
  return there;
}

// Boxes: they are tested.
template <class P, class A, class B, bool Boxes, bool Reject>
__global__ void __launch_bounds__(step_threads)
    near_kernel(operand a, operand b, pair_list in, pair_list yes, pair_list kept, unsigned long long *touching) {
  begin();
  constexpr bool rejects = Reject && P::reject_stage::atoms > 0;
  constexpr bool settles = [] {
    if constexpr (rejects) // a predicate without bounds knows no coincidences
      return P::coincidences > 0;
    else
      return false;
  }();
  constexpr unsigned room = waiting_pairs / 2;
  __shared__ index_pair rooms[step_warps][2][room];
  waiting_list<room> list(kept, rooms[threadIdx.x / 32][0]), hits(yes, rooms[threadIdx.x / 32][1]);
  unsigned long long touched = 0;
  for (walk w(in, a.by == grouping::group ? group_size * group_size : 1); w.at < w.n; w.at += w.stride) {
    index_pair p[step_pairs] = {};
    unsigned keep = 0, hit = 0;
#pragma unroll
    for (int k = 0; k < step_pairs; ++k) {
      const unsigned long long i = w.index(k);
      const bool there = i < w.n && slots_of(in.pairs, i, a, b, p[k]);
      bool touch = there;
      if constexpr (Boxes)
        touch = there && boxes_touch<A, B>(a.rows + std::size_t{p[k].a} * P::inputs_a,
                                           b.rows + std::size_t{p[k].b} * P::inputs_b);
      keep |= touch << k;
    }
    touched += __popc(keep);
    if constexpr (rejects)
      if (standard_environment()) {
        MEETC_ROLLED
        for (unsigned left = keep; left; left &= left - 1) {
          const int k = __ffs(left) - 1;
          index_pair q;
          slots_of(in.pairs, w.index(k), a, b, q);
          const progress at =
              try_to_reject<P>(a.rows + std::size_t{q.a} * P::inputs_a, b.rows + std::size_t{q.b} * P::inputs_b);
          keep &= ~(static_cast<unsigned>(at != progress::open) << k);
          hit |= static_cast<unsigned>(at == progress::hit) << k;
        }
      }
    if constexpr (settles)
      hits.append(hit, p);
    list.append(keep, p);
  }
  hits.flush();
  list.flush();
  for (int d = 16; d > 0; d /= 2)
    touched += __shfl_xor_sync(~0U, touched, d);
  if (threadIdx.x % 32 == 0 && touched > 0)
    atomicAdd(touching, touched);
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

// What certify_fp32 leaves, a lane a pair. Pairs that a rung leaves unsure wait in shared memory until they fill the lanes.
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
cudaError_t decide_list(const operand &a, const operand &b, pair_list in, pair_list yes, pair_list unsure,
                        cudaStream_t stream) {
  return launch_step<decide_kernel<P, Of>>(stream, a.rows, b.rows, in, sink{nullptr, yes, unsure});
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

template <class P, class A, class B, unsigned Rungs>
cudaError_t near(step which, const operand &a, const operand &b, pair_list in, pair_list yes, pair_list kept,
                 unsigned long long *touching, cudaStream_t stream) {
  if (which == step::near_boxes)
    return launch_step<near_kernel<P, A, B, true, false>>(stream, a, b, in, yes, kept, touching);
  if constexpr (asks(Rungs, rung::certified)) {
    if (which == step::near_reject)
      return launch_step<near_kernel<P, A, B, true, true>>(stream, a, b, in, yes, kept, touching);
    if constexpr (P::reject_stage::atoms > 0)
      if (which == step::reject)
        return launch_step<near_kernel<P, A, B, false, true>>(stream, a, b, in, yes, kept, touching);
  }
  return cudaErrorInvalidValue;
}

template <class P, unsigned Rungs>
cudaError_t run(step which, const operand &a, const operand &b, pair_list in, pair_list yes, pair_list unsure,
                cudaStream_t stream) {
  constexpr bool certified = asks(Rungs, rung::certified);
  switch (which) {
  case step::near_boxes:
  case step::near_reject:
  case step::reject:
    break;
  case step::plain_fp32:
    if constexpr (asks(Rungs, rung::fp32))
      return decide_list<P, plain_step<P, float>>(a, b, in, yes, unsure, stream);
    break;
  case step::plain_fp64:
    if constexpr (asks(Rungs, rung::fp64))
      return decide_list<P, plain_step<P, double>>(a, b, in, yes, unsure, stream);
    break;
  case step::plain_fp64x2:
    if constexpr (asks(Rungs, rung::fp64x2))
      return decide_list<P, plain_step<P, double_double>>(a, b, in, yes, unsure, stream);
    break;
  case step::exact:
    if constexpr (asks(Rungs, rung::exact) || certified)
      return decide_list<P, exact_step<P>>(a, b, in, yes, unsure, stream);
    break;
  case step::tolerant:
    if constexpr (asks(Rungs, rung::tolerant) && keeps_tolerance<P>)
      return decide_list<P, tolerant_step<P>>(a, b, in, yes, unsure, stream);
    break;
  case step::certify_fp32:
    if constexpr (certified)
      return decide_list<P, certify_step<P, in_fp32>>(a, b, in, yes, unsure, stream);
    break;
  case step::certify_rest:
    if constexpr (certified)
      return launch_step<rest_kernel<P>>(stream, a.rows, b.rows, in, yes, unsure.count);
    break;
  }
  return cudaErrorInvalidValue;
}

} // namespace meetc::cuda

#endif
