// The header of a CSV: the kind that its columns make, and the number that each column holds.
#ifndef MEETC_IO_CSV_HEADER_HPP
#define MEETC_IO_CSV_HEADER_HPP

#include "meet/io/elements/readers.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::io {

struct csv_header {
  const kind_info *kind = nullptr;
  std::string text;               // as it is written
  char separator = ',';           // or ';', with which a decimal comma is allowed, or a tab
  std::vector<int> fields;        // for each column the index of its number in a row; -1: left out
  std::vector<std::string> names; // of a row's numbers
  std::string left_out;           // the names of further columns
};

// Columns are found by name, in any order and case, in quotes or not; `radius` is `r`. If the header has the columns of
// several kinds, the kind with the most is taken (a sphere, not a point), unless r stands beside g and b, since it may
// then be red. Throws io::error if no kind or more than one is left. `place` is "FILE:LINE".
csv_header read_csv_header(const std::string &place, std::string_view line, const read_request &q);

// The fields of a line, without blanks around them; false where a quote is not closed. A field in quotes is given without
// them, and may hold the separator.
bool split_fields(std::string_view line, char separator, std::vector<std::string_view> &out);

} // namespace meetc::io

#endif
