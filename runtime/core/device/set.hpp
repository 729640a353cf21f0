// core/device/set.hpp: a set on a device.
//
// It is uploaded once, and posed and collided often. Its rows lie in a spatial order, so that neighbours in space are adjacent:
// that of a prepared set, or one that is made on the device. A position in that order is a slot.
#ifndef MEETC_CORE_DEVICE_SET_HPP
#define MEETC_CORE_DEVICE_SET_HPP

#include "meet/core/device/tree.hpp"
#include "meet/core/query/collide.hpp"

#include <optional>
#include <span>
#include <utility>

namespace meetc {

class given_set;

// Throws std::invalid_argument where this pose does not go with this kind.
void require_movable(const kind_info &kind, const pose &at);

// Whether one kernel puts so many elements into order.
bool can_arrange(std::uint32_t elements);

class device_set {
public:
  // Throws device_error, also if the catalogue lacks the kind.
  device_set(device &on, const prepared &set);
  // Elements that nobody prepared: they are uploaded as they stand, and moved, checked and ordered there. Places are cells of
  // one grid. Where more than an eighth of the elements share a cell with 32 others, where they lie far apart in memory, or
  // where the device's memory does not suffice for that, prepare() orders the set instead, on this number of threads. Answers
  // are those of a prepared set. Throws what prepare() throws, and device_error.
  device_set(device &on, const view &elements, const kind_info &kind, const pose &at = {}, int threads = 0);

  // The elements of a given set, ordered as by the constructor above.
  device_set(device &on, const given_set &elements, int threads = 0);
  // A set without elements, which order() gives some.
  device_set(device &on, const kind_info &kind);

  // Every n-th element of `of`, as it was uploaded. They keep their numbers in `of`.
  device_set(const device_set &of, std::uint32_t n);
  // `of`, as it was uploaded, in each of these poses, one after another. Throws what move() throws, with the pose's number in
  // front of the text, and std::length_error beyond 2^32 - 1 elements. It has no order, and cannot be moved.
  device_set(const device_set &of, std::span<const pose> poses, std::span<const std::size_t> numbers);

  const kind_info &kind() const { return *kind_; }
  // Different from that of any other set, and the same under all poses.
  std::uint64_t id() const { return id_; }
  std::uint32_t elements() const { return elements_; }
  // How many the caller has, of which these may be some; order() names them by the caller's numbers, which are below this.
  std::uint32_t numbers() const { return numbers_; }
  bool is_on(const device &d) const { return on_ == &d; }

  // Moves the set to this pose, which replaces its last one. The arithmetic is that of core/views/pose.hpp, bit for bit.
  // Throws input_error where a number leaves float32, std::invalid_argument where the kind cannot be moved, and
  // device_error. After an exception other than device_error the set is as it was before.
  void move(const pose &at);

  // Becomes these elements of the caller's `numbers`, in device memory, in the pose. It only enqueues, on the stream: they are in
  // order, and may be used for more than a walk that findings() can stop, only if what it finds says so in the end. It takes this
  // share of the device, above 0 and at most 1. `cleared` becomes 0 on the way. Throws device_error.
  struct order_request {
    cuda::view elements;
    const pose &at;
    std::uint32_t numbers;
    float share;
    cuda::order_findings *found; // device memory
    std::span<unsigned long long> cleared;
    const cuda::joined_box *common = nullptr; // as in arrange_job; what else orders takes a box around the elements
  };
  void order(const order_request &r, cudaStream_t stream);
  // The same, but for the last step where one kernel does it all: its job is then returned, and is for the caller to start.
  std::optional<cuda::arrange_job> plan_order(const order_request &r, cudaStream_t stream);
  // What order() finds, in device memory; null after any other way to make a set.
  const cuda::order_findings *findings() const { return found_; }

  // The grid of its pose, or of that with which it was prepared (pose::grid).
  double grid() const { return moved_ ? moved_grid_ : grid_; }
  // The largest magnitude of a coordinate, and of a length. After a move they are measured on the device.
  std::pair<float, float> reaches() const;
  // How long the device took to move, check and order it, without uploading; 0: prepare() has done that.
  double ordered_seconds() const { return ordered_seconds_; }
  // The closed box around all elements; lo > hi where there are none.
  void bounds(float lo[3], float hi[3]);

  const float *rows() const { return moved_ ? moved_rows_.data() : rows_.data(); }
  const std::uint32_t *order() const { return order_.data(); }
  // Different for any other rows(), also those of other sets.
  std::uint64_t version() const { return version_; }

  bool has_tree() const { return tree_of_ == version_; }
  // The hierarchy of the boxes of rows(). It is made, on the stream, unless it exists already. The set has elements.
  cuda::tree_view tree(cudaStream_t stream);

private:
  device_set(device &on, const kind_info &kind, std::size_t elements, double grid);
  void upload(const prepared &set);
  void take_room_for_tree();
  bool make(const given_set &elements);
  bool take_room();
  std::optional<cuda::arrange_job> plan(const order_request &r, cudaStream_t stream);
  bool sort(const cuda::view &there, const pose &at, int bits, cuda::order_findings *found, cudaStream_t stream);
  fault fault_of(const float *there, std::size_t element, const pose &at) const;

  device *on_;
  const kind_info *kind_;
  const cuda::set_launchers *launchers_;
  std::uint32_t elements_ = 0, numbers_ = 0;
  std::optional<std::pair<float, float>> reaches_; // of rows_, where they are known
  double grid_ = 0, moved_grid_ = 0, ordered_seconds_ = 0;
  bool moved_ = false;
  std::uint64_t id_;
  std::uint64_t version_ = 0;
  device_memory<float> rows_, moved_rows_;
  device_memory<std::uint32_t> order_;
  const cuda::order_findings *found_ = nullptr;
  device_memory<std::byte> space_;       // to put it into order
  device_memory<std::uint32_t> counted_; // for that too; what uses it leaves it 0
  device_tree tree_;
  std::uint64_t tree_of_ = 0; // version
};

} // namespace meetc

#endif
