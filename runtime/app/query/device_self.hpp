// app/query/device_self.hpp: where a mesh crosses itself, and where pairs meet, on the CUDA device.
#ifndef MEETC_APP_QUERY_DEVICE_SELF_HPP
#define MEETC_APP_QUERY_DEVICE_SELF_HPP

#include "meet/app/query/device_pairs.hpp"
#include "meet/core/contacts/contacts.hpp"
#include "meet/core/query/self_pairs.hpp"

namespace meetc::app {

struct device_self {
  self_result found;
  device_account account;
  box around{}; // lo > hi where there are no elements
  double prepare_seconds = 0;
};

// These throw failure, with exit code no_device, where the device fails or lacks the memory, or where the build has no kernels.
device_self self_pairs_on_device(const io::element_set &mesh, const self_predicates &by, const self_options &options);
template <class Real>
contact_set<Real> contacts_on_device(const io::element_set &a, const io::element_set &b,
                                     const predicate_info &predicate, std::span<const index_pair> pairs,
                                     const contact_options &options);

} // namespace meetc::app

#endif
