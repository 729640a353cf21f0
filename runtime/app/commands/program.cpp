#include "meet/app/commands/program.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/text/nearest.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <new>
#include <string_view>
#include <unistd.h>

namespace meetc::app {

namespace {

int complain(const std::string &what, int code) {
  std::fprintf(stderr, "meet: %s\n", what.c_str());
  return code;
}

// A reader that has closed the pipe (as head does) is not an error; a full disk is.
int print(const std::string &text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if ((written && std::fflush(stdout) == 0) || errno == EPIPE)
    return done;
  return complain(fmt::format("standard output: {}", std::generic_category().message(errno)), bad_input);
}

// If a program starts without its standard streams, the next files that it opens get their numbers. The streams are
// opened for reading only, so that writing to a closed stream still fails.
void open_standard_streams() {
  for (int fd = 0; fd < 3; ++fd)
    if (::fcntl(fd, F_GETFD) == -1)
      static_cast<void>(::open("/dev/null", O_RDONLY));
}

// Input files are mapped. If another program shortens one, reading the lost pages raises SIGBUS. The program may end at
// once, since no output has a name yet while inputs are read.
extern "C" void end_after_lost_page(int) noexcept {
  constexpr std::string_view what = "meet: a file became shorter while it was read\n";
  static_cast<void>(!::write(STDERR_FILENO, what.data(), what.size()));
  ::_exit(bad_input);
}

bool contains(const std::string &text, const char *part) {
  return text.find(part) != std::string::npos;
}

// Joins the names as in "collide, inspect, demo, bench", perhaps with another word before the last.
std::string names_of(const std::vector<command> &commands, std::string_view before_last = ", ") {
  std::string out;
  for (std::size_t i = 0; i < commands.size(); ++i)
    out += fmt::format("{}{}",
                       i == 0                     ? ""
                       : i + 1 == commands.size() ? before_last
                                                  : ", ",
                       commands[i].parser->get_name());
  return out;
}

std::vector<std::string> names_in(const std::vector<command> &commands) {
  std::vector<std::string> out;
  for (const command &c : commands)
    out.push_back(c.parser->get_name());
  return out;
}

// The option nearest to one that the parser does not have.
std::string nearest_option(const CLI::App &parser, std::string_view name) {
  std::vector<std::string> known;
  for (const CLI::Option *const o : parser.get_options())
    for (const std::string &one : o->get_lnames())
      known.push_back("--" + one);
  return nearest(name.substr(0, name.find('=')), known);
}

// The first option on the line that the parser does not have; empty: there is none.
std::string unknown_option(const CLI::App &parser) {
  for (const std::string &left : parser.remaining())
    if (left.size() > 1 && left.front() == '-')
      return left;
  return {};
}

const command *named(const std::vector<command> &commands, int argc, char **argv, int at) {
  for (const command &c : commands)
    if (argc > at && c.parser->get_name() == argv[at])
      return &c;
  return nullptr;
}

const command *parsed(const std::vector<command> &commands) {
  for (const command &c : commands)
    if (c.parser->parsed())
      return &c;
  return nullptr;
}

// CLI11's message, or a better one, on one line.
std::string in_one_line(const CLI::Error &e, const CLI::App &program, const std::vector<command> &commands, int argc,
                        char **argv) {
  const command *const of = named(commands, argc, argv, 1);
  std::string name = of ? of->parser->get_name() + " " : "";
  if (of && !of->parts.empty()) {
    const command *const part = named(of->parts, argc, argv, 2);
    if (!part)
      return fmt::format("meet {}: {}; known: {} (meet {} --help says more)", of->parser->get_name(),
                         argc < 3 ? of->part_is_missing
                                  : "unknown " + io::quote(argv[2]) + nearest(argv[2], names_in(of->parts)),
                         names_of(of->parts), of->parser->get_name());
    name += part->parser->get_name() + " ";
  }
  const std::string more = fmt::format("meet {}--help says more", name);
  if (!of && (argc < 2 || argv[1][0] == '-'))
    return fmt::format("a command is needed first: {}{} ({})", names_of(commands, " or "),
                       argc < 2 ? "" : nearest_option(program, argv[1]), more);
  if (!of)
    return fmt::format("unknown command {}{}; known: {} ({})", io::quote(argv[1]), nearest(argv[1], names_in(commands)),
                       names_of(commands), more);
  const CLI::App &parser = of->parts.empty() ? *of->parser : *named(of->parts, argc, argv, 2)->parser;
  if (const std::string option = unknown_option(parser); !option.empty())
    return fmt::format("not expected: {}{} ({})", io::error(option).what(), nearest_option(parser, option), more);
  std::string what = e.what();
  const std::string option = what.substr(0, what.find(':'));
  if (contains(what, "At Most 1 required"))
    what = option + ": given more than once";
  else if (contains(what, "1 required") && contains(what, "missing"))
    what = option + ": its value is missing";
  else if (contains(what, "not expected"))
    what = "not expected:" + what.substr(what.find(':') + 1);
  return fmt::format("{} ({})", io::error(what).what(), more);
}

int obey(int argc, char **argv, const std::vector<add_command> &add) {
  CLI::App parser("Find the touching elements of two sets, exactly: meshes, segments, spheres and boxes.", "meet");
  parser.set_version_flag("--version", "meet " MEETC_VERSION);
  parser.require_subcommand(1);
  std::vector<command> commands;
  for (const add_command &one : add)
    commands.push_back(one(parser));
  try {
    parser.parse(argc, argv);
  } catch (const CLI::CallForHelp &) {
    return print(parser.help());
  } catch (const CLI::CallForVersion &) {
    return print("meet " MEETC_VERSION "\n");
  } catch (const CLI::Error &e) {
    return complain(in_one_line(e, parser, commands, argc, argv), bad_input);
  }
  const command *given = parsed(commands);
  while (!given->parts.empty())
    given = parsed(given->parts);
  const printed out = given->run();
  const int code = print(out.text);
  return code == done ? out.code : code;
}

} // namespace

int run(int argc, char **argv, const std::vector<add_command> &commands) {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGBUS, end_after_lost_page);
  open_standard_streams();
  try {
    return obey(argc, argv, commands);
  } catch (const failure &e) {
    return complain(e.what(), e.code());
  } catch (const std::bad_alloc &) {
    return complain("not enough memory", bad_input);
  } catch (const std::length_error &) {
    return complain("not enough memory", bad_input);
  } catch (const std::exception &e) {
    return complain(e.what(), bad_input);
  }
}

} // namespace meetc::app
