// Tables as text.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace meetc {

// How many columns a terminal gives to a UTF-8 text: one for each character, two for a wide one, none for a mark on another.
std::size_t displayed_width(std::string_view text);

// Rows of as many cells as the first one. The first column is to the left, the others to the right, but for the last one if it
// is words.
std::string in_columns(const std::vector<std::vector<std::string>> &rows, bool words_last);

} // namespace meetc
