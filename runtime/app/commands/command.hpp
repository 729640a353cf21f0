// app/commands/command.hpp: a command as the program sees it.
#ifndef MEETC_APP_COMMANDS_COMMAND_HPP
#define MEETC_APP_COMMANDS_COMMAND_HPP

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace meetc::app {

struct command {
  CLI::App *parser = nullptr;
  std::function<std::string()> run; // returns the text for standard output; empty where there are subcommands
  std::vector<command> parts = {};  // subcommands, of which one must be given
  std::string part_is_missing = {}; // the message where none is given
};

// Adds a command and its options to the program's parser, which the command must not outlive.
using add_command = std::function<command(CLI::App &program)>;

} // namespace meetc::app

#endif
