// app/commands/bodies_options.hpp: the options of `meet collide` for many bodies.
#ifndef MEETC_APP_COMMANDS_BODIES_OPTIONS_HPP
#define MEETC_APP_COMMANDS_BODIES_OPTIONS_HPP

#include "meet/app/world/collide_bodies.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace meetc::app {

// The options' values as they are on the command line.
struct bodies_arguments {
  std::optional<std::filesystem::path> world, poses, srdf;
  std::vector<std::filesystem::path> more; // after A and B
  std::vector<std::string> allowed;
  std::optional<std::string> only;
  bool bodies = false; // two files are bodies too

  bool many() const { return world || !more.empty() || bodies; }
};

void add_bodies(CLI::App &c, bodies_arguments &to);

// Throws failure for an option that was given and that is for another number of bodies.
void require_fit(const CLI::App &c, const bodies_arguments &given);

// The bodies, their poses and the pairs that are asked about. Throws failure that names the option.
bodies_request bodies_named(const bodies_arguments &given, const std::filesystem::path &a,
                            const std::filesystem::path &b);

} // namespace meetc::app

#endif
