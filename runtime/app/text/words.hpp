// app/text/words.hpp: counts and boxes as text for people.
#ifndef MEETC_APP_TEXT_WORDS_HPP
#define MEETC_APP_TEXT_WORDS_HPP

#include "meet/core/hierarchy/box.hpp"
#include "meet/io/elements/words.hpp"

#include <string>

namespace meetc::app {

using io::counted;
using io::grouped;
using io::in_words;
// "[0, 0, 0] to [1, 1, 1]"
std::string in_words(const box &b);

} // namespace meetc::app

#endif
