// Writes a file either whole or not at all.
#ifndef MEETC_IO_FILES_ATOMIC_FILE_HPP
#define MEETC_IO_FILES_ATOMIC_FILE_HPP

#include "meet/io/files/error.hpp"

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string_view>

namespace meetc::io {

// Bytes go to a temporary file in the target's folder. commit() renames it over the target; without commit() the
// destructor removes it. A target that exists and is not a regular file (a terminal, a pipe) is written directly. A
// symbolic link is followed, so it stays a link. Throws io::error that names the target.
class atomic_file {
public:
  explicit atomic_file(std::filesystem::path target);
  ~atomic_file();
  atomic_file(const atomic_file &) = delete;
  atomic_file &operator=(const atomic_file &) = delete;

  void write(std::string_view bytes);
  // For a library that writes to a C stream. commit() reports its errors. The caller must not close it.
  std::FILE *stream() const { return stream_; }
  void commit();

private:
  [[noreturn]] void fail(const char *what, int code) const;

  std::filesystem::path target_, temporary_; // temporary_ is empty where the target is written directly
  std::FILE *stream_ = nullptr;
};

// Writes the whole file at once. Throws io::error that names the target.
void write_file(const std::filesystem::path &target, std::string_view bytes);

} // namespace meetc::io

#endif
