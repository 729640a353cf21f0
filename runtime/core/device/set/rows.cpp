#include "meet/core/device/set/rows.hpp"

#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/device/set/order_kernels.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meet/core/views/usage_error.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace meetc {

std::uint64_t next_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

void require_movable(const kind_info &kind, const pose &at) {
  require_pose(kind, at);
  if (!under_standard_word([&] { return at.length_scale >= 0; }))
    throw usage_error("a pose's length scale is negative or not a number");
}

device_rows::device_rows(const device &on, const kind_info &kind)
    : on_(on), kind_(&kind), launchers_(&launchers_of(on.kernels(), kind)), version_(next_version()) {}

// All that was is forgotten, but its memory.
void device_rows::resize(std::size_t elements, double grid) {
  if (elements > 0xffffffff)
    throw std::length_error(text(status::too_many_elements));
  elements_ = numbers_ = static_cast<std::uint32_t>(elements);
  grid_ = grid, moved_ = false, reaches_.reset(), found_ = nullptr;
  version_ = next_version();
}

void device_rows::upload(const prepared &set) {
  if (!set.whole())
    throw usage_error("a set on a device must not be prepared for collisions with one other set");
  resize(set.elements(), set.set().grid);
  const std::size_t floats = std::size_t{elements_} * static_cast<std::size_t>(kind_->fields);
  data_.reserve(floats, "a set's elements");
  order_.reserve(elements_, "a set's order");
  transfers &moving = on_.buffers().moving;
  moving.upload(data_.data(), set.set().rows, floats * sizeof(float), on_.stream(), "uploading a set");
  moving.upload(order_.data(), set.set().order, elements_ * sizeof(std::uint32_t), on_.stream(), "uploading a set");
  reaches_ = {set.set().reach, set.set().longest};
  check(cudaStreamSynchronize(on_.stream()), "uploading a set"); // the caller may now change the memory
  take_room_for_tree();
}

void device_rows::take_part(const device_rows &of, std::uint32_t n) {
  resize((std::size_t{of.elements_} + (n - 1)) / n, of.grid_);
  const auto strided = [&](auto &to, const auto &from, std::size_t each) {
    const std::size_t bytes = each * sizeof *to.data();
    to.reserve(elements_ * each, "a part of a set");
    check(cudaMemcpy2DAsync(to.data(), bytes, from.data(), n * bytes, bytes, elements_, cudaMemcpyDeviceToDevice,
                            on_.stream()),
          "taking a part of a set");
  };
  strided(data_, of.data_, static_cast<std::size_t>(kind_->fields));
  strided(order_, of.order_, 1);
}

void device_rows::take_instances(const device_rows &of, std::span<const pose> poses,
                                 std::span<const std::size_t> numbers) {
  std::vector<cuda::pose_matrix> matrices;
  for (const pose &at : poses) {
    require_movable(*kind_, at);
    matrices.push_back(cuda_pose(at));
  }
  const auto grid_of = [&](const pose &at) { return at.identity() ? of.grid_ : at.grid; };
  const bool alike = !poses.empty() &&
                     std::ranges::all_of(poses, [&](const pose &at) { return grid_of(at) == grid_of(poses.front()); });
  resize(of.elements_ * poses.size(), alike ? grid_of(poses.front()) : 0);
  const auto fields = static_cast<std::size_t>(kind_->fields);
  const cudaStream_t stream = on_.stream();
  device_memory<cuda::pose_matrix> there;
  device_memory<unsigned long long> bad;
  there.reserve(matrices.size(), "poses");
  bad.reserve(1, "poses");
  data_.reserve(elements_ * fields, "a set in several poses");
  check(cudaMemcpyAsync(there.data(), matrices.data(), matrices.size() * sizeof(cuda::pose_matrix),
                        cudaMemcpyHostToDevice, stream),
        "uploading poses");
  check(launchers_->instances(of.data_.data(), of.elements_, there.data(), static_cast<std::uint32_t>(poses.size()),
                              data_.data(), bad.data(), stream),
        "starting a kernel");
  const std::optional<unsigned long long> first = first_bad(bad);
  if (!first)
    return;
  // Again, in this pose alone: the first element that is named is then that of the caller.
  const std::size_t at = *first / of.elements_;
  device_rows alone(on_, *kind_);
  alone.take_part(of, 1);
  try {
    alone.move(poses[at]);
  } catch (const input_error &e) {
    throw input_error(e.where, *kind_, "pose " + std::to_string(numbers[at]) + ": ");
  }
}

