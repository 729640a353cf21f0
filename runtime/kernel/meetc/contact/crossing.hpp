// The labels of two triangles in different planes, and of a segment that leaves a triangle's plane.
//
// With det(a, b, c, d) = [b-a, c-a, d-a], sa_i = det(B, a_i), sb_j = det(A, b_j) and t_ij = det(a_i, a_i+1, b_j, b_j+1). An
// edge of A that leaves B's plane meets it in one point, whose carrier of B the signs t_i0, t_i1, t_i2 tell. Both triangles
// have an area here, since one without it has no side but 0.
#ifndef MEETC_CONTACT_CROSSING_HPP
#define MEETC_CONTACT_CROSSING_HPP

#include <meetc/contact/signs.hpp>

MEETC_NAMESPACE(meetc) {

template <class Sides> class crossing_triangles {
public:
  // Some sa_i and some sb_j is not 0.
  MEETC_HD crossing_triangles(contact_signs<Sides> &signs, const float *a, const float *b, const int *sa, const int *sb)
      : signs_(signs), a_(a), b_(b), sa_(sa), sb_(sb) {
    for (int i = 0; i < 9; ++i)
      twists_[i] = unknown;
  }

  MEETC_HD contact_code code() {
    if (!separated(sa_) && !separated(sb_) && !by_four_twists())
      by_all_twists();
    if (found_.count() == 2 && !enters(found_[0]))
      found_.exchange();
    return contact_code(found_.data(), found_.count());
  }

private:
  static constexpr signed char unknown = 2;
  contact_signs<Sides> &signs_;
  const float *a_, *b_;
  const int *sa_, *sb_;
  signed char twists_[9];
  label_list found_;

  MEETC_HD static bool separated(const int *s) {
    return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
  }
  MEETC_HD int twist(int i, int j) {
    signed char &t = twists_[3 * i + j];
    if (t == unknown)
      t = static_cast<signed char>(
          signs_.det(a_ + 3 * i, a_ + 3 * next_corner(i), b_ + 3 * j, b_ + 3 * next_corner(j)));
    return t;
  }
  MEETC_HD int on_b(int i) { return carrier_by_edges(twist(i, 0), twist(i, 1), twist(i, 2)); }
  MEETC_HD int on_a(int j) { return carrier_by_edges(twist(0, j), twist(1, j), twist(2, j)); }

  // Where no corner lies in the other plane, two edges of each triangle cross the other plane. The twists of these tell
  // whether one crossing lies between the two of the other triangle. False: some sign is 0.
  MEETC_HD bool by_four_twists() {
    int e[2], f[2];
    if (!two_edges(sa_, e) || !two_edges(sb_, f))
      return false;
    const int t[2][2] = {{twist(e[0], f[0]), twist(e[0], f[1])}, {twist(e[1], f[0]), twist(e[1], f[1])}};
    if (t[0][0] == 0 || t[0][1] == 0 || t[1][0] == 0 || t[1][1] == 0)
      return false;
    for (int k = 0; k < 2; ++k) {
      if (t[k][0] == t[k][1])
        found_.add(first_edge + e[k], open_face);
      if (t[0][k] == t[1][k])
        found_.add(open_face, first_edge + f[k]);
    }
    return true;
  }
  MEETC_HD static bool two_edges(const int *s, int *edges) {
    int n = 0;
    for (int i = 0; i < 3; ++i) {
      if (s[i] == 0)
        return false;
      if (s[i] != s[next_corner(i)])
        edges[n++] = i;
    }
    return true;
  }

  MEETC_HD void by_all_twists() {
    for (int i = 0; i < 3; ++i) {
      if (const int c = carrier(sa_, i, [this](int e) { return on_b(e); }); c >= 0)
        found_.add(sa_[i] == 0 ? i : first_edge + i, c);
      if (const int c = carrier(sb_, i, [this](int e) { return on_a(e); }); c >= 0)
        found_.add(c, sb_[i] == 0 ? i : first_edge + i);
    }
  }
  // Corner i, where it lies in the other plane, or else edge i, where it crosses it: the carrier of the other triangle.
  template <class On> MEETC_HD static int carrier(const int *s, int i, const On &on) {
    const int next = s[next_corner(i)];
    if (s[i] == 0) // one of the two edges at the corner leaves the plane
      return on(next != 0 ? i : i == 0 ? 2 : i - 1);
    return s[i] * next < 0 ? on(i) : -1;
  }

  // Whether the line of both planes, directed along N_A x N_B, enters A or B at the label.
  MEETC_HD bool enters(unsigned label) const {
    return enters(label_a(label), sa_, 1) || enters(label_b(label), sb_, -1);
  }
  MEETC_HD static bool enters(int carrier, const int *s, int direction) {
    if (carrier == open_face)
      return false;
    if (carrier >= first_edge) {
      const int i = carrier - first_edge;
      return direction * s[next_corner(i)] > direction * s[i];
    }
    const int next = direction * s[next_corner(carrier)], last = direction * s[next_corner(next_corner(carrier))];
    return next >= 0 && last <= 0 && (next != 0 || last != 0);
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
