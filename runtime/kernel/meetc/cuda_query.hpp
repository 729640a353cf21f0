// A whole all-pairs query in the caller's memory: it poses both sets, filters, and runs the rungs, all enqueued in one
// call.
//
// No list can grow here, because nothing waits for the device; the result says whether one was too short. Elements keep
// the caller's order, so a group holds elements that follow each other in it. Meshes mostly list neighbours together.
// If they do not, the filter is slower, but as correct.
#ifndef MEETC_CUDA_QUERY_HPP
#define MEETC_CUDA_QUERY_HPP

#include <meetc/cuda_table.hpp>

namespace meetc::cuda {

// Cuts the workspace into arrays. Without memory it only adds up what is needed.
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
  unsigned long long *counts; // unsure in fp32, fp64 and double-double; pairs whose boxes touch

  static query_memory of(cutter &from, const catalogue &all, const predicate_launchers &p, std::uint32_t a,
                         std::uint32_t b, unsigned long long list) {
    const auto columns = [&](std::uint32_t n) {
      return from.take<char>(matrix_padded(operand{nullptr, n, grouping::group, nullptr}.objects()) * half_bytes);
    };
    query_memory m{};
    m.rows_a = from.take<float>(a * static_cast<std::size_t>(all.kinds[p.kind_a].fields));
    m.rows_b = from.take<float>(b * static_cast<std::size_t>(all.kinds[p.kind_b].fields));
    m.columns_a = columns(a), m.columns_b = columns(b);
    m.around = from.take<extent>(1);
    m.first = from.take<index_pair>(list), m.second = from.take<index_pair>(list);
    m.counts = from.take<unsigned long long>(4);
    return m;
  }
};

inline std::size_t query_workspace(const catalogue &all, const predicate_launchers &p, std::uint32_t a, std::uint32_t b,
                                   unsigned long long list_capacity) {
  cutter measure(nullptr, 0);
  query_memory::of(measure, all, p, a, b, list_capacity);
  return measure.used();
}

inline cudaError_t pairs(const catalogue &all, const predicate_launchers &p, const query &q, cudaStream_t stream) {
  const kind_launchers &a = all.kinds[p.kind_a], &b = all.kinds[p.kind_b];
  cutter from(q.workspace, q.bytes);
  const query_memory m = query_memory::of(from, all, p, q.a.elements, q.b.elements, q.list_capacity);
  const cascade_steps steps = steps_of(q.precision);
  if (steps.count == 0 || q.precision == rung::tolerant || !from.fits() || !q.workspace ||
      reinterpret_cast<std::uintptr_t>(q.workspace) % 256 != 0 || !q.result)
    return cudaErrorInvalidValue;
  cudaError_t e = cudaMemsetAsync(q.result, 0, sizeof *q.result, stream);
  const auto then = [&e](auto &&enqueue) { e = e == cudaSuccess ? enqueue() : e; };
  then([&] { return cudaMemsetAsync(m.counts, 0, 4 * sizeof *m.counts, stream); });
  then([&] { return a.pose(q.a, q.at_a, nullptr, m.rows_a, &q.result->bad_a, nullptr, stream); });
  then([&] { return b.pose(q.b, q.at_b, nullptr, m.rows_b, &q.result->bad_b, nullptr, stream); });
  if (q.a.elements == 0 || q.b.elements == 0)
    return e;
  // The steps below run even if elements are bad; their results then mean nothing.
  const cover c = balls_for(q.precision);
  const bool frame_of_a = q.b.elements < q.a.elements;
  then([&] { return all.clear_extent(m.around, stream); });
  then([&] {
    return frame_of_a ? a.enclose(m.rows_a, q.a.elements, m.around, stream)
                      : b.enclose(m.rows_b, q.b.elements, m.around, stream);
  });
  then(
      [&] { return a.columns(q.by, grouping::group, c, true, m.rows_a, q.a.elements, m.around, m.columns_a, stream); });
  then([&] {
    return b.columns(q.by, grouping::group, c, false, m.rows_b, q.b.elements, m.around, m.columns_b, stream);
  });
  const operand x{m.rows_a, q.a.elements, grouping::group, m.columns_a},
      y{m.rows_b, q.b.elements, grouping::group, m.columns_b};
  const pair_list near{m.first, &q.result->candidates, q.list_capacity},
      kept{m.second, &q.result->kept, q.list_capacity};
  const pair_list hits{q.pairs, &q.result->count, q.pairs ? q.capacity : 0};
  then([&] { return all.candidates(q.by, x, y, {0, x.objects(), 0, y.objects()}, near, stream); });
  then([&] { return p.near(first_step(q.precision), x, y, near, hits, kept, m.counts + 3, stream); });
  pair_list in = kept;
  for (int s = 0; s < steps.count; ++s) {
    const pair_list unsure{m.first, m.counts + s, q.list_capacity}; // the last step writes none
    then([&] { return p.run(steps.of[s], x, y, in, hits, unsure, stream); });
    in = unsure;
  }
  return e;
}

} // namespace meetc::cuda

#endif
