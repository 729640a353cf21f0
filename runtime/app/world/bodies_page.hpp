// app/world/bodies_page.hpp: many bodies, and which of them touch in each frame, as a page for a browser.
#ifndef MEETC_APP_WORLD_BODIES_PAGE_HPP
#define MEETC_APP_WORLD_BODIES_PAGE_HPP

#include "meet/app/world/poses_file.hpp"
#include "meet/core/world/world.hpp"
#include "meet/io/elements/element_set.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace meetc::app {

struct shown_body {
  std::string name;
  const io::element_set *elements; // one for all bodies of one file
  pose at;
};

// answers: of each frame. The bytes depend on the bodies, the frames and the answers alone. Throws io::error.
void write_bodies_page(const std::filesystem::path &to, const std::vector<shown_body> &bodies,
                       std::span<const frame> frames, std::span<const world_answer *const> answers, rung precision);

} // namespace meetc::app

#endif
