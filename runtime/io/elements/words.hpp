// io/elements/words.hpp: the elements of a set, and what reading has moved, as text for people.
#ifndef MEETC_IO_ELEMENTS_WORDS_HPP
#define MEETC_IO_ELEMENTS_WORDS_HPP

#include "meet/io/elements/element_set.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace meetc::io {

// Whether the elements are triangles, which can be coloured face by face, and whose faces a report counts.
inline bool is_mesh(const element_set &set) {
  return set.kind->points == 3 && set.kind->fields == 9;
}

// 345944 as "345,944".
std::string grouped(std::uint64_t n);
// "69,451 faces", "1 sphere"; for polygons the number of triangles as well, and for polylines that of segments.
std::string counted(const element_set &set);
std::string counted(const element_set &set, std::uint64_t n);
// "3 numbers of A moved, by 0.0075 at most", or without " of A"
std::string in_words(const rounded_numbers &moved, std::string_view of = "");

} // namespace meetc::io

#endif
