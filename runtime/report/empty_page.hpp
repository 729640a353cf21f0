// report/empty_page.hpp: the page as runtime/report/page/build.sh makes it, with two places for data.
#ifndef MEETC_REPORT_EMPTY_PAGE_HPP
#define MEETC_REPORT_EMPTY_PAGE_HPP

#include <string_view>

namespace meetc::report {

inline constexpr std::string_view place_of_json = "MEET_JSON_STANDS_HERE", place_of_bytes = "MEET_BYTES_STAND_HERE";

std::string_view empty_page();

} // namespace meetc::report

#endif
