#include "meet/io/read.hpp"

#include "meet/core/threads/threads.hpp"
#include "meet/io/elements/readers.hpp"
#include "meet/io/mesh/mesh.hpp"
#include "meet/io/text/number.hpp"
#include "meet/io/text/text.hpp"
#include <meetc/environment/control_word.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace meetc::io {

namespace {

struct format_entry {
  file_format format;
  std::string_view name;
  element_set (*read)(const file_bytes &, const read_request &);
  const char *item; // the format's word for an element of a mesh
};

constexpr format_entry formats[] = {{file_format::ply, "ply", read_ply, "face"},
                                    {file_format::obj, "obj", read_obj, "face"},
                                    {file_format::off, "off", read_off, "face"},
                                    {file_format::stl, "stl", read_stl, "facet"},
                                    {file_format::csv, "csv", read_csv, nullptr}};

// ".ply, .obj"
std::string list(std::string_view before) {
  std::string out;
  for (const format_entry &f : formats)
    out += fmt::format("{}{}{}", out.empty() ? "" : ", ", before, f.name);
  return out;
}

const format_entry *entry_named(std::string_view name) {
  const auto found = std::ranges::find(formats, name, &format_entry::name);
  return found == std::end(formats) ? nullptr : found;
}

// The format by the first bytes. A binary STL may begin with any bytes, but its size follows from its count.
const format_entry &entry_of(const file_bytes &file, char side) {
  const std::string_view text = file.text();
  const std::string start = lower_case(text.substr(0, 6));
  const auto begins = [&](std::string_view word) {
    return start.starts_with(word) && (start.size() == word.size() || start[word.size()] <= ' ');
  };
  if (begins("ply"))
    return *entry_named("ply");
  if (begins("off") || begins("coff"))
    return *entry_named("off");
  std::uint32_t count = 0;
  if (file.size >= 84)
    std::copy_n(file.bytes.get() + 80, 4, reinterpret_cast<char *>(&count));
  if (begins("solid") || (file.size >= 84 && file.size == 84 + std::size_t{50} * count))
    return *entry_named("stl");
  throw error(
      fmt::format("{}: its first bytes tell no format; name it with --format-{} {}", file.name, side, list("")));
}

const format_entry &entry_for(const std::filesystem::path &path, const read_options &how) {
  if (how.format)
    return formats[static_cast<std::size_t>(*how.format)];
  const std::string name = path.string(), extension = lower_case(path.extension().string());
  if (const format_entry *const found =
          extension.empty() ? nullptr : entry_named(std::string_view(extension).substr(1)))
    return *found;
  throw error(fmt::format("{}: {}; supported: {}", name,
                          extension.empty() ? "the name has no extension"
                                            : fmt::format("unknown extension {}", quote(extension)),
                          list(".")));
}

element_set dispatch(const std::filesystem::path &path, std::span<const kind_info *const> kinds,
                     const read_options &how) {
  const char side = how.move.side;
  const bool by_bytes = !how.format && is_standard_input(path);
  const format_entry *by = by_bytes ? nullptr : &entry_for(path, how);
  read_request q{kinds, how.kind, side, {thread_count(how.threads), how.piece_bytes}};
  if (!how.kind.empty() && !q.named(how.kind)) {
    std::string known;
    for (const kind_info *const k : kinds)
      known += fmt::format("{}{}", known.empty() ? "" : ", ", k->name);
    throw error(fmt::format("--kind-{} {}: unknown; known: {}", side, quote(how.kind), known));
  }
  const file_bytes file = load_file(path);
  if (by_bytes)
    by = &entry_of(file, side);
  element_set set = by->read(file, q);
  if (const std::optional<misplaced> fault = move_set(set, how.move, file.name, q.by.threads)) {
    q.fault = &*fault;
    by->read(file, q);
    throw error(fmt::format("{}: {}", file.name, fault->what)); // the reader has told the place already
  }
  if (by->item)
    check_rules(set, file.name, by->item);
  return set;
}

} // namespace

file_format format_named(std::string_view option, std::string_view name) {
  if (const format_entry *const found = entry_named(name))
    return found->format;
  throw error(fmt::format("{} {}: unknown; known: {}", option, quote(name), list("")));
}

const kind_info &read_request::need(const std::string &file, std::string_view name, int points, int fields) const {
  const kind_info *const found = named(name);
  if (found && found->points == points && found->fields == fields)
    return *found;
  throw error(fmt::format("{}: a mesh needs a kind '{}' of {} point{}, and there is none", file, name,
                          points == 3   ? "three"
                          : points == 2 ? "two"
                                        : "one",
                          points == 1 ? "" : "s"));
}

std::string describe_non_finite_point(const float *p, const std::array<std::string_view, 3> &words) {
  for (std::size_t c = 0; c < 3; ++c)
    if (!words[c].empty() && !std::isfinite(p[c])) {
      double read = 0;
      parse_decimal(words[c], precision::float64, read);
      return describe_non_finite(std::string_view("xyz").substr(c, 1), read, p[c]);
    }
  return {};
}

element_set read(const std::filesystem::path &path, std::span<const kind_info *const> kinds, const read_options &how) {
  return under_standard_word([&] {
    how.move.check();
    try {
      return dispatch(path, kinds, how);
    } catch (const std::bad_alloc &) {
      throw error(fmt::format("{}: not enough memory to read it", path.string()));
    } catch (const std::length_error &) {
      throw error(fmt::format("{}: not enough memory to read it", path.string()));
    }
  });
}

} // namespace meetc::io
