#include "gen/lang/toml_reader.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace meetc::lang {
namespace {
constexpr std::size_t most_bytes = 4'000'000; // more than anyone writes, and read in a second

// toml++ counts columns in code points and does not count a byte order mark.
std::size_t offset_of(const std::string &text, const toml::source_position &at) {
  std::size_t offset = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  for (std::size_t line = 1; line < at.line; ++line) {
    const std::size_t end = text.find('\n', offset);
    if (end == std::string::npos)
      return text.size();
    offset = end + 1;
  }
  for (std::size_t column = 1; column < at.column && offset < text.size(); ++column)
    for (++offset; offset < text.size() && (text[offset] & 0xc0) == 0x80;)
      ++offset;
  return offset;
}

bool is_name(const std::string &s) {
  return !s.empty() && (std::isalpha(static_cast<unsigned char>(s[0])) || s[0] == '_') &&
         std::all_of(s.begin(), s.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}
} // namespace

namespace {
// The parser's own words, with what a spec most often means. It names a key that is given twice by other bytes, and points
// behind it.
spec_error not_toml(location at, std::string said) {
  const std::string_view prefix = "Error while parsing ";
  if (said.starts_with(prefix))
    said = (said.substr(prefix.size(), 5) == "array" ? "in an " : "in a ") + said.substr(prefix.size());
  const std::string &text = at.file->text;
  const std::size_t start = at.offset - (at.column() - 1);
  if (const auto cut = said.find("cannot redefine existing"); cut != std::string::npos) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string line = text.substr(start, end - start);
    const std::string key =
        line.substr(0, line.find_last_not_of(" \t", std::max<std::size_t>(line.find('='), 1) - 1) + 1);
    const bool header = line.starts_with('[');
    return {location{at.file, start, header ? line.size() : key.size()},
            fmt::format("{} is given twice", header ? line : key)};
  }
  if (said.find("boolean") != std::string::npos || said.find("floating-point") != std::string::npos ||
      said.find("expected value") != std::string::npos)
    said += "; an expression or a name stands in single quotes: '…'";
  else if (said.find("literal string") != std::string::npos && said.find("control") != std::string::npos)
    said = "this string has no closing quote in its line; three quotes, '\'\'…\'\'\', hold several lines";
  else if (said.find("array: expected comma") != std::string::npos)
    said += "; an array closes with ']', and commas stand between its items";
  return {std::move(at), said};
}
} // namespace

toml_reader::toml_reader(const std::string &path) : file_(read_source(path)) {
  if (file_->text.size() > most_bytes)
    throw spec_error({file_, 0, 1}, fmt::format("this file has more than {} bytes", most_bytes));
  try {
    root_ = toml::parse(file_->text, path);
  } catch (const toml::parse_error &e) {
    throw not_toml(place(e.source()), std::string(e.description()));
  }
}

location toml_reader::place(const toml::source_region &region) const {
  const std::size_t begin = offset_of(file_->text, region.begin);
  const std::size_t end = std::max(begin + 1, offset_of(file_->text, region.end));
  return {file_, begin, end - begin};
}

void toml_reader::allow(const toml::table &table, const std::string &what,
                        const std::vector<std::string> &known) const {
  for (const auto &[key, node] : table)
    if (std::find(known.begin(), known.end(), std::string(key.str())) == known.end())
      throw spec_error(place(key), fmt::format("{} has no '{}'; it may have: {}{}", what, key.str(), join(known, ", "),
                                               nearest(key.str(), known)));
}

const toml::table &toml_reader::as_table(const toml::node &node, const std::string &what) const {
  if (!node.is_table())
    throw spec_error(place(node), fmt::format("{} must be a table", what));
  return *node.as_table();
}

const toml::array &toml_reader::as_array(const toml::node &node, const std::string &what) const {
  if (!node.is_array())
    throw spec_error(place(node), fmt::format("{} must be an array, in brackets: […]", what));
  return *node.as_array();
}

std::string toml_reader::as_string(const toml::node &node, const std::string &what) const {
  if (!node.is_string())
    throw spec_error(place(node), fmt::format("{} must be a string{}", what,
                                              node.is_array() ? ", and this is an array" : ", as in '…'"));
  return node.as_string()->get();
}

std::vector<std::string> toml_reader::as_strings(const toml::node &node, const std::string &what) const {
  std::vector<std::string> out;
  for (const toml::node &item : as_array(node, what))
    out.push_back(as_string(item, "each item of " + what));
  return out;
}

double toml_reader::as_positive_number(const toml::node &node, const std::string &what) const {
  const std::optional<double> v = node.value<double>(); // accepts an integer too
  if (!node.is_number() || !v || !std::isfinite(*v) || *v <= 0)
    throw spec_error(place(node), fmt::format("{} must be a number above 0", what));
  return *v;
}

std::int64_t toml_reader::as_whole_number(const toml::node &node, const std::string &what, std::int64_t least,
                                          std::int64_t most) const {
  const std::optional<std::int64_t> v = node.value_exact<std::int64_t>();
  if (!v || *v < least || *v > most)
    throw spec_error(place(node), fmt::format("{} must be a whole number from {} to {}", what, least, most));
  return *v;
}

bool toml_reader::as_bool(const toml::node &node, const std::string &what) const {
  if (!node.is_boolean())
    throw spec_error(place(node), fmt::format("{} must be true or false", what));
  return node.as_boolean()->get();
}

expr_source toml_reader::inside(const toml::node &node, const std::string &what) const {
  as_string(node, what);
  const location at = place(node);
  const std::string &text = file_->text;
  const std::size_t size = node.as_string()->get().size();
  if (text.compare(at.offset, 3, "'''") == 0) {
    std::size_t begin = at.offset + 3;
    if (text.compare(begin, 2, "\r\n") == 0)
      begin += 2;
    else if (text.compare(begin, 1, "\n") == 0)
      begin += 1;
    return {file_, begin, text.find("'''", begin)};
  }
  if (text.compare(at.offset, 1, "'") == 0)
    return {file_, at.offset + 1, at.offset + 1 + size};
  throw spec_error(at, fmt::format("{} must be a 'literal' string in single quotes", what));
}

expr_ptr toml_reader::as_expression(const toml::node &node, const std::string &what) const {
  return parse_expression(inside(node, what));
}

std::vector<std::pair<const toml::key *, const toml::node *>>
toml_reader::in_file_order(const toml::table &table) const {
  std::vector<std::pair<const toml::key *, const toml::node *>> out;
  for (auto it = table.cbegin(); it != table.cend(); ++it)
    out.emplace_back(&it->first, &it->second);
  std::stable_sort(out.begin(), out.end(), [](const auto &a, const auto &b) {
    const auto pa = a.first->source().begin, pb = b.first->source().begin;
    return std::pair(pa.line, pa.column) < std::pair(pb.line, pb.column);
  });
  return out;
}

void check_version(const toml_reader &in, const toml::table &table) {
  if (const toml::node *version = table.get("spec"); version && version->value<std::int64_t>() != 1)
    throw spec_error(in.place(*version), "this program reads the language 'spec = 1'; write that, or leave it out");
}

void need_name(const std::string &name, const location &at, const char *what) {
  if (!is_name(name))
    throw spec_error(
        at, fmt::format("'{}' is not a name for {}: letters, digits and '_', not starting with a digit", name, what));
}

} // namespace meetc::lang
