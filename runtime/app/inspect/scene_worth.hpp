// app/inspect/scene_worth.hpp: the gain from each line of a scene for two sets, measured by queries.
#ifndef MEETC_APP_INSPECT_SCENE_WORTH_HPP
#define MEETC_APP_INSPECT_SCENE_WORTH_HPP

#include "meet/app/query/choose.hpp"
#include "meet/io/elements/element_set.hpp"

#include <string>

namespace meetc::app {

// Collides the sets by the predicate with and without the scene's box and its tolerance (0: it has none), each in the least
// time of some runs. Returns lines of text. `catalogue` has the predicates that the scene could have.
std::string worth_of_scene(const catalogue &all, const io::element_set &a, const io::element_set &b, const choice &by,
                           double box, double tolerance);

} // namespace meetc::app

#endif
