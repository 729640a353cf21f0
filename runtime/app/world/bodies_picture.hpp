// app/world/bodies_picture.hpp: many bodies, and the elements of them that touch, as a picture of one frame.
#ifndef MEETC_APP_WORLD_BODIES_PICTURE_HPP
#define MEETC_APP_WORLD_BODIES_PICTURE_HPP

#include "meet/app/input/picture_options.hpp"
#include "meet/app/world/bodies_answer.hpp"
#include "meet/app/world/poses_file.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace meetc::app {

// The first frame in which bodies touch; where none do, the first frame.
class bodies_picture {
public:
  // from: the bodies of s, with their poses before the first frame. answers: of each frame, with its pairs. All must outlive
  // this.
  bodies_picture(const bodies_scene &s, const world_source &from, std::span<const frame> frames,
                 std::span<const frame_answer> answers);

  // Bodies that touch come first. Those beyond 40 are drawn together, those of a kind as one. Throws io::error.
  void write(const std::filesystem::path &to, const picture_view &view) const;
  // ", frame 12"; empty where the frame has no name.
  std::string frame_in_words() const;

private:
  const bodies_scene &s_;
  std::vector<pose> at_; // of each body
  const frame_answer *answer_;
};

} // namespace meetc::app

#endif
