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

#include <algorithm>

namespace meetc::cuda {

inline constexpr int step_threads = 128, step_warps = step_threads / 32;
inline constexpr int step_blocks = 1056; // 8 for each of 132 multiprocessors

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

// A step that reads stored values has of(stored_pair); any other step has of(row_a, row_b).
template <class Of> inline constexpr bool of_stored = requires(const stored_pair &p) {
  Of::of(p);
};

// in.count may be null: there are then in.capacity pairs.
template <class P, class Of>
__global__ void __launch_bounds__(step_threads) decide_kernel(row_array a, row_array b, pair_list in, sink to) {
  begin();
  __shared__ index_pair rooms[step_warps][waiting_pairs];
  waiting_list hits(to.yes, rooms[threadIdx.x / 32]);
  // A warp stays whole, since a lane without pairs takes part as well.
  for (walk w(in); w.at < w.n; w.at += w.stride) {
    index_pair p[step_pairs] = {};
    unsigned yes = 0, unsure = 0;
    MEETC_ROLLED
    for (int k = 0; k < step_pairs; ++k) {
      const unsigned long long i = w.index(k);
      if (i >= w.n)
        break;
      const index_pair q = in.pairs[i];
      const float *const row_a = a.rows + std::size_t{q.a} * P::inputs_a, *const row_b =
                                                                              b.rows + std::size_t{q.b} * P::inputs_b;
      answer x;
      if constexpr (of_stored<Of>)
        x = Of::of(stored_pair{row_a, row_b, a.stored + std::size_t{q.a} * stored_layout<P>::floats_a,
                               b.stored + std::size_t{q.b} * stored_layout<P>::floats_b});
      else
        x = Of::of(row_a, row_b);
      yes |= (x == answer::yes) << k;
      unsure |= (x == answer::unsure) << k;
      if (to.answers)
        to.answers[i] = x;
    }
    if (to.answers)
      continue;
#pragma unroll
    for (int k = 0; k < step_pairs; ++k)
      if ((yes | unsure) >> k & 1)
        p[k] = in.pairs[w.index(k)];
    hits.append(yes, p);
    append(unsure, p, to.unsure);
  }
  hits.flush();
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

template <class P, class A, class B, bool Reject>
__global__ void __launch_bounds__(step_threads)
    near_kernel(operand a, operand b, pair_list in, pair_list kept, unsigned long long *touching) {
  begin();
  __shared__ index_pair rooms[step_warps][waiting_pairs];
  waiting_list list(kept, rooms[threadIdx.x / 32]);
  unsigned long long touched = 0;
  for (walk w(in, a.by == grouping::group ? group_size * group_size : 1); w.at < w.n; w.at += w.stride) {
    index_pair p[step_pairs] = {};
    unsigned keep = 0;
#pragma unroll
    for (int k = 0; k < step_pairs; ++k) {
      const unsigned long long i = w.index(k);
      const bool there = i < w.n && slots_of(in.pairs, i, a, b, p[k]);
      const bool touch = there && boxes_touch<A, B>(a.rows + std::size_t{p[k].a} * P::inputs_a,
                                                    b.rows + std::size_t{p[k].b} * P::inputs_b);
      keep |= touch << k;
    }
    touched += __popc(keep);
    if constexpr (Reject && P::reject_stage::atoms > 0)
      if (standard_environment()) {
        MEETC_ROLLED
        for (unsigned left = keep; left; left &= left - 1) {
          const int k = __ffs(left) - 1;
          index_pair q;
          slots_of(in.pairs, w.index(k), a, b, q);
          const bool rejected =
              surely_rejected<P>({a.rows + std::size_t{q.a} * P::inputs_a, b.rows + std::size_t{q.b} * P::inputs_b,
                                  a.stored + std::size_t{q.a} * stored_layout<P>::floats_a,
                                  b.stored + std::size_t{q.b} * stored_layout<P>::floats_b});
          keep &= ~(static_cast<unsigned>(rejected) << k);
        }
      }
    list.append(keep, p);
  }
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

// The rungs in fp32 if both operands store the values that P reads.
template <class P> struct stored_plain_step {
  __device__ static answer of(const stored_pair &p) { return to_answer(decide<P>(stored_plain_signs<P>{p})); }
};
template <class P> struct stored_certify_step {
  __device__ static answer of(const stored_pair &p) {
    return standard_environment() ? decide_sets<P>(stored_bounded_signs<P>{p}) : answer::unsure;
  }
};

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
  return launch<decide_kernel<P, Of>>(blocks, step_threads, stream, row_array{a}, row_array{b}, in, sink{out, {}, {}});
}
template <class P, class Of>
cudaError_t decide_list(const operand &a, const operand &b, pair_list in, pair_list yes, pair_list unsure,
                        cudaStream_t stream) {
  return launch<decide_kernel<P, Of>>(step_blocks, step_threads, stream, row_array{a.rows, a.stored},
                                      row_array{b.rows, b.stored}, in, sink{nullptr, yes, unsure});
}

// The step in fp32 for sets; it reads stored values if P has any.
template <class P, class Stored, class Plain>
using fp32_step = std::conditional_t<(stored_layout<P>::floats_a + stored_layout<P>::floats_b > 0), Stored, Plain>;
// Whether the operands have the stored values that P reads.
template <class P> bool have_stored(const operand &a, const operand &b) {
  return (stored_layout<P>::floats_a == 0 || a.stored) && (stored_layout<P>::floats_b == 0 || b.stored);
}

template <class Store>
__global__ void __launch_bounds__(step_threads) store_kernel(const float *rows, unsigned n, float *out) {
  begin();
  for (unsigned i = blockIdx.x * step_threads + threadIdx.x; i < n; i += gridDim.x * step_threads)
    Store::compute(rows + i * std::size_t{Store::inputs}, out + i * std::size_t{Store::floats});
}
template <class Store> cudaError_t store(const float *rows, std::uint32_t n, float *out, cudaStream_t stream) {
  if (n == 0)
    return cudaSuccess;
  const unsigned blocks = std::min((n - 1) / step_threads + 1, 65536U);
  return launch<store_kernel<Store>>(blocks, step_threads, stream, rows, n, out);
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
template <class Store, unsigned Rungs> stored_launcher stored_by(int number) {
  if constexpr (Store::floats > 0 && (asks(Rungs, rung::fp32) || asks(Rungs, rung::certified)))
    return {number, Store::floats, store<Store>};
  return {};
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
cudaError_t near(step which, const operand &a, const operand &b, pair_list in, pair_list kept,
                 unsigned long long *touching, cudaStream_t stream) {
  if (which == step::near_boxes)
    return launch<near_kernel<P, A, B, false>>(step_blocks, step_threads, stream, a, b, in, kept, touching);
  if constexpr (asks(Rungs, rung::certified))
    if (which == step::near_reject && have_stored<P>(a, b))
      return launch<near_kernel<P, A, B, true>>(step_blocks, step_threads, stream, a, b, in, kept, touching);
  return cudaErrorInvalidValue;
}

template <class P, unsigned Rungs>
cudaError_t run(step which, const operand &a, const operand &b, pair_list in, pair_list yes, pair_list unsure,
                cudaStream_t stream) {
  constexpr bool certified = asks(Rungs, rung::certified);
  switch (which) {
  case step::near_boxes:
  case step::near_reject:
    break;
  case step::plain_fp32:
    if constexpr (asks(Rungs, rung::fp32))
      if (have_stored<P>(a, b))
        return decide_list<P, fp32_step<P, stored_plain_step<P>, plain_step<P, float>>>(a, b, in, yes, unsure, stream);
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
      if (have_stored<P>(a, b))
        return decide_list<P, fp32_step<P, stored_certify_step<P>, certify_step<P, in_fp32>>>(a, b, in, yes, unsure,
                                                                                              stream);
    break;
  case step::certify_fp64:
    if constexpr (certified)
      return decide_list<P, certify_step<P, in_fp64>>(a, b, in, yes, unsure, stream);
    break;
  case step::certify_fp64x2:
    if constexpr (certified)
      return decide_list<P, certify_step<P, in_fp64x2>>(a, b, in, yes, unsure, stream);
    break;
  }
  return cudaErrorInvalidValue;
}

} // namespace meetc::cuda

#endif
