// app/commands/command.hpp: a command as the program sees it.
#ifndef MEETC_APP_COMMANDS_COMMAND_HPP
#define MEETC_APP_COMMANDS_COMMAND_HPP

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

namespace meetc::app {

// The text for standard output, and the exit code where it can be written.
struct printed {
  std::string text;
  int code = 0;
  printed(std::string t, int c = 0) : text(std::move(t)), code(c) {} // NOLINT: most commands have a text alone
};

struct command {
  CLI::App *parser = nullptr;
  std::function<printed()> run;     // empty where there are subcommands
  std::vector<command> parts = {};  // subcommands, of which one must be given
  std::string part_is_missing = {}; // the message where none is given
};

// Adds a command and its options to the program's parser, which the command must not outlive.
using add_command = std::function<command(CLI::App &program)>;

} // namespace meetc::app

#endif
