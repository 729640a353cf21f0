// app/algebra_file.hpp: where the algebra lies that comes with the program.
//
// The program may be installed, or run from a build tree, its own or that of a project that builds it; either may
// have been moved since. So the places are named from the program's own file first, and then in full.
#ifndef MEETC_APP_ALGEBRA_FILE_HPP
#define MEETC_APP_ALGEBRA_FILE_HPP

#include <filesystem>
#include <optional>
#include <vector>

namespace meetc::app {

// Each once, in the order in which they are searched, for a program in this folder.
std::vector<std::filesystem::path> algebra_places(const std::filesystem::path &program_folder);

// The same for the program that is running.
std::vector<std::filesystem::path> algebra_places();

// `asked`, else the first of the places that is a file. Throws failure where there is none, which names them.
std::filesystem::path algebra_path(const std::optional<std::filesystem::path> &asked,
                                   const std::vector<std::filesystem::path> &places);

} // namespace meetc::app

#endif
