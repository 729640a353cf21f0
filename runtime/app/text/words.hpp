// app/text/words.hpp: counts and boxes as text for people.
#ifndef MEETC_APP_TEXT_WORDS_HPP
#define MEETC_APP_TEXT_WORDS_HPP

#include "meet/core/hierarchy/box.hpp"
#include "meet/io/elements/element_set.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace meetc::app {

// 345944 as "345,944".
std::string grouped(std::uint64_t n);
// "69,451 faces", "1 sphere"; for polygons the number of triangles as well, and for polylines that of segments.
std::string counted(const io::element_set &set);
std::string counted(const io::element_set &set, std::uint64_t n);
// "3 numbers of A moved, by 0.0075 at most", or without " of A"
std::string in_words(const io::rounded_numbers &moved, std::string_view of = "");
// "[0, 0, 0] to [1, 1, 1]"
std::string in_words(const box &b);

} // namespace meetc::app

#endif
