// app/commands/demo_scenes.hpp: procedural pairs of sets, one for each kind of answer.
#ifndef MEETC_APP_COMMANDS_DEMO_SCENES_HPP
#define MEETC_APP_COMMANDS_DEMO_SCENES_HPP

#include "meet/io/elements/element_set.hpp"
#include "meetc/support.hpp"

#include <string>
#include <vector>

namespace meetc::app {

struct demo_scene {
  std::string name, name_a, name_b;
  io::element_set a, b;
};

// The bytes are the same on every machine.
std::vector<demo_scene> demo_scenes(const catalogue &all);

} // namespace meetc::app

#endif