std::optional<unsigned long long> device_rows::first_bad(const device_memory<unsigned long long> &noted) const {
  unsigned long long first = 0;
  check(cudaMemcpyAsync(&first, noted.data(), sizeof first, cudaMemcpyDeviceToHost, on_.stream()), "moving a set");
  check(cudaStreamSynchronize(on_.stream()), "moving a set");
  return first == ~0ULL ? std::nullopt : std::optional(first);
}

// The fault of a row that a pose has made on the device.
fault device_rows::fault_of(const float *there, std::size_t element, const pose &at) const {
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

void device_rows::move(const pose &at) {
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
  check(launchers_->pose({data_.data(), fields * sizeof(float), nullptr, 0, elements_}, cuda_pose(at), order_.data(),
                         to.data(), bad.data(), nullptr, on_.stream()),
        "starting a kernel");
  if (const auto first = first_bad(bad)) {
    const auto slot = static_cast<std::size_t>(*first & 0xffffffff);
    throw input_error(fault_of(to.data() + slot * fields, static_cast<std::size_t>(*first >> 32), at), *kind_);
  }
  moved_data_ = std::move(to);
  moved_grid_ = at.grid;
  moved_ = true;
  version_ = next_version();
}

std::pair<float, float> device_rows::reaches() const {
  if (!moved_ && reaches_)
    return *reaches_;
  std::uint64_t lengths = 0;
  for (int f = 0; f < kind_->fields && f < 64; ++f)
    lengths |= static_cast<std::uint64_t>(kind_->roles[f] == role::length) << f;
  device_memory<float> most;
  most.reserve(2, "a set's reach");
  check(meetc::reaches(data(), elements_, static_cast<unsigned>(kind_->fields), lengths, most.data(), on_.stream()),
        "starting a kernel");
  float seen[2] = {0, 0};
  check(cudaMemcpyAsync(seen, most.data(), sizeof seen, cudaMemcpyDeviceToHost, on_.stream()), "measuring a set");
  check(cudaStreamSynchronize(on_.stream()), "measuring a set");
  return {seen[0], seen[1]};
}

// Most queries want the hierarchy, and to wait for memory takes longer than to make that of a small set.
void device_rows::take_room_for_tree() {
  if (elements_ > 0)
    tree_.take_room(elements_, on_.stream());
}

cuda::tree_view device_rows::tree(cudaStream_t stream) {
  if (tree_of_ != version_) {
    tree_of_ = 0;
    tree_.make(*launchers_, data(), elements_, stream);
    tree_of_ = version_;
  }
  return tree_.view(elements_);
}

std::optional<cuda::fours_view> device_rows::fours(cudaStream_t stream) {
  const cuda::tree_view all = tree(stream);
  if (fours_of_ != version_) {
    fours_of_ = 0;
    fours_there_ = fours_.make(all, stream);
    fours_of_ = version_;
  }
  return fours_there_;
}

cuda::tree_box device_rows::bounds() {
  cuda::tree_box all; // empty
  if (elements_ == 0)
    return all;
  const cuda::tree_view view = tree(on_.stream());
  cuda::tree_node root;
  check(cudaMemcpyAsync(&root, view.nodes + view.shape.first[view.shape.depth - 1], sizeof root, cudaMemcpyDeviceToHost,
                        on_.stream()),
        "measuring a set");
  check(cudaStreamSynchronize(on_.stream()), "measuring a set");
  for (std::uint32_t lane = 0; lane < cuda::tree_width; ++lane)
    all.widen(cuda::box_of(root, lane));
  return all;
}

} // namespace meetc
