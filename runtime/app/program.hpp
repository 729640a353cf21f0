// app/program.hpp: the command line of `meet`, whatever its commands are.
#ifndef MEETC_APP_PROGRAM_HPP
#define MEETC_APP_PROGRAM_HPP

#include "app/command.hpp"

#include <vector>

namespace meetc::app {

// Does what the arguments ask for. Returns the exit code: 0 done, 2 bad usage or input, 3 device failure.
// Whatever is wrong is one line on standard error.
int run(int argc, char **argv, const std::vector<add_command> &commands);

} // namespace meetc::app

#endif
