#include "meet/core/device/set.hpp"

#include "meet/core/device/buffers.hpp"
#include "meet/core/device/given.hpp"
#include "meet/core/device/kernels.hpp"
#include "meet/core/device/order_kernels.hpp"
#include "meet/core/device/tree_kernels.hpp"
#include "meet/core/hierarchy/two_points.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meetc/cuda/cutter.hpp"
#include "meetc/volume/tree_order.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace meetc {
namespace {

std::uint64_t next_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

// Of a cell along an axis, where the device orders elements: a sort by places takes a pass for every eight bits of all three,
// so that it has coarse cells first, and finer ones if too many elements share these.
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

void require_movable(const kind_info &kind, const pose &at) {
  require_pose(kind, at);
  if (!under_standard_word([&] { return at.length_scale >= 0; }))
    throw std::invalid_argument("a pose's length scale is negative or not a number");
}

device_set::device_set(device &on, const kind_info &kind, std::size_t elements, double grid)
    : on_(&on), kind_(&kind), launchers_(&launchers_of(on.kernels(), kind)),
      elements_(static_cast<std::uint32_t>(elements)), numbers_(elements_), grid_(grid), id_(next_version()) {
  if (elements > 0xffffffff)
    throw std::length_error(text(status::too_many_elements));
}

device_set::device_set(device &on, const prepared &set) : device_set(on, set.kind(), set.elements(), set.set().grid) {
  const control_word_guard guard;
  if (!set.whole())
    throw std::invalid_argument("a set on a device must not be prepared for collisions with one other set");
  upload(set);
  take_room_for_tree();
}

device_set::device_set(device &on, const kind_info &kind) : device_set(on, kind, 0, 0) {}

// Most queries want the hierarchy, and to wait for memory takes longer than to make that of a small set.
void device_set::take_room_for_tree() {
  if (elements_ > 0)
    tree_.take_room(elements_, on_->stream());
}

device_set::device_set(device &on, const view &elements, const kind_info &kind, const pose &at, int threads)
    : device_set(on, kind, elements.elements, at.grid) {
  const control_word_guard guard;
  require_pose(kind, at);
  const std::unique_ptr<given_set> given = given_set::if_it_fits(on, elements, kind, at);
  if (!given || !make(*given))
    upload(prepare(elements, kind, at, threads));
  take_room_for_tree();
}

device_set::device_set(device &on, const given_set &elements, int threads)
    : device_set(on, elements.kind(), elements.elements(), elements.at().grid) {
  const control_word_guard guard;
  if (!make(elements)) {
    const given_set::copy here = elements.download();
    upload(prepare(here.elements, elements.kind(), elements.at(), threads));
  }
  take_room_for_tree();
}

void device_set::upload(const prepared &set) {
  ordered_seconds_ = 0;
  const std::size_t floats = std::size_t{elements_} * static_cast<std::size_t>(kind_->fields);
  rows_.reserve(floats, "a set's elements");
  order_.reserve(elements_, "a set's order");
  transfers &moving = on_->buffers().moving;
  moving.upload(rows_.data(), set.set().rows, floats * sizeof(float), on_->stream(), "uploading a set");
  moving.upload(order_.data(), set.set().order, elements_ * sizeof(std::uint32_t), on_->stream(), "uploading a set");
  reaches_ = {set.set().reach, set.set().longest};
  version_ = next_version();
  check(cudaStreamSynchronize(on_->stream()), "uploading a set"); // the caller may now change the memory
}

// Returns false where the set is for the host to order.
bool device_set::make(const given_set &elements) {
  const cudaStream_t stream = on_->stream();
  device_buffers &buffers = on_->buffers();
  if (!take_room())
    return false; // a set that is ordered needs a third of it
  device_memory<cuda::order_findings> there;
  there.reserve(1, "what a set's order is");
  cuda::order_findings found{};
  const auto timed = [&](auto &&enqueue) {
    check(cudaEventRecord(buffers.events[0], stream), "starting a clock");
    if (!enqueue())
      return false;
    check(cudaEventRecord(buffers.events[1], stream), "stopping a clock");
    check(cudaMemcpyAsync(&found, there.data(), sizeof found, cudaMemcpyDeviceToHost, stream), "ordering a set");
    check(cudaStreamSynchronize(stream), "ordering a set");
    ordered_seconds_ += buffers.between();
    return true;
  };
  const std::optional<cuda::arrange_job> job =
      plan({elements.there(), elements.at(), elements_, 1, there.data(), {}}, stream);
  bool ran = job && timed([&] {
               check(launchers_->arrange(&*job, 1, stream), "starting a kernel");
               return true;
             });
  // What arrange() has found crowded is so for a sort by the same cells.
  bool sorts = !ran || found.unordered > 0;
  for (int bits = first_bits(elements.there()); sorts && bits <= bits_of_cell;
       bits += bits_of_cell - coarse_bits_of_cell) {
    ran = timed([&] { return sort(elements.there(), elements.at(), bits, there.data(), stream); });
    sorts = ran && found.crowded > elements_ / 8;
  }
  space_.release(), counted_.release();
  if (ran && found.bad != ~0ULL)
    elements.refuse();
  return ran && is_order(found, elements_);
}

// Returns false where there is too little memory, as sort() does.
bool device_set::take_room() {
  const cudaStream_t stream = on_->stream();
  return rows_.grow(elements_ * static_cast<std::size_t>(kind_->fields), 0, stream) &&
         order_.grow(elements_, 0, stream);
}

void device_set::order(const order_request &r, cudaStream_t stream) {
  if (const std::optional<cuda::arrange_job> job = plan_order(r, stream))
    check(launchers_->arrange(&*job, 1, stream), "starting a kernel");
}

std::optional<cuda::arrange_job> device_set::plan_order(const order_request &r, cudaStream_t stream) {
  elements_ = r.elements.elements, numbers_ = r.numbers;
  grid_ = r.at.grid, moved_ = false, reaches_.reset(), found_ = elements_ > 0 ? r.found : nullptr;
  id_ = version_ = next_version();
  const bool room = elements_ > 0 && take_room();
  if (std::optional<cuda::arrange_job> job = room ? plan(r, stream) : std::nullopt)
    return job;
  if (!r.cleared.empty())
    check(cudaMemsetAsync(r.cleared.data(), 0, r.cleared.size_bytes(), stream), "clearing counters");
  if (elements_ > 0 && (!room || !sort(r.elements, r.at, first_bits(r.elements), r.found, stream)))
    throw device_error(
        "not enough device memory to put a set into order; the CPU decides the same pairs (--device cpu)");
  return {};
}

// The job of one kernel, where there is one for so many elements, and memory for it. Once it has run the set is in order.
std::optional<cuda::arrange_job> device_set::plan(const order_request &r, cudaStream_t stream) {
  const std::uint32_t n = elements_;
  if (!can_arrange(n))
    return {};
  cuda::arrange_job job{};
  job.from = r.elements, job.at = cuda_pose(r.at), job.share = r.share;
  job.found = r.found, job.cleared = r.cleared.data(), job.clears = r.cleared.size();
  job.rows = rows_.data(), job.order = order_.data();
  const auto fields = static_cast<std::size_t>(kind_->fields);
  const bool packed = are_packed_rows(r.elements, r.at, fields * sizeof(float));
  job.common = r.common;
  for (const bool planned : {true, false}) {
    cuda::cutter from(space_.data(), space_.capacity());
    job.posed = packed ? nullptr : from.take<float>(n * fields);
    job.boxes = packed || job.common ? nullptr : from.take<cuda::tree_box>(cuda::most_blocks_to_arrange);
    job.keys.keys = from.take<std::uint64_t>(n), job.keys.by_cell = from.take<std::uint64_t>(n);
    if (planned && !space_.grow(from.used(), 0, on_->stream()))
      return {};
  }
  if (counted_.capacity() == 0) {
    if (!counted_.grow(cuda::counted_to_distribute, 0, on_->stream()))
      return {};
    check(cudaMemsetAsync(counted_.data(), 0, cuda::counted_to_distribute * sizeof(std::uint32_t), stream),
          "ordering a set");
  }
  job.keys.n = n, job.keys.counted = counted_.data();
  version_ = next_version();
  take_room_for_tree();
  if (cuda::can_arrange_tree(kind_->fields))
    job.nodes = tree_.room(n);
  job.arrived = job.nodes ? tree_.arrived(stream) : nullptr;
  if (job.nodes)
    tree_of_ = version_;
  return job;
}

// By a sort of all places.
bool device_set::sort(const cuda::view &there, const pose &at, int bits, cuda::order_findings *found,
                      cudaStream_t stream) {
  const std::uint32_t n = elements_;
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
    if (planned && !space_.grow(from.used(), 0, on_->stream()))
      return false;
  }
  version_ = next_version();
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
  check(launchers_->gather({rows, n, sorted, order_.data(), there.only, rows_.data(), nodes, &found->crowded}, stream),
        "starting a kernel");
  if (nodes) {
    check(enclose_levels(nodes, n, 2, stream), "starting a kernel");
    tree_of_ = version_;
  }
  return true;
}

