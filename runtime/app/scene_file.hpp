// app/scene_file.hpp: the scene that two kinds of element require, as meetc reads it.
#ifndef MEETC_APP_SCENE_FILE_HPP
#define MEETC_APP_SCENE_FILE_HPP

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meetc::app {

// The algebra that a scene names: `asked`, else the installed one, else the one of the source tree. Throws
// failure where it is not there.
std::filesystem::path algebra_path(const std::optional<std::filesystem::path> &asked);

// The text of a scene file that will lie at `at`. The namespace is the file's name, made an identifier; the
// algebra is named relative to the file. `box` 0: the scene states none.
std::string scene_text(const std::filesystem::path &at, const std::filesystem::path &algebra,
                       const std::vector<std::string> &predicates, double box, const std::string &comment);

} // namespace meetc::app

#endif
