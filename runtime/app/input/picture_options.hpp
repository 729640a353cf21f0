// app/input/picture_options.hpp: from where a picture is seen, and its size, as options name them.
#ifndef MEETC_APP_INPUT_PICTURE_OPTIONS_HPP
#define MEETC_APP_INPUT_PICTURE_OPTIONS_HPP

#include "meet/picture/camera.hpp"

#include <optional>
#include <string>

namespace meetc::app {

struct picture_view {
  picture::camera from = {};
  int width = 1600, height = 900;
};

// The values of --camera and --size. Throws failure that names the option.
picture_view picture_view_named(const std::optional<std::string> &camera, const std::optional<std::string> &size);

} // namespace meetc::app

#endif