device_set::device_set(const device_set &of, std::uint32_t n)
    : device_set(*of.on_, *of.kind_, (std::size_t{of.elements_} + (n - 1)) / n, of.grid_) {
  const control_word_guard guard;
  const auto strided = [&](auto &to, const auto &from, std::size_t each) {
    const std::size_t bytes = each * sizeof *to.data();
    to.reserve(elements_ * each, "a part of a set");
    check(cudaMemcpy2DAsync(to.data(), bytes, from.data(), n * bytes, bytes, elements_, cudaMemcpyDeviceToDevice,
                            on_->stream()),
          "taking a part of a set");
  };
  strided(rows_, of.rows_, static_cast<std::size_t>(kind_->fields));
  strided(order_, of.order_, 1);
  version_ = next_version();
}

device_set::device_set(const device_set &of, std::span<const pose> poses, std::span<const std::size_t> numbers)
    : device_set(*of.on_, *of.kind_, of.elements_ * poses.size(), 0) {
  const control_word_guard guard;
  const auto fields = static_cast<std::size_t>(kind_->fields);
  const cudaStream_t stream = on_->stream();
  std::vector<cuda::pose_matrix> matrices;
  for (const pose &at : poses) {
    require_movable(*kind_, at);
    matrices.push_back(cuda_pose(at));
  }
  const auto grid_of = [&](const pose &at) { return at.identity() ? of.grid_ : at.grid; };
  if (!poses.empty() &&
      std::all_of(poses.begin(), poses.end(), [&](const pose &at) { return grid_of(at) == grid_of(poses.front()); }))
    grid_ = grid_of(poses.front());
  device_memory<cuda::pose_matrix> there;
  device_memory<unsigned long long> bad;
  there.reserve(matrices.size(), "poses");
  bad.reserve(1, "poses");
  rows_.reserve(elements_ * fields, "a set in several poses");
  check(cudaMemcpyAsync(there.data(), matrices.data(), matrices.size() * sizeof(cuda::pose_matrix),
                        cudaMemcpyHostToDevice, stream),
        "uploading poses");
  check(launchers_->instances(of.rows_.data(), of.elements_, there.data(), static_cast<std::uint32_t>(poses.size()),
                              rows_.data(), bad.data(), stream),
        "starting a kernel");
  version_ = next_version();
  unsigned long long first = 0;
  check(cudaMemcpyAsync(&first, bad.data(), sizeof first, cudaMemcpyDeviceToHost, stream), "moving a set");
  check(cudaStreamSynchronize(stream), "moving a set");
  if (first != ~0ULL) {
    // Again, in this pose alone: the first element that is named is then that of the caller.
    const std::size_t at = first / of.elements_;
    check(launchers_->pose({of.rows_.data(), fields * sizeof(float), nullptr, 0, of.elements_}, matrices[at],
                           of.order_.data(), rows_.data(), bad.data(), nullptr, stream),
          "starting a kernel");
    check(cudaMemcpyAsync(&first, bad.data(), sizeof first, cudaMemcpyDeviceToHost, stream), "moving a set");
    check(cudaStreamSynchronize(stream), "moving a set");
    throw input_error(
        fault_of(rows_.data() + (first & 0xffffffff) * fields, static_cast<std::size_t>(first >> 32), poses[at]),
        *kind_, "pose " + std::to_string(numbers[at]) + ": ");
  }
}

