// app/world/collide_bodies.hpp: which bodies touch, in each frame.
#ifndef MEETC_APP_WORLD_COLLIDE_BODIES_HPP
#define MEETC_APP_WORLD_COLLIDE_BODIES_HPP

#include "meet/app/input/picture_options.hpp"
#include "meet/app/query/device_pairs.hpp"
#include "meet/app/world/world_file.hpp"
#include "meetc/support.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meetc::app {

struct bodies_request {
  std::vector<std::filesystem::path> files;   // bodies that stand as they are, or
  std::optional<std::filesystem::path> world; // a file that lists bodies
  std::optional<std::filesystem::path> poses, srdf;
  std::vector<name_pair> allowed;
  std::optional<name_pair> only;
  std::string mode = "solid";
  rung precision = rung::certified;
  processor on = processor::cpu;
  bool any = false, json = false;
  std::optional<std::filesystem::path> pairs; // a folder
  std::optional<std::filesystem::path> image, page;
  picture_view view = {}; // of the image
  int threads = 0;
};

struct bodies_report {
  std::string text;
  bool touch = false; // in some frame, or a body lies inside another
};

// Writes the requested files. Throws io::error.
bodies_report collide_bodies(const catalogue &all, const bodies_request &request);

} // namespace meetc::app

#endif
