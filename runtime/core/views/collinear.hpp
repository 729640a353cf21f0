// core/views/collinear.hpp: whether three points lie on one line.
#ifndef MEETC_CORE_VIEWS_COLLINEAR_HPP
#define MEETC_CORE_VIEWS_COLLINEAR_HPP

namespace meetc {

// row: the nine finite coordinates of three points. The answer is exact.
bool collinear(const float *row);

} // namespace meetc

#endif
