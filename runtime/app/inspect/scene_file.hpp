// app/inspect/scene_file.hpp: writes the scene that two kinds of element require, for meetc to read.
#ifndef MEETC_APP_INSPECT_SCENE_FILE_HPP
#define MEETC_APP_INSPECT_SCENE_FILE_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace meetc::app {

// The text of a scene file that will lie at `at`. The namespace is the name of the file, made an identifier; the path
// of the algebra is relative to the file. `box` 0: the scene states none. With a tolerance above 0 the scene states it
// and leaves the rungs to the generator; otherwise it asks for certified answers.
std::string scene_text(const std::filesystem::path &at, const std::filesystem::path &algebra,
                       const std::vector<std::string> &predicates, double box, double tolerance,
                       const std::string &comment);

} // namespace meetc::app

#endif
