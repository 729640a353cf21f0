// A thin layer over toml++: strict tables in which every value knows its place in the file.
#pragma once
#include "gen/lang/syntax.hpp"

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

namespace meetc::lang {

class toml_reader {
public:
  explicit toml_reader(const std::string &path);

  const toml::table &root() const { return root_; }
  std::shared_ptr<const source_file> file() const { return file_; }

  location place(const toml::node &node) const { return place(node.source()); }
  location place(const toml::source_region &region) const;
  location place(const toml::key &key) const { return place(key.source()); }

  // Throws at the first key that is not in `known`.
  void allow(const toml::table &table, const std::string &what, const std::vector<std::string> &known) const;

  const toml::table &as_table(const toml::node &node, const std::string &what) const;
  std::string as_string(const toml::node &node, const std::string &what) const;
  std::vector<std::string> as_strings(const toml::node &node, const std::string &what) const;
  const toml::array &as_array(const toml::node &node, const std::string &what) const;
  double as_positive_number(const toml::node &node, const std::string &what) const; // finite
  std::int64_t as_whole_number(const toml::node &node, const std::string &what, std::int64_t least,
                               std::int64_t most) const;
  bool as_bool(const toml::node &node, const std::string &what) const;

  // A 'literal' or '''literal''' string, parsed as an expression.
  expr_ptr as_expression(const toml::node &node, const std::string &what) const;
  // The part of the file inside the quotes.
  expr_source inside(const toml::node &node, const std::string &what) const;

  // The table's entries in the order of the file (toml++ sorts them by name).
  std::vector<std::pair<const toml::key *, const toml::node *>> in_file_order(const toml::table &table) const;

private:
  std::shared_ptr<const source_file> file_;
  toml::table root_;
};

// Throws where the table says `spec` and means another version of the language than this one, 1.
void check_version(const toml_reader &in, const toml::table &table);

// Throws where this is no name: `what` says for what, "a namespace".
void need_name(const std::string &name, const location &at, const char *what);

} // namespace meetc::lang
