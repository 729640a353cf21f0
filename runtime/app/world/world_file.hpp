// app/world/world_file.hpp: a JSON file that lists bodies, their poses and the pairs that may touch.
//
//   {"bodies": [{"name": "arm", "file": "arm.ply", "pose": [12 or 16 numbers, or x, y, z, qw, qx, qy, qz]}, …],
//    "allow": [["arm", "tool"], ["floor", "*"]]}
//
// A file is named relative to the JSON file; without a name a body has that of its file, and without a pose it stands as it is.
#ifndef MEETC_APP_WORLD_WORLD_FILE_HPP
#define MEETC_APP_WORLD_WORLD_FILE_HPP

#include "meet/app/world/name_pairs.hpp"
#include "meet/core/views/pose.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meetc::app {

struct body_source {
  std::string name;
  std::filesystem::path file;
  pose at = {};
  std::string place = {}; // `FILE: bodies[2]`; empty: the command line
};

struct world_source {
  std::vector<body_source> bodies;
  std::vector<name_pair> allowed;
};

// Throws io::error: `FILE:LINE:COLUMN: what` where it is no JSON, and `FILE: bodies[2].pose: what` elsewhere.
world_source read_world(const std::filesystem::path &path);

// Bodies of files, each named by its file without the extension; the second of one name is `arm 2`.
world_source world_of_files(const std::vector<std::filesystem::path> &files);

} // namespace meetc::app

#endif
