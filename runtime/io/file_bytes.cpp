#include "io/file_bytes.hpp"

#include "io/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace meetc::io {

namespace {

std::string reason(int code) {
  return std::system_category().message(code);
}

struct closer {
  void operator()(std::FILE *f) const { std::fclose(f); }
};

} // namespace

file_bytes load_file(const std::filesystem::path &path) {
  namespace fs = std::filesystem;
  file_bytes out;
  out.name = path.string();
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found)
    throw error(fmt::format("{}: no such file", out.name));
  if (status.type() == fs::file_type::directory)
    throw error(fmt::format("{}: is a directory", out.name));
  if (status.type() == fs::file_type::none || status.type() == fs::file_type::unknown)
    throw error(fmt::format("{}: cannot be read: {}", out.name, code.message()));
  if (status.type() != fs::file_type::regular)
    throw error(fmt::format("{}: is not a regular file", out.name));
  const auto size = fs::file_size(path, code);
  if (code)
    throw error(fmt::format("{}: cannot be read: {}", out.name, code.message()));

  errno = 0;
  const std::unique_ptr<std::FILE, closer> file(std::fopen(path.c_str(), "rb"));
  if (!file)
    throw error(fmt::format("{}: cannot be opened: {}", out.name, reason(errno)));
  if (size == 0)
    throw error(fmt::format("{}: the file is empty", out.name));
  out.bytes = std::make_unique_for_overwrite<char[]>(size);
  out.size = std::fread(out.bytes.get(), 1, size, file.get());
  if (out.size != size)
    throw error(fmt::format("{}: byte {}: cannot be read: {}", out.name, out.size,
                            std::ferror(file.get()) ? reason(errno) : "the file became shorter"));
  return out;
}

} // namespace meetc::io
