// app/input/algebra_file.hpp: finds the algebra that comes with the program.
//
// The program may be installed, or run from a build tree, either this project's or that of a project that builds it.
// Either may have been moved since. The places searched are therefore relative to the program's own file first, and
// absolute after that.
#ifndef MEETC_APP_INPUT_ALGEBRA_FILE_HPP
#define MEETC_APP_INPUT_ALGEBRA_FILE_HPP

#include <filesystem>
#include <optional>
#include <vector>

namespace meetc::app {

// The places searched by a program in this folder, each once, in the order of the search.
std::vector<std::filesystem::path> algebra_places(const std::filesystem::path &program_folder);

// The same for the running program.
std::vector<std::filesystem::path> algebra_places();

// `asked`, or else the first of the places that is a file. If there is none, throws failure that lists the places.
std::filesystem::path algebra_path(const std::optional<std::filesystem::path> &asked,
                                   const std::vector<std::filesystem::path> &places);

} // namespace meetc::app

#endif
