// The only exception of meetc::io. what() is a single line that names the file and the place in it.
#ifndef MEETC_IO_FILES_ERROR_HPP
#define MEETC_IO_FILES_ERROR_HPP

#include <stdexcept>
#include <string>
#include <string_view>

namespace meetc::io {

// Bad input, or a file that cannot be read or written. Text files: `FILE:LINE: what`; binary files: `FILE: byte N:
// what` or `FILE: face N: what`. Elements count from 0, lines from 1. Control characters in the message are escaped, so
// that it stays one line whatever the file holds.
class error : public std::runtime_error {
public:
  explicit error(std::string_view message);
};

// A token of a file for a message: in single quotes, shortened if long, with bytes outside printable ASCII escaped.
std::string quote(std::string_view token);

} // namespace meetc::io

#endif
