#include "meet/io/files/file_bytes.hpp"

#include "meet/io/files/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace meetc::io {

namespace {

std::string reason(int code) {
  return std::system_category().message(code);
}

struct descriptor {
  int number = -1;
  bool owned = false;
  descriptor(int n, bool own) : number(n), owned(own) {}
  ~descriptor() {
    if (owned)
      ::close(number);
  }
  descriptor(const descriptor &) = delete;
  descriptor &operator=(const descriptor &) = delete;
};

// Reads to the end, whatever the size that the system reports.
void read_whole(int from, file_bytes &out) {
  std::size_t capacity = 1 << 16;
  std::unique_ptr<char[]> bytes = std::make_unique_for_overwrite<char[]>(capacity);
  for (;;) {
    if (out.size == capacity) {
      std::unique_ptr<char[]> more = std::make_unique_for_overwrite<char[]>(2 * capacity);
      std::copy_n(bytes.get(), out.size, more.get());
      bytes = std::move(more);
      capacity *= 2;
    }
    const ssize_t got = ::read(from, bytes.get() + out.size, capacity - out.size);
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      throw error(fmt::format("{}: byte {}: cannot be read: {}", out.name, out.size, reason(errno)));
    if (got == 0)
      break;
    out.size += static_cast<std::size_t>(got);
  }
  out.bytes = std::shared_ptr<const char>(bytes.release(), [](const char *p) { delete[] p; });
}

// Whether a file that is not regular can be read: it is open already, so that opening it does not wait, and it ends.
bool may_end(const std::filesystem::path &path, mode_t mode) {
  const bool standard = is_standard_input(path);
  if (S_ISCHR(mode))
    return standard && ::isatty(STDIN_FILENO) == 1;
  return (S_ISFIFO(mode) || S_ISSOCK(mode)) &&
         (standard || path.parent_path() == "/dev/fd" || path.parent_path() == "/proc/self/fd");
}

bool map_whole(int from, std::size_t size, file_bytes &out) {
  void *const at = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, from, 0);
  if (at == MAP_FAILED)
    return false;
  out.size = size;
  out.bytes = std::shared_ptr<const char>(static_cast<const char *>(at), [size](const char *p) {
    ::munmap(const_cast<char *>(p), size); // NOLINT(cppcoreguidelines-pro-type-const-cast)
  });
  return true;
}

} // namespace

bool is_standard_input(const std::filesystem::path &path) {
  for (const char *const name : {standard_input, "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"})
    if (path == name)
      return true;
  struct stat there {
  }, here{};
  return ::stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode) && ::fstat(STDIN_FILENO, &here) == 0 &&
         there.st_dev == here.st_dev && there.st_ino == here.st_ino;
}

file_bytes load_file(const std::filesystem::path &path) {
  file_bytes out;
  const bool standard = path == standard_input;
  out.name = standard ? "standard input" : path.string();
  struct stat info {};
  const auto check = [&out](int code) {
    if (code == 0)
      return;
    const int why = errno;
    throw error(why == ENOENT || why == ENOTDIR ? fmt::format("{}: no such file", out.name)
                                                : fmt::format("{}: cannot be read: {}", out.name, reason(why)));
  };
  // A pipe or a device must not be opened before it is known to be good, since that may wait.
  check(standard ? ::fstat(STDIN_FILENO, &info) : ::stat(path.c_str(), &info));
  if (S_ISDIR(info.st_mode))
    throw error(fmt::format("{}: is a directory", out.name));
  if (!S_ISREG(info.st_mode) && !may_end(path, info.st_mode))
    throw error(fmt::format("{}: is not a regular file", out.name));
  errno = 0;
  const descriptor file(standard ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC), !standard);
  if (file.number < 0)
    throw error(fmt::format("{}: cannot be opened: {}", out.name, reason(errno)));
  const auto size = static_cast<std::size_t>(std::max<off_t>(info.st_size, 0));
  // Standard input may be a regular file of which another program has read a part.
  const bool whole = S_ISREG(info.st_mode) && size > 0 && (!standard || ::lseek(STDIN_FILENO, 0, SEEK_CUR) == 0);
  if (!whole || !map_whole(file.number, size, out))
    read_whole(file.number, out);
  if (out.size == 0)
    throw error(fmt::format("{}: the file is empty", out.name));
  return out;
}

} // namespace meetc::io
