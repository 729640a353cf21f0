#include "gen/lang/places.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace meetc::lang {

namespace fs = std::filesystem;

std::string find_algebra(const location &named_at, const std::string &name,
                         const std::vector<std::string> &algebra_path) {
  if (name.empty())
    throw spec_error(named_at, "an algebra is a file, as in 'cga3.toml'");
  std::vector<fs::path> places{fs::path(named_at.file->path).parent_path() / name};
  if (fs::path(name).is_relative()) {
    for (const std::string &folder : algebra_path)
      places.push_back(fs::path(folder) / name);
    // The shipped ones are in the share/ next to the program's folder, in an install and in a build tree.
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty())
      places.push_back(program.parent_path().parent_path() / "share/meetc/algebra_spec" / name);
  }
  std::vector<std::string> searched;
  for (const fs::path &p : places) {
    std::error_code ignored;
    if (fs::is_regular_file(p, ignored))
      return p.generic_string();
    searched.push_back(p.generic_string());
  }
  throw spec_error(named_at,
                   fmt::format("cannot find the algebra '{}'; there is no {}", name, join(searched, ", no ")));
}

} // namespace meetc::lang