// What a pose has made of a row on the device.
fault device_set::fault_of(const float *there, std::size_t element, const pose &at) const {
  std::vector<float> row(static_cast<std::size_t>(kind_->fields));
  pose unrounded = at;
  unrounded.grid = 0;
  fault f;
  f.kind = at.grid != 0 && unrounded.identity() ? fault_kind::rounded : fault_kind::moved;
  f.element = element, f.grid = at.grid;
  check(cudaMemcpy(row.data(), there, row.size() * sizeof(float), cudaMemcpyDeviceToHost), "moving a set");
  const auto bad = std::find_if_not(row.begin(), row.end(), [](float x) { return std::isfinite(x); });
  if (bad != row.end()) {
    f.field = static_cast<int>(bad - row.begin());
    f.value = *bad;
  } else {
    f.kind = fault_kind::rule;
    f.rule = kind_->fault ? kind_->fault(row.data()) : "";
  }
  return f;
}

void device_set::move(const pose &at) {
  const control_word_guard guard;
  if (elements_ > 0 && !order())
    throw std::invalid_argument("a set in several poses cannot be moved");
  if (at.identity()) {
    if (std::exchange(moved_, false))
      version_ = next_version();
    return;
  }
  require_movable(*kind_, at);
  const auto fields = static_cast<std::size_t>(kind_->fields);
  device_memory<float> to;
  device_memory<unsigned long long> bad;
  to.reserve(elements_ * fields, "a set under a pose");
  bad.reserve(1, "a set under a pose");
  check(launchers_->pose({rows_.data(), fields * sizeof(float), nullptr, 0, elements_}, cuda_pose(at), order_.data(),
                         to.data(), bad.data(), nullptr, on_->stream()),
        "starting a kernel");
  unsigned long long first = 0;
  check(cudaMemcpyAsync(&first, bad.data(), sizeof first, cudaMemcpyDeviceToHost, on_->stream()), "moving a set");
  check(cudaStreamSynchronize(on_->stream()), "moving a set");
  if (first != ~0ULL) {
    const auto slot = static_cast<std::size_t>(first & 0xffffffff);
    throw input_error(fault_of(to.data() + slot * fields, static_cast<std::size_t>(first >> 32), at), *kind_);
  }
  moved_rows_ = std::move(to);
  moved_grid_ = at.grid;
  moved_ = true;
  version_ = next_version();
}

