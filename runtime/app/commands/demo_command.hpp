// app/commands/demo_command.hpp: `meet demo`: every kind of answer on procedural bodies, as a table and as pictures.
#ifndef MEETC_APP_COMMANDS_DEMO_COMMAND_HPP
#define MEETC_APP_COMMANDS_DEMO_COMMAND_HPP

#include "meet/app/commands/command.hpp"
#include "meetc/support.hpp"

#include <filesystem>
#include <string>

namespace meetc::app {

// Writes into the folder, which is created if it is missing, and returns the text for standard output. Throws
// io::error.
std::string demo(const catalogue &all, const std::filesystem::path &folder, int threads);

// The command and its options. The catalogue must outlive it.
command add_demo(CLI::App &program, const catalogue &all);

} // namespace meetc::app

#endif
