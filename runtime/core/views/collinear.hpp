// core/views/collinear.hpp: whether three points lie on one line.
#ifndef MEETC_CORE_VIEWS_COLLINEAR_HPP
#define MEETC_CORE_VIEWS_COLLINEAR_HPP

namespace meetc {

// Of a row of nine coordinates, which are finite; exact.
bool collinear(const float *row);

} // namespace meetc

#endif
