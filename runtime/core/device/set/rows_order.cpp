// How rows come into a spatial order: by one kernel for up to a million of them, which saves the dozen kernels of a sort, else
// by CUB's sort of their places, which is faster for more.
#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/device/set/order_kernels.hpp"
#include "meet/core/device/set/rows.hpp"
#include "meet/core/device/set/tree_kernels.hpp"
#include "meetc/cuda/cutter.hpp"
#include "meetc/volume/tree_order.hpp"

namespace meetc {
namespace {

// Bits of a cell along an axis, where the device orders elements: a sort by places takes a pass for every eight bits of all
// three, so that it has coarse cells first, and finer ones if too many elements share these.
constexpr int bits_of_cell = cuda::bits_to_arrange, coarse_bits_of_cell = 8;

// Elements that lie on surfaces share coarse cells sooner.
int first_bits(const cuda::view &v) {
  return v.index || v.only ? bits_of_cell : coarse_bits_of_cell;
}

// Whether elements stand as packed rows in their pose, so that a kernel need not write these.
bool are_packed_rows(const cuda::view &v, const pose &at, std::size_t row_bytes) {
  return at.identity() && at.grid == 0 && !v.index && !v.only && v.stride_bytes == row_bytes &&
         reinterpret_cast<std::uintptr_t>(v.data) % alignof(float) == 0;
}

} // namespace

bool can_arrange(std::uint32_t elements) {
  return elements > 0 && elements <= cuda::most_to_arrange;
}

double device_rows::make(const given_elements &elements, int threads) {
  double seconds = 0;
  resize(elements.there().elements, elements.at.grid);
  const bool ordered = order_there(elements, seconds);
  space_.release(), counted_.release();
  found_ = nullptr;
  if (!ordered)
    upload(elements.prepare_here(threads));
  take_room_for_tree();
  return ordered ? seconds : 0;
}

// Returns false where the set is for the host to order.
bool device_rows::order_there(const given_elements &elements, double &seconds) {
  const cudaStream_t stream = on_.stream();
  const device_buffers &buffers = on_.buffers();
  if (!take_room())
    return false; // a set that is ordered needs a third of it
  device_memory<cuda::order_findings> there;
  there.reserve(1, "what a set's order is");
  cuda::order_findings found{};
  const auto timed = [&](auto &&enqueue) {
    buffers.start_clock();
    if (!enqueue())
      return false;
    buffers.mark_clock();
    check(cudaMemcpyAsync(&found, there.data(), sizeof found, cudaMemcpyDeviceToHost, stream), "ordering a set");
    check(cudaStreamSynchronize(stream), "ordering a set");
    seconds += buffers.clocked();
    return true;
  };
  const std::optional<cuda::arrange_job> job =
      plan({elements.there(), elements.at, elements_, 1, there.data(), {}}, stream);
  bool ran = job && timed([&] {
               check(launchers_->arrange(&*job, 1, stream), "starting a kernel");
               return true;
             });
  // Elements that arrange() has found crowded are so for a sort by the same cells.
  bool sorts = !ran || found.unordered > 0;
  for (int bits = first_bits(elements.there()); sorts && bits <= bits_of_cell;
       bits += bits_of_cell - coarse_bits_of_cell) {
    ran = timed([&] { return sort(elements.there(), elements.at, bits, there.data(), stream); });
    sorts = ran && found.crowded > elements_ / 8;
  }
  if (ran && found.bad != ~0ULL)
    elements.refuse();
  return ran && is_order(found, elements_);
}

// Returns false where there is too little memory, as sort() does.
bool device_rows::take_room() {
  const cudaStream_t stream = on_.stream();
  return data_.grow(elements_ * static_cast<std::size_t>(kind_->fields), 0, stream) &&
         order_.grow(elements_, 0, stream);
}

std::optional<cuda::arrange_job> device_rows::plan_order(const order_request &r, cudaStream_t stream) {
  resize(r.elements.elements, r.at.grid);
  numbers_ = r.numbers, found_ = elements_ > 0 ? r.found : nullptr;
  const bool room = elements_ > 0 && take_room();
  if (std::optional<cuda::arrange_job> job = room ? plan(r, stream) : std::nullopt)
    return job;
  if (!r.cleared.empty())
    check(cudaMemsetAsync(r.cleared.data(), 0, r.cleared.size_bytes(), stream), "clearing counters");
  if (elements_ > 0 && (!room || !sort(r.elements, r.at, first_bits(r.elements), r.found, stream)))
    throw device_memory_error(
        "not enough device memory to put a set into order; the CPU decides the same pairs (--device cpu)");
  return {};
}

// The job of one kernel, where there is one for so many elements, and memory for it. Once it has run the set is in order.
std::optional<cuda::arrange_job> device_rows::plan(const order_request &r, cudaStream_t stream) {
  const std::uint32_t n = elements_;
  tree_of_ = 0;
  if (!can_arrange(n))
    return {};
  cuda::arrange_job job{};
  job.from = r.elements, job.at = cuda_pose(r.at), job.share = r.share;
  job.found = r.found, job.cleared = r.cleared.data(), job.clears = r.cleared.size();
  job.rows = data_.data(), job.order = order_.data();
  const auto fields = static_cast<std::size_t>(kind_->fields);
  const bool packed = are_packed_rows(r.elements, r.at, fields * sizeof(float));
  job.common = r.common;
  for (const bool planned : {true, false}) {
    cuda::cutter from(space_.data(), space_.capacity());
    job.posed = packed ? nullptr : from.take<float>(n * fields);
    job.boxes = packed || job.common ? nullptr : from.take<cuda::tree_box>(cuda::most_blocks_to_arrange);
    job.keys.keys = from.take<std::uint64_t>(n), job.keys.by_cell = from.take<std::uint64_t>(n);
    if (planned && !space_.grow(from.used(), 0, on_.stream()))
      return {};
  }
  if (counted_.capacity() == 0) {
    if (!counted_.grow(cuda::counted_to_distribute, 0, on_.stream()))
      return {};
    check(cudaMemsetAsync(counted_.data(), 0, cuda::counted_to_distribute * sizeof(std::uint32_t), stream),
          "ordering a set");
  }
  job.keys.n = n, job.keys.counted = counted_.data();
  take_room_for_tree();
  if (cuda::can_arrange_tree(kind_->fields))
    job.nodes = tree_.room(n);
  job.arrived = job.nodes ? tree_.arrived(stream) : nullptr;
  if (job.nodes)
    tree_of_ = version_;
  return job;
}

// By a sort of all places.
bool device_rows::sort(const cuda::view &there, const pose &at, int bits, cuda::order_findings *found,
                       cudaStream_t stream) {
  const std::uint32_t n = elements_;
  tree_of_ = 0;
  const auto fields = static_cast<std::size_t>(kind_->fields);
  const bool packed = are_packed_rows(there, at, fields * sizeof(float));
  std::size_t need = 0;
  check(sort_places(nullptr, need, nullptr, nullptr, nullptr, nullptr, n, 3 * bits, stream), "planning to order");
  float *posed = nullptr;
  std::uint32_t *places = nullptr, *sorted = nullptr, *numbers = nullptr;
  cuda::joined_box *around = nullptr;
  void *sorting = nullptr;
  for (const bool planned : {true, false}) {
    cuda::cutter from(space_.data(), space_.capacity());
    posed = packed ? nullptr : from.take<float>(n * fields);
    places = from.take<std::uint32_t>(n), sorted = from.take<std::uint32_t>(n), numbers = from.take<std::uint32_t>(n);
    around = from.take<cuda::joined_box>(1);
    sorting = from.take<std::byte>(need);
    if (planned && !space_.grow(from.used(), 0, on_.stream()))
      return false;
  }
  take_room_for_tree();
  check(cudaMemsetAsync(found, 0, sizeof *found, stream), "ordering a set");
  check(cudaMemsetAsync(around, 0, sizeof *around, stream), "ordering a set");
  if (packed) { // the places are by a box around some, and their kernel checks all
    const cuda::sample taken(n);
    cuda::view some = there;
    some.data += taken.first * fields, some.elements = taken.of(n), some.stride_bytes *= taken.step;
    check(cudaMemsetAsync(&found->bad, 0xff, sizeof found->bad, stream), "ordering a set");
    check(launchers_->pose(some, cuda_pose(at), nullptr, nullptr, nullptr, around, stream), "starting a kernel");
  } else {
    check(launchers_->pose(there, cuda_pose(at), nullptr, posed, &found->bad, around, stream), "starting a kernel");
  }
  const float *const rows = packed ? there.data : posed;
  check(launchers_->places(rows, n, around, bits, places, numbers, packed ? &found->bad : nullptr, stream),
        "starting a kernel");
  check(sort_places(sorting, need, places, sorted, numbers, order_.data(), n, 3 * bits, stream), "ordering a set");
  cuda::tree_node *const nodes = tree_.room(n);
  check(launchers_->gather({rows, n, sorted, order_.data(), there.only, data_.data(), nodes, &found->crowded}, stream),
        "starting a kernel");
  if (nodes) {
    check(enclose_levels(nodes, n, 2, stream), "starting a kernel");
    tree_of_ = version_;
  }
  return true;
}

} // namespace meetc
