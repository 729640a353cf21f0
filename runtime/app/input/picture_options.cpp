#include "meet/app/input/picture_options.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/option_values.hpp"
#include "meet/io/text/number.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace meetc::app {

namespace {

picture::camera by_angles(const std::string &text, const std::vector<double> &given, bool z_up) {
  constexpr double most_distance = 1000;
  picture::camera out;
  out.z_up = z_up;
  out.azimuth = std::fmod(given[0], 360);
  out.elevation = given[1];
  if (!(std::abs(out.elevation) <= 90))
    throw failure(fmt::format("--camera {}: the elevation {} is beyond 90 degrees", text, out.elevation));
  if (given.size() == 3)
    out.distance = given[2];
  if (!(out.distance > 0 && out.distance <= most_distance))
    throw failure(
        fmt::format("--camera {}: the distance {} is not above 0 and at most {}; at 1 the scene fills the picture",
                    text, out.distance, most_distance));
  return out;
}

picture::camera by_points(const std::string &text, const std::vector<double> &given) {
  constexpr double most = 1e40; // beyond all float32 numbers
  const auto vector_at = [&given](std::size_t i) { return vec{given[i], given[i + 1], given[i + 2]}; };
  for (const double v : given)
    if (std::abs(v) > most)
      throw failure(fmt::format("--camera {}: {} is beyond all float32 numbers", text, v));
  const vec eye = vector_at(0), target = vector_at(3), way = eye - target;
  const vec up = given.size() == 9 ? vector_at(6) : vec{0, 1, 0};
  if (!(dot(way, way) > 0))
    throw failure(fmt::format("--camera {}: the eye and the point that it looks at are one", text));
  if (!(dot(up, up) > 0))
    throw failure(fmt::format("--camera {}: the direction up has no length", text));
  constexpr double least_sine = 1e-6;
  const vec upwards = normal(up), across = cross(upwards, normal(way));
  if (!(std::sqrt(dot(across, across)) > least_sine))
    throw failure(
        fmt::format("--camera {}: it looks along the direction up, {},{},{}; name another one as the last three "
                    "numbers",
                    text, up.x, up.y, up.z));
  picture::camera out;
  out.stands = {eye, target, upwards};
  out.z_up = std::abs(upwards.z) > std::abs(upwards.y);
  return out;
}

picture::camera camera_named(const std::string &text) {
  constexpr std::string_view z_up = ",z";
  const bool up = text.ends_with(z_up);
  const std::vector<double> given = number_list("--camera", text.substr(0, text.size() - (up ? z_up.size() : 0)));
  const auto not_finite = std::ranges::find_if(given, [](double v) { return !std::isfinite(v); });
  if (not_finite != given.end())
    throw failure(fmt::format("--camera {}: {} is not a finite number", text, *not_finite));
  if (given.size() == 2 || given.size() == 3)
    return by_angles(text, given, up);
  if (!up && (given.size() == 6 || given.size() == 9))
    return by_points(text, given);
  throw failure(
      fmt::format("--camera: {} is neither azimuth,elevation[,distance][,z] nor the x,y,z of the eye and of the "
                  "point that it looks at, with or without those of the direction up",
                  io::quote(text)));
}

void read_size(const std::string &text, picture_view &to) {
  constexpr std::int64_t least = 64, most = 8192, most_pixels = 16'777'216;
  const std::size_t x = text.find('x');
  std::int64_t w = 0, h = 0;
  if (x == std::string::npos || !io::parse_integer(std::string_view(text).substr(0, x), w) ||
      !io::parse_integer(std::string_view(text).substr(x + 1), h))
    throw failure(fmt::format("--size: {} is not WIDTHxHEIGHT in pixels, such as 1600x900", io::quote(text)));
  if (std::min(w, h) < least || std::max(w, h) > most || w * h > most_pixels)
    throw failure(fmt::format("--size {}: width and height are from {} to {} pixels, and a picture has at most {}",
                              text, least, most, most_pixels));
  to.width = static_cast<int>(w), to.height = static_cast<int>(h);
}

} // namespace

picture_view picture_view_named(const std::optional<std::string> &camera, const std::optional<std::string> &size) {
  picture_view out;
  if (camera)
    out.from = camera_named(*camera);
  if (size)
    read_size(*size, out);
  return out;
}

} // namespace meetc::app
