#include "meet/io/files/atomic_file.hpp"

#include "meetc/environment/control_word.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace meetc::io {

namespace fs = std::filesystem;

atomic_file::atomic_file(fs::path target) : target_(std::move(target)) {
  const control_word_guard guard; // std::filesystem computes the room for a path's parts in floating point
  struct stat info {};
  const bool exists = ::stat(target_.c_str(), &info) == 0;
  if (exists && S_ISDIR(info.st_mode))
    fail("is a directory, not a file to write", 0);
  int descriptor = -1;
  if (exists && !S_ISREG(info.st_mode)) {
    descriptor = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    std::error_code code;
    if (const fs::path real = fs::is_symlink(target_, code) ? fs::canonical(target_, code) : fs::path();
        !code && !real.empty())
      target_ = real;
    static std::atomic<unsigned> counter{0};
    do { // names left over by a killed program are skipped
      temporary_ = target_.parent_path() / fmt::format(".meet-{}-{}.tmp", ::getpid(), counter++);
      descriptor = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
  }
  if (descriptor < 0) {
    const int code = errno;
    temporary_.clear();
    fail("cannot be written", code);
  }
  // A replaced file keeps its mode, or gets the usual one if the system refuses that.
  if (exists && !temporary_.empty())
    static_cast<void>(::fchmod(descriptor, info.st_mode & 07777));
  stream_ = ::fdopen(descriptor, "wb");
  if (!stream_) {
    const int code = errno;
    ::close(descriptor);
    if (!temporary_.empty())
      ::unlink(temporary_.c_str());
    fail("cannot be written", code);
  }
}

atomic_file::~atomic_file() {
  if (stream_)
    std::fclose(stream_);
  if (!temporary_.empty())
    ::unlink(temporary_.c_str());
}

void atomic_file::write(std::string_view bytes) {
  if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size())
    fail("cannot be written", errno);
}

void atomic_file::commit() {
  errno = 0;
  const bool earlier = std::ferror(stream_) != 0;
  const bool flushed = std::fflush(stream_) == 0;
  int code = errno;
  const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
  if (flushed && !closed)
    code = errno;
  if (earlier || !flushed || !closed)
    fail("cannot be written", code);
  if (temporary_.empty())
    return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail("cannot be written", errno);
  temporary_.clear();
}

void write_file(const std::filesystem::path &target, std::string_view bytes) {
  under_standard_word([&] {
    atomic_file file(target);
    file.write(bytes);
    file.commit();
  });
}

void atomic_file::fail(const char *what, int code) const {
  const std::string reason = code == 0 ? "" : ": " + std::system_category().message(code);
  throw error(fmt::format("{}: {}{}", target_.string(), what, reason));
}

} // namespace meetc::io
