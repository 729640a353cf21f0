// app/world/bodies_page.hpp: many bodies, and which of them touch in each frame, as a page for a browser.
#ifndef MEETC_APP_WORLD_BODIES_PAGE_HPP
#define MEETC_APP_WORLD_BODIES_PAGE_HPP

#include "meet/app/world/bodies_answer.hpp"
#include "meet/app/world/poses_file.hpp"

#include <filesystem>
#include <span>
#include <vector>

namespace meetc::app {

// from: the bodies of s, whose poses they have before the first frame. answers: of each frame. The bytes depend on these
// alone. Throws io::error.
void write_bodies_page(const std::filesystem::path &to, const bodies_scene &s, const world_source &from,
                       std::span<const frame> frames, const std::vector<frame_answer> &answers, rung precision);

} // namespace meetc::app

#endif
