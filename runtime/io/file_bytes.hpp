// A whole file in memory.
#ifndef MEETC_IO_FILE_BYTES_HPP
#define MEETC_IO_FILE_BYTES_HPP

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace meetc::io {

struct file_bytes {
  std::string name; // as messages show it
  std::unique_ptr<char[]> bytes;
  std::size_t size = 0;

  std::string_view text() const { return {bytes.get(), size}; }
};

// Copies the file instead of mapping it: if another program shortens a mapped file, a signal ends this one. Throws
// io::error for a file that is missing, not a regular file, empty or unreadable; reading a device or a pipe might never
// end.
file_bytes load_file(const std::filesystem::path &path);

} // namespace meetc::io

#endif
