// core/query/chunks.hpp: the pairs of collide(), handed out a chunk at a time, in memory that does not grow with them.
//
// The order of the list needs the pairs of each element of a together, and finding them in that order would take the place of
// the spatial one. So all elements of a are asked at once, and where they have more pairs than there is room for, fewer, in the
// order of their numbers; each such part is a set of its own, in the spatial order of a (core/sets/set_part.hpp). A part that
// turns out to have too many pairs is given up as soon as it does, and is asked again in smaller parts. Memory holds at most as
// many pairs as both sets have elements, or a chunk if that is more, besides a sorted copy of them.
#ifndef MEETC_CORE_QUERY_CHUNKS_HPP
#define MEETC_CORE_QUERY_CHUNKS_HPP

#include "meet/core/query/collide.hpp"

#include <functional>
#include <span>

namespace meetc {

// Takes the next pairs of the list; they are gone when it returns. An exception of it ends the call.
using take_pairs = std::function<void(std::span<const index_pair> pairs)>;

// Calls take(), on the calling thread, with the list of collide() from its first pair to its last: `chunk` pairs at a time, and
// at last those that are left. The result is that of collide() without the list; candidates and rungs count a pair of one set
// with itself twice where collide() looks at half of them. Throws what collide() throws, and usage_error for a chunk
// of no pairs, options.want other than pairs, and options.first_met.
result collide_in_chunks(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
                         std::size_t chunk, const take_pairs &take, const collide_options &options = {});

} // namespace meetc

#endif
