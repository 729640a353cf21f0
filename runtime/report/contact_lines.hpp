// report/contact_lines.hpp: contacts as lines and triangles of a page, and their numbers in words.
#ifndef MEETC_REPORT_CONTACT_LINES_HPP
#define MEETC_REPORT_CONTACT_LINES_HPP

#include "meet/core/contacts/contacts.hpp"
#include "meet/report/scene.hpp"

#include <cstddef>
#include <string>

namespace meetc::report {

struct contact_counts {
  std::size_t nodes = 0, pieces = 0, polylines = 0, closed = 0, patches = 0, single_nodes = 0, witnesses = 0;
  embedding embedded = embedding::unchecked;
  double seconds = 0; // to find them, without writing
};

template <class Real> contact_counts counts_of(const contact_set<Real> &contacts);

// "4,764 nodes, 4,762 pieces, 9 polylines (7 closed)"
std::string in_words(const contact_counts &counts);

contact_lines lines_of(const contact_set<double> &contacts);

} // namespace meetc::report

#endif
