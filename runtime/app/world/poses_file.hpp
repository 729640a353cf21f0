// app/world/poses_file.hpp: the poses of bodies, frame by frame.
//
// A CSV whose first line is frame,body,m00,m01,…,m23 (a row-major 3x4 matrix) or frame,body,x,y,z,qw,qx,qy,qz. Rows of one
// frame follow each other; a body that a frame does not name stays. Blank lines and lines that start with # say nothing. Or an
// array of NumPy (frames, bodies, 4, 4), or (bodies, 4, 4) for one frame: matrices of all bodies, in their order.
#ifndef MEETC_APP_WORLD_POSES_FILE_HPP
#define MEETC_APP_WORLD_POSES_FILE_HPP

#include "meet/core/views/pose.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace meetc::app {

struct frame {
  std::string name;
  std::vector<std::pair<std::uint32_t, pose>> moved; // the number of a body, and its pose
};

// Throws io::error, `FILE:LINE: what`, for a fault of the file or a body that is not among `names`, and for an array
// `FILE: what` or `FILE: frame 2, body arm: what`.
std::vector<frame> read_poses(const std::filesystem::path &path, const std::vector<std::string> &names);

} // namespace meetc::app

#endif
