// app/input/made_sets.hpp: meshes and rows made in memory, as sets of elements like those read from a file.
#ifndef MEETC_APP_INPUT_MADE_SETS_HPP
#define MEETC_APP_INPUT_MADE_SETS_HPP

#include "meet/bodies/meshes.hpp"
#include "meet/io/elements/element_set.hpp"
#include "meet/io/elements/transform.hpp"
#include "meetc/support.hpp"

#include <string_view>
#include <vector>

namespace meetc::app {

// Both throw failure if the build has no kind of that name.
//
// Moves the vertices like those of a file: in double, rounded once.
io::element_set of_mesh(const catalogue &all, bodies::mesh m, const io::transform &move = {});
io::element_set of_rows(const catalogue &all, std::string_view kind, std::vector<float> rows);

} // namespace meetc::app

#endif
