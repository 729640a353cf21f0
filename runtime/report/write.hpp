// report/write.hpp: a scene as one HTML file, which needs no other file and no network.
#ifndef MEETC_REPORT_WRITE_HPP
#define MEETC_REPORT_WRITE_HPP

#include "meet/report/scene.hpp"

#include <string>

namespace meetc::report {

// The same bytes for the same scene. A pair that is not listed is counted in a note, and a face that is hit in such pairs alone
// has its place rounded to 16 bits. Throws std::runtime_error if zlib fails.
std::string as_html(const scene &s, const limits &most = {});

} // namespace meetc::report

#endif
