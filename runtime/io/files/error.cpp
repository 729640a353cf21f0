#include "meet/io/files/error.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace meetc::io {

namespace {

// Escapes control characters, and bytes above ASCII only if asked to, since a path may well be UTF-8.
std::string escape(std::string_view text, bool ascii_only) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f || (ascii_only && byte > 0x7e))
      out += fmt::format("\\x{:02x}", byte);
    else
      out += c;
  }
  return out;
}

} // namespace

error::error(std::string_view message) : std::runtime_error(escape(message, false)) {}

std::string quote(std::string_view token) {
  constexpr std::size_t longest = 40;
  const bool cut = token.size() > longest;
  return fmt::format("'{}{}'", escape(token.substr(0, longest), true), cut ? "..." : "");
}

} // namespace meetc::io
