// app/world/bodies_answer.hpp: the bodies of a command, and what is found of them, in words and as JSON.
#ifndef MEETC_APP_WORLD_BODIES_ANSWER_HPP
#define MEETC_APP_WORLD_BODIES_ANSWER_HPP

#include "meet/app/text/json.hpp"
#include "meet/app/world/collide_bodies.hpp"
#include "meet/core/world/world.hpp"
#include "meet/io/elements/element_set.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace meetc::app {

// A file is read and prepared once, though many bodies have it.
struct body_shape {
  io::element_set elements;
  std::shared_ptr<const prepared> set;
};

struct bodies_scene {
  std::vector<std::string> names;
  std::vector<const body_shape *> shapes; // of each body
  std::map<std::filesystem::path, body_shape> by_file;
  world bodies;
  std::vector<std::string> notes; // of other files than theirs
  std::string device;             // that is asked; empty: the CPU
  double read_seconds = 0, prepare_seconds = 0;

  bodies_scene(const catalogue &all, const std::string &mode) : bodies(all, mode) {}
};

// The answer to one frame.
struct frame_answer {
  std::string name;
  world_answer found;
};

// Meshes hold what lies inside them where they are taken as solid, and where it is certain that nothing touches them.
inline bool asks_nested(const bodies_request &q) {
  return q.mode == "solid" && never_wrong(q.precision);
}

std::string summary(const bodies_request &q, const bodies_scene &s, const std::vector<frame_answer> &frames);
json as_json(const bodies_request &q, const bodies_scene &s, const std::vector<frame_answer> &frames);

} // namespace meetc::app

#endif
