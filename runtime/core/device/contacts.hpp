// core/device/contacts.hpp: where pairs meet, with the codes and the coordinates found on a CUDA device.
//
// The answer is that of core/contacts/contacts.hpp, bit for bit. The host gathers the rows of the pairs and uploads them; a
// thread of the device finds the contact code of a pair, and later the coordinates of a node. The host, which has exact
// integers, takes the pairs and nodes that double-double does not tell: zero signs where differences span more than some thirty
// bits, and zero coordinates although no element lies in that plane. Names and joining are the host's.
#ifndef MEETC_CORE_DEVICE_CONTACTS_HPP
#define MEETC_CORE_DEVICE_CONTACTS_HPP

#include "meet/core/contacts/contacts.hpp"
#include "meet/core/device/memory/device.hpp"

namespace meetc {

// The device's part of it, and the host's.
struct device_contact_work {
  double codes_seconds = 0, places_seconds = 0; // of the two kernels alone
  std::size_t pairs_left = 0, nodes_left = 0;
};

// Throws what contacts() on the CPU throws, and device_error. Where no kernel was generated for the contacts of this predicate,
// as for those with a ball, the host finds all of them. work: null where it is not asked for.
template <class Real = float>
contact_set<Real> contacts(const device &on, const view &a, const view &b, const predicate_info &predicate,
                           std::span<const index_pair> pairs, const contact_options &options = {},
                           device_contact_work *work = nullptr);

} // namespace meetc

#endif
