// The points that a label's coordinates are computed from.
#ifndef MEETC_CONTACT_LABEL_POINTS_HPP
#define MEETC_CONTACT_LABEL_POINTS_HPP

#include <meetc/contact/code.hpp>

#include <cstddef>

MEETC_NAMESPACE(meetc) {

// An element of a pair: its row and the number of its corners, 2 or 3.
struct contact_element {
  const float *row;
  int corners;
};

// A corner p; or the edge from p to q, and the two points of the other edge or the three of the other face that it meets.
struct label_points {
  const float *p, *q; // q: null for a corner
  const float *other[3];
  int others;

  MEETC_HD label_points(const contact_element &a, const contact_element &b, unsigned label) : q(nullptr), others(0) {
    const int at_a = label_a(label), at_b = label_b(label);
    if (at_a < a.corners || at_b < b.corners) {
      p = at_a < a.corners ? corner(a, at_a) : corner(b, at_b);
      return;
    }
    const bool edge_of_a = at_a < open_face;
    const contact_element &with_edge = edge_of_a ? a : b, &with_other = edge_of_a ? b : a;
    const int edge = edge_of_a ? at_a : at_b, that = edge_of_a ? at_b : at_a;
    ends(with_edge, edge, p, q);
    others = that == open_face ? 3 : 2;
    if (others == 2) {
      ends(with_other, that, other[0], other[1]);
      return;
    }
    for (int i = 0; i < 3; ++i)
      other[i] = corner(with_other, i);
  }

private:
  MEETC_HD static const float *corner(const contact_element &of, int i) { return of.row + std::ptrdiff_t{3} * i; }
  MEETC_HD static void ends(const contact_element &of, int edge, const float *&from, const float *&to) {
    const int i = edge - first_edge, next = i + 1 == of.corners ? 0 : i + 1;
    from = corner(of, i), to = corner(of, next);
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
