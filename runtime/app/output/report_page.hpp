// app/output/report_page.hpp: the answer of `meet collide` as a page for a browser.
#ifndef MEETC_APP_OUTPUT_REPORT_PAGE_HPP
#define MEETC_APP_OUTPUT_REPORT_PAGE_HPP

#include "meet/app/output/paint.hpp"
#include "meet/app/output/report.hpp"
#include "meet/app/output/self_report.hpp"

#include <filesystem>

namespace meetc::app {

// Throws failure for a name with another extension. A name without one may be that of a device.
void check_page(const std::filesystem::path &to);

// Whether the page shows where these pairs meet, for which found.element_pairs must be kept.
bool page_has_contacts(const query &asked);

// The bytes depend on the sets, their names and the answer alone. found.list has all pairs. Throws io::error.
void write_page(const std::filesystem::path &to, const painted &a, const painted &b, const collide_report &report);
void write_page(const std::filesystem::path &to, const painted &a, const predicate_info &predicate,
                const self_report &report, int threads);

} // namespace meetc::app

#endif
