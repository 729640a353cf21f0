// app/commands/inspect_command.hpp: `meet inspect` describes one file or two: elements, box, grid, degenerate elements, the
// predicates that fit, and the scene that two files require.
#ifndef MEETC_APP_COMMANDS_INSPECT_COMMAND_HPP
#define MEETC_APP_COMMANDS_INSPECT_COMMAND_HPP

#include "meet/app/commands/command.hpp"
#include "meet/io/read.hpp"
#include "meetc/support.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meetc::app {

struct inspect_request {
  std::filesystem::path a;
  std::optional<std::filesystem::path> b; // none: A alone is described
  io::read_options read_a, read_b;
  std::optional<std::filesystem::path> scene, algebra;
  double tolerance = 0; // of the scene; 0: none
};

// Returns the text for standard output. Throws io::error.
std::string inspect(const catalogue &all, const inspect_request &request);

// The command and its options. The catalogue must outlive it.
command add_inspect(CLI::App &program, const catalogue &all);

} // namespace meetc::app

#endif
