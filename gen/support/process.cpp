#include "gen/support/process.hpp"

#include "gen/support/source.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace meetc {

finished_process run_process(const std::vector<std::string> &words) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
    throw spec_error({}, words.at(0) + ": cannot be run: no pipe can be made");
  posix_spawn_file_actions_t streams;
  ::posix_spawn_file_actions_init(&streams);
  ::posix_spawn_file_actions_adddup2(&streams, pipe[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&streams, pipe[1], STDERR_FILENO);
  std::vector<char *> arguments;
  for (const std::string &w : words)
    arguments.push_back(const_cast<char *>(w.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, arguments[0], &streams, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&streams);
  ::close(pipe[1]);
  finished_process out;
  std::array<char, 4096> text{};
  for (ssize_t n = 0; !failed && (n = ::read(pipe[0], text.data(), text.size())) != 0;)
    if (n > 0)
      out.said.append(text.data(), static_cast<std::size_t>(n));
    else if (errno != EINTR)
      break;
  ::close(pipe[0]);
  if (failed) {
    out.code = 127;
    return out;
  }
  int status = 0;
  rusage used{};
  while (::wait4(child, &status, 0, &used) < 0)
    if (errno != EINTR)
      return out;
  const auto seconds = [](const timeval &t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  out.seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return out;
}

} // namespace meetc
