// core/device/set/cull.hpp: leaves out the elements of two sets that can touch nothing, before the sets are put into order.
//
// Problem: two meshes that reach into each other touch along a curve, and to put all of their elements into order takes longer
// than to answer. Method: marks on a grid over the box that both have in common (meetc/cuda/cull_grid.hpp). The smaller set
// marks, the larger is sifted by that and marks, and by its marks the smaller is sifted again. A set of long elements with two
// points marks along their lines and is not sifted again, because nearly all of it would be kept.
// Limits: it gains nothing where elements fill the box, as balls in a cloud do.
#ifndef MEETC_CORE_DEVICE_SET_CULL_HPP
#define MEETC_CORE_DEVICE_SET_CULL_HPP

#include "meetc/cuda/table.hpp"

#include <cstddef>
#include <cstdint>

namespace meetc {

class device;
class given_elements;

// The elements that are left of two sets, in device memory until the next query.
struct culled {
  const std::uint32_t *a = nullptr, *b = nullptr; // these elements
  std::uint32_t elements_a = 0, elements_b = 0;
  // The boxes around both sets, if few elements are left. Else the box that these have in common may be far larger than the
  // elements, which one vertex can make it.
  const cuda::joined_box *common = nullptr;

  // The views of both become those of what is left, or of nothing if nothing is left of one.
  void keep_only(cuda::view &of_a, cuda::view &of_b) const {
    const bool some = elements_a > 0 && elements_b > 0;
    of_a.only = a, of_a.elements = some ? elements_a : 0;
    of_b.only = b, of_b.elements = some ? elements_b : 0;
  }
};

// Whether culling is expected to take less time than it saves, which depends on what kind of sets these are and how large.
bool cull_pays(const given_elements &a, const given_elements &b);

// Waits for the device, and starts the clock of a query. With `by_lines`, pairs may be left out that do not touch although
// their boxes do. Returns false where there is too little memory. Throws device_error, and the input_error of an element
// that is none of its kind, also of one that is left out.
bool cull(const device &on, const given_elements &a, const given_elements &b, bool by_lines, culled &out);

} // namespace meetc

#endif
