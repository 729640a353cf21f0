// core/device/set/rows.hpp: what a query reads of a set on a device: packed rows in slots, and the hierarchy over them.
//
// Rows lie in a spatial order, so that neighbours in space are adjacent: that of a prepared set, or one that is made on the
// device. A position in that order is a slot.
#ifndef MEETC_CORE_DEVICE_SET_ROWS_HPP
#define MEETC_CORE_DEVICE_SET_ROWS_HPP

#include "meet/core/device/set/fours.hpp"
#include "meet/core/device/set/given.hpp"
#include "meet/core/device/set/tree.hpp"

#include <optional>
#include <span>
#include <utility>

namespace meetc {

// Throws usage_error where this pose does not go with this kind, or has no length scale.
void require_movable(const kind_info &kind, const pose &at);

// Whether one kernel puts so many elements into order.
bool can_arrange(std::uint32_t elements);

// All members throw device_error.
class device_rows {
public:
  // No elements. Throws device_error also if the catalogue lacks the kind.
  device_rows(const device &on, const kind_info &kind);

  const kind_info &kind() const { return *kind_; }
  const cuda::set_launchers &launchers() const { return *launchers_; }
  std::uint32_t elements() const { return elements_; }
  // How many the caller has, of which these may be some; order() names them by the caller's numbers, which are below this.
  std::uint32_t numbers() const { return numbers_; }

  const float *data() const { return moved_ ? moved_data_.data() : data_.data(); }
  // The element of each slot; null where the rows are instances of a set.
  const std::uint32_t *order() const { return order_.data(); }
  // Different for any other data(), also those of other sets.
  std::uint64_t version() const { return version_; }
  // The grid of the pose (pose::grid).
  double grid() const { return moved_ ? moved_grid_ : grid_; }
  // The largest magnitude of a coordinate, and of a length. Waits.
  std::pair<float, float> reaches() const;
  // The closed box around all elements; empty where there are none. Waits.
  cuda::tree_box bounds();

  bool has_tree() const { return tree_of_ == version_; }
  // The hierarchy of the boxes of data(). It is made, on the stream, unless it exists already. There are elements.
  cuda::tree_view tree(cudaStream_t stream);
  // That by fours, likewise; none where there are too many elements, or too little memory.
  std::optional<cuda::fours_view> fours(cudaStream_t stream);

  // These replace the rows. They throw std::length_error beyond 2^32 - 1 elements.
  //
  // Those of a prepared set, in its order.
  void upload(const prepared &set);
  // All of these, moved, checked and ordered; by the host, on this number of threads, where they are in no good order.
  // Throws what prepare() throws. Returns how long the device took, without uploading; 0: the host has ordered them.
  double make(const given_elements &elements, int threads);
  // Every n-th of `of`, as it was before it was moved. They keep their numbers in `of`.
  void take_part(const device_rows &of, std::uint32_t n);
  // `of`, as it was before it was moved, in each of these poses, one after another. Throws what move() throws, with the
  // pose's number in front of the text. These rows have no order, and cannot be moved.
  void take_instances(const device_rows &of, std::span<const pose> poses, std::span<const std::size_t> numbers);

  // The rows in this pose, which replaces the last one. The arithmetic is that of core/views/pose.hpp, bit for bit. Throws
  // input_error where a number leaves float32, and what require_movable() throws. After an exception other than device_error
  // the rows are as they were before.
  void move(const pose &at);

  // These elements of the caller's `numbers`, in device memory, in the pose. It only enqueues, on the stream: they are in
  // order, and may be used for more than a walk that findings() can stop, only if what it finds says so in the end. It takes
  // this share of the device, above 0 and at most 1. `cleared` becomes 0 on the way.
  struct order_request {
    cuda::view elements;
    const pose &at;
    std::uint32_t numbers;
    float share;
    cuda::order_findings *found; // device memory
    std::span<unsigned long long> cleared;
    const cuda::joined_box *common = nullptr; // as in arrange_job; what else orders takes a box around the elements
  };
  // But for the last step where one kernel does it all: its job is then returned, and is for the caller to start.
  std::optional<cuda::arrange_job> plan_order(const order_request &r, cudaStream_t stream);
  // The findings about the order, in device memory; null after any other way to get rows.
  const cuda::order_findings *findings() const { return found_; }

private:
  void resize(std::size_t elements, double grid);
  bool take_room();
  void take_room_for_tree();
  std::optional<cuda::arrange_job> plan(const order_request &r, cudaStream_t stream);
  bool sort(const cuda::view &there, const pose &at, int bits, cuda::order_findings *found, cudaStream_t stream);
  bool order_there(const given_elements &elements, double &seconds);
  // The first bad row of some that were written by a launcher, which has noted it there. Waits.
  std::optional<unsigned long long> first_bad(const device_memory<unsigned long long> &noted) const;
  fault fault_of(const float *there, std::size_t element, const pose &at) const;

  device on_;
  const kind_info *kind_;
  const cuda::set_launchers *launchers_;
  std::uint32_t elements_ = 0, numbers_ = 0;
  std::optional<std::pair<float, float>> reaches_; // before a move, where they are known
  double grid_ = 0, moved_grid_ = 0;
  bool moved_ = false;
  std::uint64_t version_ = 0;
  device_memory<float> data_, moved_data_;
  device_memory<std::uint32_t> order_;
  const cuda::order_findings *found_ = nullptr;
  device_memory<std::byte> space_;       // to put it into order
  device_memory<std::uint32_t> counted_; // for that too; what uses it leaves it 0
  device_tree tree_;
  device_fours fours_;
  std::optional<cuda::fours_view> fours_there_;
  std::uint64_t tree_of_ = 0, fours_of_ = 0; // versions
};

} // namespace meetc

#endif
