#include "bench/harness/gnuplot.hpp"

#include "app/failure.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

extern char **environ;

namespace meetc::bench {

namespace {

// The standard streams with which the program starts, redirected to files.
class streams {
public:
  streams() { ::posix_spawn_file_actions_init(&actions_); }
  ~streams() { ::posix_spawn_file_actions_destroy(&actions_); }
  streams(const streams &) = delete;
  streams &operator=(const streams &) = delete;

  void open(int stream, const char *path, int flags) {
    ::posix_spawn_file_actions_addopen(&actions_, stream, path, flags, 0666);
  }
  void take(int stream, int from) { ::posix_spawn_file_actions_adddup2(&actions_, from, stream); }
  const posix_spawn_file_actions_t *get() const { return &actions_; }

private:
  posix_spawn_file_actions_t actions_;
};

class descriptor {
public:
  explicit descriptor(int fd) : fd_(fd) {}
  ~descriptor() { close(); }
  descriptor(const descriptor &) = delete;
  descriptor &operator=(const descriptor &) = delete;

  int get() const { return fd_; }
  void close() {
    if (fd_ >= 0)
      ::close(fd_);
    fd_ = -1;
  }

private:
  int fd_;
};

// The exit status; 127 where the program cannot be started, as in a shell.
int finish(pid_t program) {
  int status = 0;
  while (::waitpid(program, &status, 0) < 0)
    if (errno != EINTR)
      return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

pid_t start(const char *option, const streams &with) {
  pid_t program = -1;
  const char *const words[] = {"gnuplot", option, nullptr};
  const int error = ::posix_spawnp(&program, words[0], with.get(), nullptr, const_cast<char *const *>(words), environ);
  return error == 0 ? program : -1;
}

} // namespace

std::string gnuplot_string(const std::string &text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' ? std::string("''") : std::string(1, static_cast<unsigned char>(c) < ' ' ? ' ' : c);
  return out + '\'';
}

void need_gnuplot() {
  streams s;
  s.open(STDIN_FILENO, "/dev/null", O_RDONLY);
  s.open(STDOUT_FILENO, "/dev/null", O_WRONLY);
  s.open(STDERR_FILENO, "/dev/null", O_WRONLY);
  const pid_t program = start("--version", s);
  if (program < 0 || finish(program) != 0)
    throw app::failure("-o: gnuplot was not found, which draws the charts (on Debian, the package gnuplot-nox)");
}

void run_gnuplot(const std::string &script, const std::filesystem::path &to) {
  const auto refuse = [&to](const char *what) {
    throw app::failure(fmt::format("{}: {}: {}", to.string(), what, std::generic_category().message(errno)));
  };
  const descriptor file(::open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.get() < 0)
    refuse("cannot be written");
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    refuse("cannot be drawn");
  // The reading end of gnuplot's input stays open here until all is written, so that a broken pipe raises no signal.
  descriptor read(ends[0]), write(ends[1]);
  streams s;
  s.take(STDIN_FILENO, read.get());
  s.take(STDOUT_FILENO, file.get());
  s.open(STDERR_FILENO, "/dev/null", O_WRONLY);
  const pid_t program = start("--default-settings", s);
  if (program < 0) {
    need_gnuplot();
    throw app::failure(fmt::format("{}: gnuplot could not be started", to.string()));
  }
  for (std::size_t done = 0; done < script.size();) {
    const ssize_t n = ::write(write.get(), script.data() + done, script.size() - done);
    if (n < 0 && errno != EINTR)
      break;
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  write.close();
  read.close();
  std::error_code code;
  if (finish(program) != 0 || std::filesystem::file_size(to, code) == 0 || code)
    throw app::failure(fmt::format("{}: gnuplot could not draw it", to.string()));
}

} // namespace meetc::bench
