// The labels of two elements by their definition, whatever their dimensions: for what has no area or length, and for a
// segment in a triangle's plane.
#ifndef MEETC_CONTACT_HULLS_HPP
#define MEETC_CONTACT_HULLS_HPP

#include <meetc/contact/signs.hpp>

MEETC_NAMESPACE(meetc) {

MEETC_HD inline bool equal_points(const float *x, const float *y) {
  return x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
}
// By x, then y, then z. On a line this is the order of the line or its opposite.
MEETC_HD inline bool lies_before(const float *x, const float *y) {
  return x[0] != y[0] ? x[0] < y[0] : x[1] != y[1] ? x[1] < y[1] : x[2] < y[2];
}

// The hull of an element with two or three corners: a point, a segment or a triangle. A hull with fewer corners than the
// element has those of least index among equal ones; only their carriers exist.
template <class Sides> class element_hull {
public:
  MEETC_HD element_hull(contact_signs<Sides> &signs, const float *row, int corners)
      : signs_(signs), row_(row), corners_(corners) {
    for (int k = 0; corners == 3 && k < 3 && count_ != 3; ++k)
      if ((turn_ = signs.turn(k, row, row + 3, row + 6)) != 0) {
        axis_ = k, count_ = 3;
        for (int i = 0; i < 3; ++i)
          at_[i] = i;
      }
    if (count_ == 3)
      return;
    for (int i = 1; i < corners; ++i) {
      at_[0] = lies_before(row + 3 * i, corner(0)) ? i : at_[0];
      at_[1] = lies_before(corner(1), row + 3 * i) ? i : at_[1];
    }
    count_ = equal_points(corner(0), corner(1)) ? 1 : 2;
  }

  MEETC_HD int count() const { return count_; } // of corners
  MEETC_HD int axis() const { return axis_; }   // on which the turn of three corners is not 0
  MEETC_HD int turn() const { return turn_; }
  MEETC_HD const float *row() const { return row_; }
  MEETC_HD const float *corner(int i) const { return row_ + 3 * at_[i]; }
  MEETC_HD int corner_name(int i) const { return at_[i]; }
  MEETC_HD int edges() const { return count_ == 3 ? 3 : count_ - 1; }
  MEETC_HD const float *from(int edge) const { return corner(edge); }
  MEETC_HD const float *to(int edge) const { return corner(edge + 1 == count_ ? 0 : edge + 1); }
  MEETC_HD int edge_name(int edge) const {
    if (count_ == 3 || corners_ == 2)
      return first_edge + edge;
    return first_edge + (next_corner(at_[0]) == at_[1] ? at_[0] : at_[1]);
  }

  // The carrier that holds x, or -1.
  MEETC_HD int carrier_at(const float *x) const {
    if (count_ == 3) {
      if (signs_.side(row_, x) != 0)
        return -1;
      int w[3];
      for (int i = 0; i < 3; ++i)
        if ((w[i] = turn_ * signs_.turn(axis_, from(i), to(i), x)) < 0)
          return -1;
      return carrier_by_edges(w[0], w[1], w[2]);
    }
    for (int i = 0; i < count_; ++i)
      if (equal_points(x, corner(i)))
        return corner_name(i);
    if (count_ == 1 || !lies_before(corner(0), x) || !lies_before(x, corner(1)))
      return -1;
    for (int k = 0; k < 3; ++k)
      if (signs_.turn(k, corner(0), corner(1), x) != 0)
        return -1;
    return edge_name(0);
  }
  // Whether the open segment from p to q crosses the open face.
  MEETC_HD bool crossed_by(const float *p, const float *q) const {
    if (count_ != 3 || signs_.side(row_, p) * signs_.side(row_, q) >= 0)
      return false;
    const int w = twist(p, q, 0);
    return w != 0 && twist(p, q, 1) == w && twist(p, q, 2) == w;
  }
  MEETC_HD int twist(const float *p, const float *q, int edge) const { return signs_.det(p, q, from(edge), to(edge)); }

private:
  contact_signs<Sides> &signs_;
  const float *row_;
  int corners_, count_ = 0, axis_ = 0, turn_ = 0;
  int at_[3] = {0, 0, 0};
};

template <class Sides> class hull_contact {
  using hull = element_hull<Sides>;

public:
  MEETC_HD hull_contact(contact_signs<Sides> &signs, const hull &a, const hull &b) : signs_(signs), a_(a), b_(b) {}

  // ordered: along A, which is a segment. Otherwise the least label comes first.
  MEETC_HD contact_code code(bool ordered) {
    for (int i = 0; i < a_.count(); ++i)
      if (const int c = b_.carrier_at(a_.corner(i)); c >= 0)
        found_.add(a_.corner_name(i), c);
    for (int j = 0; j < b_.count(); ++j)
      if (const int c = a_.carrier_at(b_.corner(j)); c >= 0)
        found_.add(c, b_.corner_name(j));
    for (int i = 0; i < a_.edges(); ++i) {
      if (b_.crossed_by(a_.from(i), a_.to(i)))
        found_.add(a_.edge_name(i), open_face);
      for (int j = 0; j < b_.edges(); ++j)
        if (cross(a_.from(i), a_.to(i), b_.from(j), b_.to(j)))
          found_.add(a_.edge_name(i), b_.edge_name(j));
    }
    for (int j = 0; j < b_.edges(); ++j)
      if (a_.crossed_by(b_.from(j), b_.to(j)))
        found_.add(open_face, b_.edge_name(j));
    if (ordered && found_.count() == 2 && !in_order(found_[0], found_[1]))
      found_.exchange();
    return contact_code(found_.data(), found_.count());
  }

private:
  contact_signs<Sides> &signs_;
  const hull &a_, &b_;
  label_list found_;

  // Whether two open segments on different lines share a point.
  MEETC_HD bool cross(const float *p, const float *q, const float *u, const float *v) const {
    if (signs_.det(p, q, u, v) != 0)
      return false;
    for (int k = 0; k < 3; ++k)
      if (signs_.turn(k, p, q, u) * signs_.turn(k, p, q, v) < 0 &&
          signs_.turn(k, u, v, p) * signs_.turn(k, u, v, q) < 0)
        return true;
    return false;
  }

  // Whether A, from its corner 0 to its corner 1, comes to x before y.
  MEETC_HD bool in_order(unsigned x, unsigned y) const {
    const float *const start = a_.row(), *const end = a_.row() + 3;
    if (label_a(x) < 2 || label_a(y) < 2)
      return label_a(x) == 0 || label_a(y) == 1;
    const int at_x = label_b(x), at_y = label_b(y);
    if (at_x >= first_edge)
      return outside(at_x - first_edge, start);
    if (at_y >= first_edge)
      return !outside(at_y - first_edge, start);
    return lies_before(b_.row() + 3 * at_x, b_.row() + 3 * at_y) == lies_before(start, end);
  }
  // Whether x, in B's plane, lies on the outer side of B's edge.
  MEETC_HD bool outside(int edge, const float *x) const {
    return b_.turn() * signs_.turn(b_.axis(), b_.from(edge), b_.to(edge), x) < 0;
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
