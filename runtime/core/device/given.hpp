// core/device/given.hpp: a set on a device as it is given: in no order, not moved and not checked.
//
// It is for sets that are collided once, such as those of one step of a simulation: a query puts into order what it needs, and
// of two meshes that is little (cull.hpp). A set that is asked again is better a device_set, which keeps its order.
#ifndef MEETC_CORE_DEVICE_GIVEN_HPP
#define MEETC_CORE_DEVICE_GIVEN_HPP

#include "meet/core/device/collide.hpp"

#include <memory>
#include <vector>

namespace meetc {

// As the kernels read it.
cuda::pose_matrix cuda_pose(const pose &at);
// Throws std::invalid_argument where this pose does not go with this kind.
void require_pose(const kind_info &kind, const pose &at);
// The view with its stride stated. Throws input_error where it cannot hold elements of the kind.
view require_view(const view &elements, const kind_info &kind);
// Throws device_error if the catalogue lacks the kind.
const cuda::set_launchers &launchers_of(const cuda::catalogue &all, const kind_info &kind);

class given_set {
public:
  // Uploads the elements. Throws std::invalid_argument where this pose does not go with this kind, input_error where the view does
  // not, std::length_error (2^32 elements or vertices, or more), and device_error, also if the catalogue lacks the kind.
  given_set(device &on, const view &elements, const kind_info &kind, const pose &at = {});
  // Elements that lie in this device's memory, where they must stay as they are while a query runs. The query reads them on the
  // device's own stream; what writes them must have ended. Throws likewise.
  given_set(device &on, const cuda::view &there, const kind_info &kind, const pose &at = {});
  ~given_set();
  given_set(given_set &&) noexcept;

  // The same where it costs little: null where elements lie far apart in memory, where the kind has no index, or where there is
  // too little memory on the device.
  static std::unique_ptr<given_set> if_it_fits(device &on, const view &elements, const kind_info &kind, const pose &at);

  const kind_info &kind() const { return *kind_; }
  const cuda::set_launchers &launchers() const { return *launchers_; }
  std::uint32_t elements() const { return there_.elements; }
  const pose &at() const { return at_; }
  const cuda::view &there() const { return there_; }
  bool is_on(const device &d) const { return on_ == &d; }

  struct copy {
    std::vector<std::byte> data;
    std::vector<std::uint32_t> index;
    view elements; // of these
  };
  copy download() const;
  // Throws the input_error that says what is wrong, where something is.
  void refuse() const;

  // What a query puts into order. It is kept here, so that only the first query allocates memory.
  device_set &ordered();

private:
  given_set(device &on, const kind_info &kind, const pose &at);
  bool upload(const view &elements); // false: too little memory

  device *on_;
  const kind_info *kind_;
  const cuda::set_launchers *launchers_;
  pose at_;
  cuda::view there_{};
  device_memory<std::byte> data_;
  device_memory<std::uint32_t> index_;
  std::unique_ptr<device_set> ordered_;
};

// collide() of sets as they are given. The answers are the same, and so is what is thrown; input_error is thrown as by the
// constructor of device_set, of A before B. device_seconds
// runs from the given elements to the sorted pairs, and contains what the host takes in between. Where `left_there` is not null,
// and pairs are asked for, their list stays on the device, if they could be sorted there; else it is in the result.
device_result collide(device &on, given_set &a, given_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options = {}, pairs_there *left_there = nullptr);

} // namespace meetc

#endif
