// app/commands/self_command.hpp: `meet collide --self` finds where one mesh crosses itself.
#ifndef MEETC_APP_COMMANDS_SELF_COMMAND_HPP
#define MEETC_APP_COMMANDS_SELF_COMMAND_HPP

#include "meet/app/commands/collide_command.hpp"

namespace meetc::app {

// Writes the requested files and returns the text for standard output. `neighbours` has the predicates of faces with common
// corners. Throws io::error.
printed collide_self(const catalogue &all, const catalogue &neighbours, const collide_request &request);

} // namespace meetc::app

#endif
