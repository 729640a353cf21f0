// The bytes of a whole file, mapped where it can be mapped.
#ifndef MEETC_IO_FILES_FILE_BYTES_HPP
#define MEETC_IO_FILES_FILE_BYTES_HPP

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace meetc::io {

struct file_bytes {
  std::string name;                  // as messages show it
  std::shared_ptr<const char> bytes; // unmapped or freed with the last copy
  std::size_t size = 0;

  std::string_view text() const { return {bytes.get(), size}; }
};

// The name of standard input; "./-" is a file.
inline constexpr const char *standard_input = "-";

// Whether a path leads to standard input: "-", or a name such as /dev/stdin of the same open file.
bool is_standard_input(const std::filesystem::path &path);

// Maps a regular file. Reads standard input and pipes that are open already (/dev/fd/N) to their end, since these
// cannot be mapped. If another program shortens a mapped file, the system sends SIGBUS to this one; the program `meet`
// makes a message of it. Throws io::error for a file that is missing, empty or unreadable, a folder, a device, or a
// pipe by a name, which might wait for ever.
file_bytes load_file(const std::filesystem::path &path);

} // namespace meetc::io

#endif
