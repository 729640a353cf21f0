// The readers behind read(), one for each format. They throw io::error for bad input.
#ifndef MEETC_IO_ELEMENTS_READERS_HPP
#define MEETC_IO_ELEMENTS_READERS_HPP

#include "meet/io/elements/element_set.hpp"
#include "meet/io/elements/transform.hpp"
#include "meet/io/files/file_bytes.hpp"
#include "meet/io/text/pieces.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace meetc::io {

struct read_request {
  std::span<const kind_info *const> kinds;
  std::string kind; // the wanted one; empty: the one that the file holds
  char side = 'b';  // the letter of the options that messages name
  work by;
  const misplaced *fault = nullptr; // of an earlier reading; the reader throws it with its place in the file

  const kind_info *named(std::string_view name) const {
    for (const kind_info *const k : kinds)
      if (name == k->name)
        return k;
    return nullptr;
  }
  // Like named(), but throws if there is none with so many points and fields.
  const kind_info &need(const std::string &file, std::string_view name, int points, int fields) const;
};

element_set read_ply(const file_bytes &file, const read_request &q);
element_set read_obj(const file_bytes &file, const read_request &q);
element_set read_off(const file_bytes &file, const read_request &q);
element_set read_stl(const file_bytes &file, const read_request &q);
element_set read_csv(const file_bytes &file, const read_request &q);

// "y is inf, not finite" for a coordinate that was read so; `word` is how it is written, if it is text.
std::string describe_non_finite_point(const float *p, const std::array<std::string_view, 3> &words);

} // namespace meetc::io

#endif
