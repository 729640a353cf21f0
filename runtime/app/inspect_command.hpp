// app/inspect_command.hpp: `meet inspect`: what two files hold, what may be hard about them, and the scene
// that they require.
#ifndef MEET_APP_INSPECT_COMMAND_HPP
#define MEET_APP_INSPECT_COMMAND_HPP

#include "meet/support.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meet::app {

struct inspect_request {
  std::filesystem::path a, b;
  std::optional<std::filesystem::path> scene, algebra;
};

// Returns what goes to standard output. Throws io::error.
std::string inspect(const catalogue &all, const inspect_request &request);

} // namespace meet::app

#endif
