// app/output/contact_files.hpp: where touching pairs meet, as a table, as lines and polygons, or as JSON.
//
// .csv: a row for each corner of each pair's contact, in the order of the pairs, with the columns a, b (the file's items),
// triangle_a or triangle_b where a file's polygons were cut, node, x, y, z, on_a and on_b. Rows of one node have one number.
// .obj and .ply: the nodes as vertices, polylines as lines or edges (a closed one comes back to its first node), and patches as
// faces; nodes on none of these are points, in .obj as `p`. .json: everything.
// Pairs with a witness have one row, without a node, where on_a and on_b are "witness"; .obj and .ply say so in a comment.
// A node lies on "vertex V", "edge V W" or "face F" of each set, or on the "surface B" or "inside B" of a ball. Vertices are as
// the file numbers them, from 0, or corner by corner where it numbers none; of several vertices with equal coordinates one.
// Edges may be those between the triangles of a polygon.
#ifndef MEETC_APP_OUTPUT_CONTACT_FILES_HPP
#define MEETC_APP_OUTPUT_CONTACT_FILES_HPP

#include "meet/app/output/output_files.hpp"
#include "meet/app/query/collide_sets.hpp"
#include "meet/core/contacts/contacts.hpp"
#include "meet/report/contact_lines.hpp"

namespace meetc::app {

using report::contact_counts;
using report::counts_of;
using report::in_words;

// "yes", "no" or "unchecked"
const char *name_of(embedding e);

// Throws failure for a name with another extension, or a predicate without contacts.
void check_contact_file(const std::filesystem::path &to);
void require_contacts(const predicate_info &predicate);

// The contacts of found.element_pairs, for float and double. The first operand is B where the predicate takes the sets in the
// other order.
template <class Real>
contact_set<Real> find_contacts(const io::element_set &a, const io::element_set &b, const query &asked,
                                const answers &found);

// Finds the contacts of found.element_pairs and writes them. float64: coordinates are rounded to it, and not to float32.
contact_counts write_contacts(const std::filesystem::path &to, bool float64, const io::element_set &a,
                              const io::element_set &b, const query &asked, const answers &found,
                              output_files &outputs);

} // namespace meetc::app

#endif
