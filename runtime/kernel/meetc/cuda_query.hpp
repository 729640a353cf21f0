// A whole all-pairs query in the caller's memory: placing both sets, the filter, and the rungs, enqueued in one call.
//
// No list can be grown here, since nothing is waited for: the result says whether one was too short. Elements keep the
// caller's order, so groups are of elements that follow each other there; meshes mostly list neighbours together, and
// where they do not the filter is right and slower. Included by nvcc alone.
#ifndef MEETC_CUDA_QUERY_HPP
#define MEETC_CUDA_QUERY_HPP

#include <meetc/cuda_steps.hpp>

#include <algorithm>

namespace meetc::cuda {

// ---- placing ----

__device__ inline float moved(const double *m, double x, double y, double z) {
  return __double2float_rn(
      __dadd_rn(__dadd_rn(__dadd_rn(__dmul_rn(m[0], x), __dmul_rn(m[1], y)), __dmul_rn(m[2], z)), m[3]));
}

template <class Shape>
__global__ void __launch_bounds__(set_threads)
    place_kernel(view v, placement at, const std::uint32_t *order, float *rows, unsigned long long *bad) {
  for (unsigned i = blockIdx.x * set_threads + threadIdx.x; i < v.elements; i += gridDim.x * set_threads) {
    float in[Shape::fields], out[Shape::fields];
    bool good = true;
    const auto *bytes = reinterpret_cast<const char *>(v.data);
    for (int f = 0; f < Shape::fields; ++f) {
      // Indexed kinds are points alone, x y z each.
      const std::size_t vertex =
          v.index ? v.index[i * (std::size_t{Shape::fields} / 3) + static_cast<unsigned>(f / 3)] : i;
      const bool there = !v.index || vertex < v.vertices;
      good &= there;
      if (there)
        memcpy(in + f, bytes + vertex * v.stride_bytes + sizeof(float) * static_cast<unsigned>(v.index ? f % 3 : f),
               sizeof(float));
      else
        in[f] = 0;
      out[f] = in[f];
    }
    for (int f = 0; f < Shape::fields && !at.identity; ++f) {
      if (Shape::role_of(f) == role::length) {
        out[f] = __double2float_rn(__dmul_rn(in[f], at.length_scale));
      } else if (Shape::role_of(f) == role::x) {
        const bool has_z = f + 2 < Shape::fields && Shape::role_of(f + 2) == role::z;
        const double x = in[f], y = in[f + 1], z = has_z ? in[f + 2] : 0.0F;
        out[f] = moved(at.m, x, y, z);
        out[f + 1] = moved(at.m + 4, x, y, z);
        if (has_z)
          out[f + 2] = moved(at.m + 8, x, y, z);
      }
    }
    for (int f = 0; f < Shape::fields; ++f) {
      good &= isfinite(out[f]);
      rows[i * std::size_t{Shape::fields} + f] = out[f];
    }
    if (Shape::pad >= 0)
      good &= out[Shape::pad < 0 ? 0 : Shape::pad] >= 0;
    if (!good)
      atomicMin(bad, static_cast<unsigned long long>(order ? order[i] : i) << 32 | i);
  }
}
template <class Shape>
cudaError_t place(const view &v, const placement &at, const std::uint32_t *order, float *rows, unsigned long long *bad,
                  cudaStream_t stream) {
  const cudaError_t e = cudaMemsetAsync(bad, 0xff, sizeof *bad, stream);
  if (e != cudaSuccess || v.elements == 0)
    return e;
  if (v.index && (Shape::fields % 3 != 0 || Shape::pad >= 0))
    return cudaErrorInvalidValue; // no kind of points alone
  const unsigned blocks = std::min(blocks_for(v.elements), 65536U);
  place_kernel<Shape><<<blocks, set_threads, 0, stream>>>(v, at, order, rows, bad);
  return cudaGetLastError();
}

// ---- the query ----

// Cuts the workspace into arrays; without memory, only adds up what is needed.
class cutter {
public:
  cutter(void *memory, std::size_t bytes) : at_(static_cast<char *>(memory)), bytes_(bytes) {}
  template <class T> T *take(std::size_t n) {
    const std::size_t begin = used_;
    used_ += (n * sizeof(T) + 255) / 256 * 256;
    return at_ ? reinterpret_cast<T *>(at_ + begin) : nullptr;
  }
  std::size_t used() const { return used_; }
  bool fits() const { return used_ <= bytes_; }

private:
  char *at_;
  std::size_t bytes_, used_ = 0;
};

struct query_memory {
  float *rows_a, *rows_b;
  void *columns_a, *columns_b;
  extent *around;
  index_pair *first, *second;
  unsigned long long *counts; // unsure in fp32, fp64, fp64x2 and exact (none); pairs with touching boxes

