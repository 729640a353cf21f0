// core/device/set/device_set.hpp: a set on a device.
#ifndef MEETC_CORE_DEVICE_SET_DEVICE_SET_HPP
#define MEETC_CORE_DEVICE_SET_DEVICE_SET_HPP

#include "meet/core/device/set/rows.hpp"

namespace meetc {

// A set is in order, and is then collided often; or it is given, and each query puts what it needs of it into order. That is
// for sets that are collided once, such as those of one step of a simulation: of two meshes a query needs little (cull.hpp).
//
// All members throw device_error.
class device_set {
public:
  // In the order of a prepared set. Throws device_error also if the catalogue lacks the kind, as all constructors do, and
  // usage_error if the set was prepared for collisions with one other set.
  device_set(const device &on, const prepared &set);
  // Elements that nobody prepared: they are uploaded as they stand, and moved, checked and ordered there. Places are cells
  // of one grid. Where more than an eighth of the elements share a cell with 32 others, where they lie far apart in memory,
  // or where the device's memory does not suffice for that, prepare() orders the set instead, on this number of threads.
  // Answers are those of a prepared set. Throws what prepare() throws.
  device_set(const device &on, const view &elements, const kind_info &kind, const pose &at = {}, int threads = 0);

  // Elements as they are given, which a query moves, checks and puts into order. They are uploaded. Throws input_error where
  // the view cannot hold elements of the kind, and std::length_error (2^32 elements or vertices, or more).
  static device_set given(const device &on, const view &elements, const kind_info &kind);
  // They lie in the device's memory, where they must stay as they are while a query runs. The query reads them on the
  // device's own stream; what writes them must have ended. Throws likewise.
  static device_set given(const device &on, const cuda::view &there, const kind_info &kind);

  const kind_info &kind() const { return rows_.kind(); }
  std::uint32_t elements() const { return given_ ? given_->there().elements : rows_.elements(); }
  const device &on() const { return on_; }

  // Moves the set to this pose, which replaces its last one. The arithmetic is that of core/views/pose.hpp, bit for bit. Throws
  // usage_error where the kind cannot be moved, and input_error where a number leaves float32; of a given set it
  // is the query that throws that. After an exception other than device_error the set is as it was before.
  void move(const pose &at);
  // The closed box around all elements; lo > hi where there are none.
  void bounds(float lo[3], float hi[3]);
  // How long the device took to move, check and order it, without uploading; 0: prepare() or a query does that.
  double ordered_seconds() const { return ordered_seconds_; }

  // For what reads sets there. Null: the set is in order.
  const given_elements *as_given() const { return given_ ? &*given_ : nullptr; }
  // The rows; in a given set, those that the last query has put into order. They are kept, so that only the first query
  // allocates memory.
  device_rows &rows() { return rows_; }
  const device_rows &rows() const { return rows_; }

private:
  device_set(const device &on, given_elements &&elements);

  device on_;
  device_rows rows_;
  std::optional<given_elements> given_;
  double ordered_seconds_ = 0;
};

} // namespace meetc

#endif
