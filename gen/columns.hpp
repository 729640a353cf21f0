// Tables as text.
#pragma once
#include <string>
#include <vector>

namespace meetc {

// Rows of as many cells as the first one. The first column is to the left, the others to the right, but for the last one if it
// is words.
std::string in_columns(const std::vector<std::vector<std::string>> &rows, bool words_last);

} // namespace meetc
