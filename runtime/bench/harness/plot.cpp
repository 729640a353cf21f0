#include "meet/bench/harness/plot.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/picture/palette.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

extern char **environ;

namespace meetc::bench {

std::string_view script_of_plot(std::string_view name); // plots.cpp, which CMake writes from plots/*.gp

namespace {

// A text as a string of a script, on one line: in single quotes, in which nothing is replaced, with those of the text between
// double ones.
std::string gnuplot_string(std::string_view text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' ? std::string("'.\"'\".'") : std::string(1, static_cast<unsigned char>(c) < ' ' ? ' ' : c);
  return out + '\'';
}

// Runs gnuplot with one option, its input and its output, and returns its exit status; 127 where it cannot be started, as
// in a shell.
int run(const char *option, int input, int output) {
  posix_spawn_file_actions_t streams;
  ::posix_spawn_file_actions_init(&streams);
  ::posix_spawn_file_actions_adddup2(&streams, input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&streams, output, STDOUT_FILENO);
  ::posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const char *const words[] = {"gnuplot", option, nullptr};
  pid_t program = -1;
  const int error = ::posix_spawnp(&program, words[0], &streams, nullptr, const_cast<char *const *>(words), environ);
  ::posix_spawn_file_actions_destroy(&streams);
  int status = 0;
  while (error == 0 && ::waitpid(program, &status, 0) < 0)
    if (errno != EINTR)
      return 127;
  return error != 0 ? 127 : WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

using open_file = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

open_file opened(const char *path, const char *how) {
  return {std::fopen(path, how), std::fclose};
}

} // namespace

void need_gnuplot() {
  const open_file nothing = opened("/dev/null", "r+e");
  if (!nothing || run("--version", ::fileno(nothing.get()), ::fileno(nothing.get())) != 0)
    throw app::failure("-o: gnuplot was not found, which draws the charts (on Debian, the package gnuplot-nox)");
}

plot::plot(std::string_view script) : script_(script_of_plot(script)) {}

plot &plot::set(std::string_view variable, double value) {
  values_ += fmt::format("{} = {:.17g}\n", variable, value);
  return *this;
}

plot &plot::set(std::string_view variable, std::string_view text) {
  values_ += fmt::format("{} = {}\n", variable, gnuplot_string(text));
  return *this;
}

plot &plot::list(std::string_view variable, const std::vector<std::string> &texts) {
  values_ += fmt::format("array {}[{}]\n", variable, texts.empty() ? 1 : texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i)
    values_ += fmt::format("{}[{}] = {}\n", variable, i + 1, gnuplot_string(texts[i]));
  return *this;
}

plot &plot::data(std::string_view block, const std::vector<std::string> &sections) {
  values_ += fmt::format("${} << END\n", block);
  for (const std::string &section : sections)
    values_ += (section.empty() ? "NaN NaN NaN NaN\n" : section) + "\n\n";
  values_ += "END\n";
  return *this;
}

void plot::draw(const std::filesystem::path &to) const {
  const open_file file = opened(to.c_str(), "we"), script = {std::tmpfile(), std::fclose};
  if (!file || !script)
    throw app::failure(fmt::format("{}: cannot be written: {}", to.string(), std::generic_category().message(errno)));
  namespace palette = picture::palette;
  for (const auto &[variable, c] : {std::pair("paper", palette::paper), std::pair("ink", palette::ink),
                                    std::pair("line", palette::line), std::pair("thin_line", palette::thin_line)})
    fmt::print(script.get(), "{} = '{}'\n", variable, picture::hexadecimal(c));
  std::fputs(values_.c_str(), script.get());
  std::fwrite(script_.data(), 1, script_.size(), script.get());
  std::rewind(script.get());
  const int status = run("--default-settings", ::fileno(script.get()), ::fileno(file.get()));
  if (status == 127)
    need_gnuplot();
  std::error_code code;
  if (status != 0 || std::filesystem::file_size(to, code) == 0 || code)
    throw app::failure(fmt::format("{}: gnuplot could not draw it", to.string()));
}

} // namespace meetc::bench
