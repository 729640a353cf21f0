// app/commands/program.hpp: the command line of `meet`, for any commands.
#ifndef MEETC_APP_COMMANDS_PROGRAM_HPP
#define MEETC_APP_COMMANDS_PROGRAM_HPP

#include "meet/app/commands/command.hpp"

#include <vector>

namespace meetc::app {

// Runs the command that the arguments name. Returns the exit code: 0 done, 2 bad usage or input, 3 device failure. An
// error is one line on standard error.
int run(int argc, char **argv, const std::vector<add_command> &commands);

} // namespace meetc::app

#endif
