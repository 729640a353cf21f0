// The statements of an OBJ that carry no geometry, and the notes on those that were skipped.
#ifndef MEETC_IO_MESH_OBJ_STATEMENTS_HPP
#define MEETC_IO_MESH_OBJ_STATEMENTS_HPP

#include "meet/io/text/pieces.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meetc::io {

class skipped_statements {
public:
  // Counts a statement that starts at `at`. False if its keyword cannot be one, since it has a control character.
  bool add(std::string_view key, const char *at);
  void add(const skipped_statements &later);
  // One note on the statements that no OBJ has, and one on free-form curves and surfaces; none on normals, groups,
  // materials and their like.
  std::vector<std::string> notes(const text_file &text) const;

private:
  struct statement {
    const char *first;
    std::size_t times;
    bool free_form;
    std::size_t order; // of the first occurrence among those of all keywords
  };
  using entry = std::pair<const std::string, statement>;
  std::vector<const entry *> in_order() const;
  std::map<std::string, statement, std::less<>> seen_; // by keyword
};

} // namespace meetc::io

#endif
