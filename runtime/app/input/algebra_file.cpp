#include "meet/app/input/algebra_file.hpp"

#include "meet/app/input/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>

namespace meetc::app {

namespace fs = std::filesystem;

std::vector<fs::path> algebra_places(const fs::path &program_folder) {
  std::vector<fs::path> out;
  const auto add = [&out](const fs::path &place) {
    const fs::path plain = place.lexically_normal();
    if (std::find(out.begin(), out.end(), plain) == out.end())
      out.push_back(plain);
  };
  if (!program_folder.empty())
    for (const char *const way : {MEETC_ALGEBRA_FROM_INSTALLED, MEETC_ALGEBRA_FROM_BUILT})
      add(program_folder / way);
  for (const char *const place : {MEETC_INSTALLED_ALGEBRA, MEETC_SOURCE_ALGEBRA})
    add(place);
  return out;
}

std::vector<fs::path> algebra_places() {
  std::error_code code;
  return algebra_places(fs::read_symlink("/proc/self/exe", code).parent_path()); // empty where the system does not tell
}

fs::path algebra_path(const std::optional<fs::path> &asked, const std::vector<fs::path> &places) {
  std::error_code code;
  if (asked) {
    if (!fs::is_regular_file(*asked, code))
      throw failure(fmt::format("{}: no such file; --algebra names the algebra, such as cga3.toml", asked->string()));
    return *asked;
  }
  std::string searched;
  for (const fs::path &place : places) {
    if (fs::is_regular_file(place, code))
      return place;
    searched += (searched.empty() ? "" : ", ") + place.string();
  }
  throw failure(fmt::format("--scene: the algebra cga3.toml was not found; searched: {}; say where it is with "
                            "--algebra PATH",
                            searched));
}

} // namespace meetc::app
