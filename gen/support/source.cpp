#include "gen/support/source.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <numeric>
#include <sstream>

namespace meetc {

std::size_t location::line() const {
  const auto end = file->text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, file->text.size()));
  return 1 + static_cast<std::size_t>(std::count(file->text.begin(), end, '\n'));
}

std::size_t location::column() const {
  const std::size_t at = std::min(offset, file->text.size());
  const std::size_t start = at == 0 ? std::string::npos : file->text.rfind('\n', at - 1);
  return start == std::string::npos ? at + 1 : at - start;
}

std::string location::text() const {
  return fmt::format("{}:{}:{}", file->path, line(), column());
}

namespace {
std::string headline(const location &where, const char *as, const std::string &message) {
  return fmt::format("{}{}{}: {}", where ? where.text() : "", where ? ": " : "", as, message);
}
} // namespace

spec_error::spec_error(location where, const std::string &message)
    : std::runtime_error(headline(where, "error", message)), where_(std::move(where)), message_(message) {}

spec_error &spec_error::add_step(std::string what, location at) {
  trail_.push_back({std::move(what), std::move(at)});
  return *this;
}

std::string spec_error::render(const char *as) const {
  std::string out = headline(where_, as, message_);
  out += '\n';
  if (where_) {
    const std::string &text = where_.file->text;
    const std::size_t column = where_.column();
    const std::size_t start = where_.offset + 1 - column;
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::string source = text.substr(start, end - start);
    // Columns count bytes, but carets are drawn under characters.
    const auto starts = [&](std::size_t i) { return (source[i] & 0xc0) != 0x80; };
    std::string pad;
    for (std::size_t i = 0; i + 1 < column && i < source.size(); ++i)
      if (starts(i))
        pad += source[i] == '\t' ? '\t' : ' ';
    std::size_t width = 0;
    for (std::size_t i = column - 1; i < source.size() && i < column - 1 + where_.length; ++i)
      width += starts(i);
    width = std::max<std::size_t>(1, width);
    out += fmt::format("  {}\n  {}^{}\n", source, pad, std::string(width - 1, '~'));
  }
  for (const trail_step &step : trail_)
    out += step.where ? fmt::format("  in {}, at {}\n", step.what, step.where.text())
                      : fmt::format("  in {}\n", step.what);
  return out;
}

std::shared_ptr<const source_file> read_source(const std::string &path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw spec_error({}, fmt::format("{}: is a folder, not a file", path));
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()).good()) {
    if (in && in.peek() == std::ifstream::traits_type::eof())
      return std::make_shared<source_file>(source_file{path, ""});
    throw spec_error({}, fmt::format("{}: cannot be read", path));
  }
  return std::make_shared<source_file>(source_file{path, text.str()});
}

std::string nearest(std::string_view name, const std::vector<std::string> &known) {
  std::string best;
  std::size_t best_distance = name.size() / 2 + 1;
  for (const std::string &other : known) {
    std::vector<std::size_t> row(other.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= name.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= other.size(); ++j) {
        const std::size_t above = row[j];
        row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (name[i - 1] == other[j - 1] ? 0 : 1)});
        diagonal = above;
      }
    }
    if (row.back() < best_distance) {
      best_distance = row.back();
      best = other;
    }
  }
  return best.empty() ? "" : fmt::format("; did you mean '{}'?", best);
}

std::string join(const std::vector<std::string> &parts, std::string_view between) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i)
    out.append(i ? between : std::string_view{}).append(parts[i]);
  return out;
}

} // namespace meetc
