// app/text/boxes.hpp: relations of two boxes. Boxes are closed; a box with lo > hi is empty.
#ifndef MEETC_APP_TEXT_BOXES_HPP
#define MEETC_APP_TEXT_BOXES_HPP

#include "meet/core/hierarchy/box.hpp"

namespace meetc::app {

bool is_empty(const box &b);
bool disjoint(const box &x, const box &y); // false where one is empty
bool inside(const box &inner, const box &outer);

} // namespace meetc::app

#endif
