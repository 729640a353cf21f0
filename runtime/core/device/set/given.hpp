// core/device/set/given.hpp: elements on a device as a caller gives them: in no order, not moved and not checked.
#ifndef MEETC_CORE_DEVICE_SET_GIVEN_HPP
#define MEETC_CORE_DEVICE_SET_GIVEN_HPP

#include "meet/core/device/memory/memory.hpp"
#include "meet/core/sets/prepared.hpp"

#include <optional>

namespace meetc {

// As the kernels read it.
cuda::pose_matrix cuda_pose(const pose &at);
// Throws usage_error where this pose does not go with this kind.
void require_pose(const kind_info &kind, const pose &at);
// The view with its stride stated. Throws input_error where it cannot hold elements of the kind.
view require_view(const view &elements, const kind_info &kind);
// Throws device_error if the catalogue lacks the kind.
const cuda::set_launchers &launchers_of(const cuda::catalogue &all, const kind_info &kind);

// All members throw device_error.
class given_elements {
public:
  // Copies the elements there. Throws also input_error where the view cannot hold elements of the kind, and
  // std::length_error (2^32 elements or vertices, or more).
  given_elements(const device &on, const view &elements, const kind_info &kind);
  // Elements that the caller has there, and keeps there.
  given_elements(const device &on, const cuda::view &there, const kind_info &kind);
  // Whether to copy these costs little: they do not lie far apart in memory, and the device has the memory.
  static std::optional<given_elements> if_it_fits(const device &on, const view &elements, const kind_info &kind);

  const kind_info &kind() const { return *kind_; }
  const cuda::view &there() const { return there_; }
  pose at; // in which a query reads them

  // Puts them into order on the host, on this number of threads. Throws what prepare() throws.
  prepared prepare_here(int threads) const;
  // Throws the input_error that says what is wrong, where something is.
  void refuse() const;
  // The closed box around all elements in their pose; lo > hi where there are none.
  cuda::tree_box bounds() const;

private:
  struct copy;
  given_elements(const device &on, const kind_info &kind) : on_(on), kind_(&kind) {}
  bool upload(const view &elements); // false: too little memory
  copy download() const;

  device on_;
  const kind_info *kind_;
  cuda::view there_{};
  device_memory<std::byte> data_;
  device_memory<std::uint32_t> index_;
};

} // namespace meetc

#endif