std::pair<float, float> device_set::reaches() const {
  if (!moved_ && reaches_)
    return *reaches_;
  std::uint64_t lengths = 0;
  for (int f = 0; f < kind_->fields && f < 64; ++f)
    lengths |= static_cast<std::uint64_t>(kind_->roles[f] == role::length) << f;
  device_memory<float> most;
  most.reserve(2, "a set's reach");
  check(meetc::reaches(rows(), elements_, static_cast<unsigned>(kind_->fields), lengths, most.data(), on_->stream()),
        "starting a kernel");
  float seen[2] = {0, 0};
  check(cudaMemcpyAsync(seen, most.data(), sizeof seen, cudaMemcpyDeviceToHost, on_->stream()), "measuring a set");
  check(cudaStreamSynchronize(on_->stream()), "measuring a set");
  return {seen[0], seen[1]};
}

cuda::tree_view device_set::tree(cudaStream_t stream) {
  if (tree_of_ != version_) {
    tree_of_ = 0;
    tree_.make(*launchers_, rows(), elements_, stream);
    tree_of_ = version_;
  }
  return tree_.view(elements_);
}

void device_set::bounds(float lo[3], float hi[3]) {
  const control_word_guard guard;
  cuda::tree_box all; // empty
  if (elements_ > 0) {
    const cuda::tree_view view = tree(on_->stream());
    cuda::tree_node root;
    check(cudaMemcpyAsync(&root, view.nodes + view.shape.first[view.shape.depth - 1], sizeof root,
                          cudaMemcpyDeviceToHost, on_->stream()),
          "measuring a set");
    check(cudaStreamSynchronize(on_->stream()), "measuring a set");
    for (std::uint32_t lane = 0; lane < cuda::tree_width; ++lane)
      all.widen(cuda::box_of(root, lane));
  }
  std::copy_n(all.low, 3, lo);
  std::copy_n(all.high, 3, hi);
}

} // namespace meetc
