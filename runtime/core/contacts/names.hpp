// core/contacts/names.hpp: the elements of some pairs, and the names of their vertices, edges and faces.
#ifndef MEETC_CORE_CONTACTS_NAMES_HPP
#define MEETC_CORE_CONTACTS_NAMES_HPP

#include "meet/core/contacts/contacts.hpp"
#include "meet/core/threads/threads.hpp"

namespace meetc {

// The elements of one side of the pairs, as rows in the order of the elements. `in`: by pair, the element's row.
touched_rows touched_by(const view &elements, const kind_info &kind, const pose &at, std::span<const index_pair> pairs,
                        bool side_b, std::vector<std::uint32_t> &in, const execution &on);

// The vertices of the rows, and the first row with the same three, or with the same centre and radius.
class part_names {
public:
  part_names(const touched_rows &of, const execution &on);

  // Two parts of rows have one name if and only if they have the same vertices, or are the same part of equal balls.
  std::uint64_t name(std::uint32_t row, int carrier) const;
  // Whether an edge runs from the later of its vertices to the earlier one. Edges with one name may run either way.
  bool runs_back(std::uint32_t row, int edge) const;

private:
  const touched_rows &of_;
  std::vector<std::uint32_t> vertices_; // of each row
  std::vector<std::uint32_t> first_;    // by row of a face or a ball: the first equal one

  std::array<std::uint32_t, 2> ends(std::uint32_t row, int edge) const;
};

} // namespace meetc

#endif
