// The words of an ascii STL.
#ifndef MEETC_IO_MESH_STL_ASCII_HPP
#define MEETC_IO_MESH_STL_ASCII_HPP

#include "meet/io/elements/readers.hpp"

#include <vector>

namespace meetc::io {

struct stl_text {
  std::vector<float> rows; // 9 numbers for each facet
  rounded_numbers rounded;
};

// Keywords are in upper or lower case, and words are on any lines. A facet may lack its normal. A word that begins with '#'
// or ';' makes the rest of its line a comment. Throws io::error `FILE:LINE: what`.
stl_text read_stl_ascii(const file_bytes &file, const read_request &q);

} // namespace meetc::io

#endif
