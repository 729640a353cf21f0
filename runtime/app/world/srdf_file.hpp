// app/world/srdf_file.hpp: the pairs of links that may touch, from a robot's SRDF file (semantic robot description format).
//
//   <robot name="arm">
//     <disable_collisions link1="base" link2="shoulder" reason="Adjacent"/>
//   </robot>
//
// A body is a link by its name. <disable_default_collisions link="base"/> is every pair of a link, but for those of
// <enable_collisions link1 link2>. All else says nothing here.
#ifndef MEETC_APP_WORLD_SRDF_FILE_HPP
#define MEETC_APP_WORLD_SRDF_FILE_HPP

#include "meet/app/world/name_pairs.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace meetc::app {

struct srdf_pairs {
  std::vector<name_pair> allowed; // of bodies
  std::size_t others = 0;         // lines that name a link that is no body
};

// Throws io::error, `FILE:LINE: what`.
srdf_pairs read_srdf(const std::filesystem::path &path, const std::vector<std::string> &names);

} // namespace meetc::app

#endif
