// Every pair of two sets, in the caller's memory: both sets are posed, filtered and decided, all enqueued in one call.
//
// No list can grow here, because nothing waits for the device; the result says whether one was too short. Elements keep the
// caller's order.
#ifndef MEETC_EVERY_PAIR_QUERY_HPP
#define MEETC_EVERY_PAIR_QUERY_HPP

#include <meetc/cuda/cascade.hpp>
#include <meetc/cuda/cutter.hpp>
#include <meetc/every_pair/table.hpp>

namespace meetc::every_pair {

// A part of the product, from columns to hits. Two lists alternate.
struct part_steps {
  filter by;
  rung precision;
  operand x, y;
  const float *rows_a, *rows_b;
  boxes_of_two boxes;
  cuda::pair_list near;       // what the filter passes; the list has what the reject stage keeps afterwards, and
  unsigned long long *kept;   // this is its counter then
  cuda::pair_list touching;   // those whose boxes touch
  unsigned long long *unsure; // as in cuda::cascade_lists
};
inline cudaError_t decide_part(const catalogue &all, const cuda::predicate_launchers &p, const part_steps &s,
                               const cuda::part &of, const cuda::pair_list &hits, cudaStream_t stream) {
  cudaError_t e = all.candidates(s.by, s.x, s.y, of, s.near, stream);
  if (e == cudaSuccess)
    e = all.touching(s.boxes, s.near, s.touching, stream);
  if (e != cudaSuccess)
    return e;
  const cuda::pair_list kept{s.near.pairs, s.kept, s.near.capacity};
  return cuda::decide(p, s.precision, s.rows_a, s.rows_b, {s.touching, kept, s.unsure}, hits, stream);
}

struct query_memory {
  float *rows_a, *rows_b;
  void *columns_a, *columns_b;
  cuda::tree_node *boxes_a, *boxes_b;
  extent *around;
  index_pair *first, *second;
  unsigned long long *unsure;
  unsigned *arrived;

  static query_memory of(cuda::cutter &from, const cuda::set_launchers &of_a, const cuda::set_launchers &of_b,
                         std::uint32_t a, std::uint32_t b, unsigned long long list) {
    query_memory m{};
    m.rows_a = from.take<float>(a * static_cast<std::size_t>(of_a.fields));
    m.rows_b = from.take<float>(b * static_cast<std::size_t>(of_b.fields));
    m.columns_a = from.take<char>(column_bytes(filter::mma, a));
    m.columns_b = from.take<char>(column_bytes(filter::mma, b));
    m.boxes_a = from.take<cuda::tree_node>(cuda::tree_shape(a).nodes());
    m.boxes_b = from.take<cuda::tree_node>(cuda::tree_shape(b).nodes());
    m.around = from.take<extent>(1);
    m.first = from.take<index_pair>(list), m.second = from.take<index_pair>(list);
    m.unsure = from.take<unsigned long long>(bounded_rungs);
    m.arrived = from.take<unsigned>(1);
    return m;
  }
};
static_assert(float_bytes <= half_bytes); // so that there is room for the columns of any filter

// The bytes that a query on so many elements needs.
inline std::size_t query_workspace(const cuda::catalogue &kinds, const cuda::predicate_launchers &p, std::uint32_t a,
                                   std::uint32_t b, unsigned long long list_capacity) {
  cuda::cutter measure(nullptr, 0);
  query_memory::of(measure, kinds.kinds[p.kind_a], kinds.kinds[p.kind_b], a, b, list_capacity);
  return measure.used();
}

// `p` is a predicate of `kinds`, whose namespace `all` is of too. Returns cudaErrorInvalidValue where the query cannot be.
inline cudaError_t pairs(const cuda::catalogue &kinds, const catalogue &all, const cuda::predicate_launchers &p,
                         const query &q, cudaStream_t stream) {
  const cuda::set_launchers &a = kinds.kinds[p.kind_a], &b = kinds.kinds[p.kind_b];
  const set_launchers &columns_a = all.kinds[p.kind_a], &columns_b = all.kinds[p.kind_b];
  cuda::cutter from(q.workspace, q.bytes);
  const query_memory m = query_memory::of(from, a, b, q.a.elements, q.b.elements, q.list_capacity);
  if (cuda::steps_of(q.precision).count == 0 || q.precision == rung::tolerant || !from.fits() || !q.workspace ||
      reinterpret_cast<std::uintptr_t>(q.workspace) % 256 != 0 || !q.result)
    return cudaErrorInvalidValue;
  cudaError_t e = cudaMemsetAsync(q.result, 0, sizeof *q.result, stream);
  const auto then = [&e](auto &&enqueue) { e = e == cudaSuccess ? enqueue() : e; };
  then([&] { return cudaMemsetAsync(m.unsure, 0, bounded_rungs * sizeof *m.unsure, stream); });
  then([&] { return cudaMemsetAsync(m.arrived, 0, sizeof *m.arrived, stream); });
  then([&] { return a.pose(q.a, q.at_a, nullptr, m.rows_a, &q.result->bad_a, nullptr, stream); });
  then([&] { return b.pose(q.b, q.at_b, nullptr, m.rows_b, &q.result->bad_b, nullptr, stream); });
  if (q.a.elements == 0 || q.b.elements == 0)
    return e;
  // The steps below run even if elements are bad; their results then mean nothing.
  then([&] { return a.boxes(m.rows_a, q.a.elements, m.boxes_a, m.arrived, stream); });
  then([&] { return b.boxes(m.rows_b, q.b.elements, m.boxes_b, m.arrived, stream); });
  const cover c = balls_for(q.precision);
  then([&] {
    return q.b.elements < q.a.elements ? columns_a.enclose(m.rows_a, q.a.elements, m.around, stream)
                                       : columns_b.enclose(m.rows_b, q.b.elements, m.around, stream);
  });
  then([&] { return columns_a.columns(q.by, c, true, m.rows_a, q.a.elements, m.around, m.columns_a, stream); });
  then([&] { return columns_b.columns(q.by, c, false, m.rows_b, q.b.elements, m.around, m.columns_b, stream); });
  const part_steps steps{q.by,
                         q.precision,
                         {q.a.elements, m.columns_a},
                         {q.b.elements, m.columns_b},
                         m.rows_a,
                         m.rows_b,
                         {m.boxes_a, m.boxes_b},
                         {m.first, &q.result->near, q.list_capacity},
                         &q.result->kept,
                         {m.second, &q.result->candidates, q.list_capacity},
                         m.unsure};
  const cuda::pair_list hits{q.pairs, &q.result->count, q.pairs ? q.capacity : 0};
  then([&] { return decide_part(all, p, steps, {0, q.a.elements, 0, q.b.elements}, hits, stream); });
  return e;
}

} // namespace meetc::every_pair

#endif