  template <class A, class B>
  static query_memory of(cutter &from, std::uint32_t a, std::uint32_t b, unsigned long long list) {
    const auto columns = [&](std::uint32_t n) {
      return from.take<char>(matrix_padded(operand{nullptr, n, grouping::group, nullptr}.objects()) * half_bytes);
    };
    query_memory m{};
    m.rows_a = from.take<float>(a * std::size_t{A::fields});
    m.rows_b = from.take<float>(b * std::size_t{B::fields});
    m.columns_a = columns(a), m.columns_b = columns(b);
    m.around = from.take<extent>(1);
    m.first = from.take<index_pair>(list), m.second = from.take<index_pair>(list);
    m.counts = from.take<unsigned long long>(5);
    return m;
  }
};

template <class A, class B>
std::size_t query_workspace(std::uint32_t a, std::uint32_t b, unsigned long long list_capacity) {
  cutter measure(nullptr, 0);
  query_memory::of<A, B>(measure, a, b, list_capacity);
  return measure.used();
}

template <class P, class A, class B, class Form, unsigned Rungs>
cudaError_t pairs(const query &q, cudaStream_t stream) {
  cutter from(q.workspace, q.bytes);
  const query_memory m = query_memory::of<A, B>(from, q.a.elements, q.b.elements, q.list_capacity);
  const ladder_steps steps = steps_of(q.precision);
  if (steps.count == 0 || !from.fits() || !q.workspace || reinterpret_cast<std::uintptr_t>(q.workspace) % 256 != 0 ||
      !q.result)
    return cudaErrorInvalidValue;
  cudaError_t e = cudaMemsetAsync(q.result, 0, sizeof *q.result, stream);
  const auto then = [&e](auto &&enqueue) { e = e == cudaSuccess ? enqueue() : e; };
  then([&] { return cudaMemsetAsync(m.counts, 0, 5 * sizeof *m.counts, stream); });
  then([&] { return place<A>(q.a, q.at_a, nullptr, m.rows_a, &q.result->bad_a, stream); });
  then([&] { return place<B>(q.b, q.at_b, nullptr, m.rows_b, &q.result->bad_b, stream); });
  if (q.a.elements == 0 || q.b.elements == 0)
    return e;
  // Bad elements can be anything: what follows is finished all the same, and means nothing then.
  const cover c = balls_for(q.precision);
  const bool frame_of_a = q.b.elements < q.a.elements;
  then([&] { return clear_extent(m.around, stream); });
  then([&] {
    return frame_of_a ? enclose<A>(m.rows_a, q.a.elements, m.around, stream)
                      : enclose<B>(m.rows_b, q.b.elements, m.around, stream);
  });
  then([&] {
    return columns<A, Form>(q.by, grouping::group, c, true, m.rows_a, q.a.elements, m.around, m.columns_a, stream);
  });
  then([&] {
    return columns<B, Form>(q.by, grouping::group, c, false, m.rows_b, q.b.elements, m.around, m.columns_b, stream);
  });
  const operand x{m.rows_a, q.a.elements, grouping::group, m.columns_a},
      y{m.rows_b, q.b.elements, grouping::group, m.columns_b};
  const pair_list near{m.first, &q.result->candidates, q.list_capacity},
      kept{m.second, &q.result->kept, q.list_capacity};
  const pair_list hits{q.pairs, &q.result->count, q.pairs ? q.capacity : 0};
  then([&] { return candidates<Form>(q.by, x, y, {0, x.objects(), 0, y.objects()}, near, stream); });
  const auto take = [&](step which, const pair_list &in, const pair_list &yes, const pair_list &unsure) {
    then([&] { return run<P, A, B, Rungs>(which, x, y, in, yes, unsure, stream); });
  };
  take(first_step(q.precision), near, kept, {nullptr, m.counts + 4, 0});
  pair_list in = kept;
  for (int s = 0; s < steps.count; ++s) {
    const pair_list unsure{s % 2 == 0 ? m.first : m.second, m.counts + s, q.list_capacity};
    take(steps.of[s], in, hits, unsure);
    in = unsure;
  }
  return e;
}

} // namespace meetc::cuda

#endif
