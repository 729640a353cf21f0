// The contact code of a pair of rows: two triangles, or a segment and a triangle. It is never wrong, and the same on each
// device, since it is a function of exact signs.
#ifndef MEETC_CONTACT_CONTACT_HPP
#define MEETC_CONTACT_CONTACT_HPP

#include <meetc/contact/crossing.hpp>
#include <meetc/contact/flat.hpp>
#include <meetc/contact/hulls.hpp>
#include <meetc/table/table.hpp>

MEETC_NAMESPACE(meetc) {

MEETC_HD constexpr bool all_zero(const int *s, int n) {
  for (int i = 0; i < n; ++i)
    if (s[i] != 0)
      return false;
  return true;
}

// No code means anything where a sign is not known.
template <class Sides>
MEETC_NOINLINE MEETC_HD contact_code contact_of_hulls(contact_signs<Sides> &signs, const float *a, int corners,
                                                      const float *b) {
  const element_hull<Sides> of_a(signs, a, corners), of_b(signs, b, 3);
  if (of_a.count() == 3 && of_b.count() == 3 && corners == 3) {
    // Both lie in one plane, so that their normals are parallel, and one axis serves both.
    const int turn_b = signs.turn(of_a.axis(), b, b + 3, b + 6);
    flat_triangles both(signs, a, b, of_a.axis(), of_a.turn(), turn_b);
    return signs.known() ? both.code() : contact_code();
  }
  return hull_contact<Sides>(signs, of_a, of_b).code(corners == 2);
}

// Rows of three corners.
template <class Sides>
MEETC_HD contact_code contact_of_triangles(contact_signs<Sides> &signs, const float *a, const float *b) {
  int sa[3], sb[3];
  for (int i = 0; i < 3; ++i)
    sa[i] = signs.side(b, a + 3 * i);
  for (int i = 0; i < 3; ++i)
    sb[i] = signs.side(a, b + 3 * i);
  if (!signs.known())
    return contact_code();
  if (all_zero(sa, 3) || all_zero(sb, 3))
    return contact_of_hulls(signs, a, 3, b);
  return crossing_triangles<Sides>(signs, a, b, sa, sb).code();
}
// A row of two corners and one of three.
template <class Sides>
MEETC_HD contact_code contact_of_segment(contact_signs<Sides> &signs, const float *a, const float *b) {
  const int start = signs.side(b, a), end = signs.side(b, a + 3);
  if (!signs.known())
    return contact_code();
  if (start == 0 && end == 0)
    return contact_of_hulls(signs, a, 2, b);
  label_list found;
  if (start * end <= 0) {
    int w[3];
    for (int j = 0; j < 3; ++j)
      w[j] = signs.det(a, a + 3, b + 3 * j, b + 3 * next_corner(j));
    if (const int c = carrier_by_edges(w[0], w[1], w[2]); c >= 0)
      found.add(start == 0 ? 0 : end == 0 ? 1 : first_edge, c);
  }
  return contact_code(found.data(), found.count());
}
template <int Corners, class Sides>
MEETC_HD contact_code contact_of(contact_signs<Sides> &signs, const float *a, const float *b) {
  static_assert(Corners == 2 || Corners == 3);
  if constexpr (Corners == 3)
    return contact_of_triangles(signs, a, b);
  else
    return contact_of_segment(signs, a, b);
}

// predicate_info::contacts for elements of `Corners` corners, and of three.
template <class Side, int Corners>
void contact_codes(const float *a, const float *b, const index_pair *pairs, std::size_t n, std::uint64_t *codes) {
  contact_signs<exact_sides<Side>> signs;
  for (std::size_t i = 0; i < n; ++i)
    codes[i] =
        contact_of<Corners>(signs, a + std::size_t{3} * Corners * pairs[i].a, b + std::size_t{9} * pairs[i].b).bits();
}

} // MEETC_NAMESPACE(meetc)

#endif
