// The labels of two triangles with area in one plane, and the polygon in which they overlap.
//
// Along an axis on which the normals are not 0 the triangles are triangles of the plane, and 18 turns tell all labels. A side
// of the polygon is the part of one edge between the two labels on it, so the labels go round by their names; no angle is
// sorted.
#ifndef MEETC_CONTACT_FLAT_HPP
#define MEETC_CONTACT_FLAT_HPP

#include <meetc/contact/signs.hpp>

MEETC_NAMESPACE(meetc) {

class flat_triangles {
public:
  // turn_a, turn_b: those of the triangles along the axis; not 0.
  template <class Sides>
  MEETC_HD flat_triangles(contact_signs<Sides> &signs, const float *a, const float *b, int axis, int turn_a, int turn_b)
      : agree_(turn_a == turn_b) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        of_a_[i][j] = turn_a * signs.turn(axis, a + 3 * i, a + 3 * next_corner(i), b + 3 * j);
        of_b_[j][i] = turn_b * signs.turn(axis, b + 3 * j, b + 3 * next_corner(j), a + 3 * i);
      }
  }

  MEETC_HD contact_code code() {
    for (int i = 0; i < 3; ++i) {
      if (const int c = inside(of_b_, i); c >= 0)
        found_.add(i, c);
      if (const int c = inside(of_a_, i); c >= 0)
        found_.add(c, i);
      for (int j = 0; j < 3; ++j)
        if (of_a_[i][j] * of_a_[i][next_corner(j)] < 0 && of_b_[j][i] * of_b_[j][next_corner(i)] < 0)
          found_.add(first_edge + i, first_edge + j);
    }
    if (found_.count() < 3)
      return contact_code(found_.data(), found_.count(), true, agree_);
    unsigned cycle[most_labels];
    go_round(cycle);
    return contact_code(cycle, found_.count(), true, agree_);
  }

private:
  int of_a_[3][3], of_b_[3][3]; // [edge][corner of the other]: 1 on the inner side
  bool agree_;
  label_list found_;

  MEETC_HD static int inside(const int (&of)[3][3], int corner) {
    return of[0][corner] < 0 || of[1][corner] < 0 || of[2][corner] < 0
               ? -1
               : carrier_by_edges(of[0][corner], of[1][corner], of[2][corner]);
  }

  // The two labels on a closed edge: x and y, as places in the list; false if there are fewer.
  template <class Carrier> MEETC_HD bool on_edge(int edge, const Carrier &carrier, int &x, int &y) const {
    int n = 0;
    for (int l = 0; l < found_.count(); ++l)
      if (const int c = carrier(found_[l]); c == edge || c == next_corner(edge) || c == first_edge + edge)
        (n++ == 0 ? x : y) = l;
    return n == 2;
  }

  // Whether A's border, which is counter-clockwise, comes to x before y, both on its edge.
  MEETC_HD bool in_order(int edge, unsigned x, unsigned y) const {
    if (label_a(x) == edge || label_a(y) == next_corner(edge))
      return true;
    if (label_a(y) == edge || label_a(x) == next_corner(edge))
      return false;
    // Inside the edge: it enters B through an edge of which its first corner is outside.
    if (label_b(x) >= first_edge)
      return of_b_[label_b(x) - first_edge][edge] < 0;
    if (label_b(y) >= first_edge)
      return of_b_[label_b(y) - first_edge][edge] > 0;
    // An edge of B lies along it, with B on the same side.
    return (next_corner(label_b(x)) == label_b(y)) == agree_;
  }

  MEETC_HD void go_round(unsigned *cycle) const {
    // The neighbours of each label; the one that follows it, where A's border tells.
    int beside[most_labels][2] = {}, known[most_labels] = {};
    int from = -1, to = -1, x = 0, y = 0;
    const auto join = [&](int u, int v) {
      if (known[u] > 0 && (beside[u][0] == v || (known[u] > 1 && beside[u][1] == v)))
        return;
      beside[u][known[u]++] = v;
      beside[v][known[v]++] = u;
    };
    for (int e = 0; e < 3; ++e) {
      if (on_edge(e, label_a, x, y)) {
        join(x, y);
        if (from < 0) {
          const bool forward = in_order(e, found_[x], found_[y]);
          from = forward ? x : y, to = forward ? y : x;
        }
      }
      if (on_edge(e, label_b, x, y))
        join(x, y);
    }
    if (from < 0) // no side of the polygon is A's: it is B
      for (int l = 0; l < found_.count(); ++l) {
        from = label_b(found_[l]) == 0 ? l : from;
        to = label_b(found_[l]) == (agree_ ? 1 : 2) ? l : to;
      }
    while (to != 0) { // until it comes to the least label
      const int next = beside[to][0] == from ? beside[to][1] : beside[to][0];
      from = to, to = next;
    }
    for (int n = 0; n < found_.count(); ++n) {
      cycle[n] = found_[to];
      const int next = beside[to][0] == from ? beside[to][1] : beside[to][0];
      from = to, to = next;
    }
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
