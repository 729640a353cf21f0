// core/contacts/joining.hpp: joins the segments and polygons of pairs into pieces, polylines and patches, by the names of
// their nodes.
#ifndef MEETC_CORE_CONTACTS_JOINING_HPP
#define MEETC_CORE_CONTACTS_JOINING_HPP

#include "meet/core/contacts/contacts.hpp"
#include "meet/core/threads/threads.hpp"

namespace meetc {

// From codes, corners and the number of nodes.
struct joined_contacts {
  std::vector<std::array<std::uint32_t, 2>> pieces;
  node_lists polylines, patches;
  std::vector<std::uint8_t> closed;
  std::vector<std::uint32_t> patch_pairs, single_nodes;
};
joined_contacts join_contacts(std::span<const std::uint64_t> codes, const node_lists &corners, std::size_t nodes,
                              const execution &on);

} // namespace meetc

#endif
