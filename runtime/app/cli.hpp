// app/cli.hpp: the command line of `meet`.
#ifndef MEETC_APP_CLI_HPP
#define MEETC_APP_CLI_HPP

namespace meetc::app {

// Does what the arguments ask for. Returns the exit code: 0 done, 2 bad usage or input, 3 device failure.
// Whatever is wrong is one line on standard error.
int run(int argc, char **argv);

} // namespace meetc::app

#endif
