// app/cli.hpp: the command line of `meet`.
#ifndef MEET_APP_CLI_HPP
#define MEET_APP_CLI_HPP

namespace meet::app {

// Does what the arguments ask for. Returns the exit code: 0 done, 2 bad usage or input, 3 device failure.
// Whatever is wrong is one line on standard error.
int run(int argc, char **argv);

} // namespace meet::app

#endif
