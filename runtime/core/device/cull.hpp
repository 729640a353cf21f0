// core/device/cull.hpp: leaves out the elements of two sets that can touch nothing, before the sets are put into order.
//
// Problem: two meshes that reach into each other touch along a curve, and to put all of their elements into order takes longer
// than to answer. Method: marks on a grid over the box that both have in common (meetc/cuda/cull_grid.hpp). The smaller set marks,
// the larger is sifted by that and marks, and by its marks the smaller is sifted again. A set of long elements with two points
// marks along their lines and is not sifted again, because nearly all of it would be kept.
// Limits: it gains nothing where elements fill the box, as balls in a cloud do.
#ifndef MEETC_CORE_DEVICE_CULL_HPP
#define MEETC_CORE_DEVICE_CULL_HPP

#include "meetc/cuda/table.hpp"

#include <cstddef>
#include <cstdint>

namespace meetc {

class device;
class given_set;

// In device memory, all 0 at first. Of two sets the one that marks first is 0.
struct cull_findings {
  cuda::joined_box around[2];
  unsigned kept[3]; // of set 0, of set 1, and of set 0 by the marks of set 1
  unsigned arrived; // blocks of the last kernel
  unsigned long long bad[2];
};

// What is left of two sets: how many, and which, in device memory until the next query.
struct culled {
  const std::uint32_t *a = nullptr, *b = nullptr;
  std::uint32_t elements_a = 0, elements_b = 0;
  const cuda::joined_box *around = nullptr; // of both, two boxes, likewise
  bool bad_a = false, bad_b = false;        // an element that is none of its kind was found, among all
};

// Whether culling is expected to take less time than it saves, which depends on what kind of sets these are and how large.
bool cull_pays(const given_set &a, const given_set &b);

// Waits for the device. With `by_lines`, pairs may be left out that do not touch although their boxes do. Returns false where
// there is too little memory. Throws device_error.
bool cull(device &on, const given_set &a, const given_set &b, bool by_lines, culled &out);

} // namespace meetc

#endif
