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

template <class Side>
MEETC_NOINLINE MEETC_HD contact_code contact_of_hulls(const float *a, int corners, const float *b) {
  const element_hull<Side> of_a(a, corners), of_b(b, 3);
  if (of_a.count() == 3 && of_b.count() == 3 && corners == 3) {
    // Both lie in one plane, so that their normals are parallel, and one axis serves both.
    const int turn_b = contact_signs<Side>::turn(of_a.axis(), b, b + 3, b + 6);
    return flat_triangles<Side>(a, b, of_a.axis(), of_a.turn(), turn_b).code();
  }
  return hull_contact<Side>(of_a, of_b).code(corners == 2);
}

// Rows of three corners, under the standard word.
template <class Side> MEETC_HD contact_code contact_of_triangles(const float *a, const float *b) {
  using signs = contact_signs<Side>;
  int sa[3], sb[3];
  for (int i = 0; i < 3; ++i)
    sa[i] = signs::side(b, a + 3 * i);
  for (int i = 0; i < 3; ++i)
    sb[i] = signs::side(a, b + 3 * i);
  if (all_zero(sa, 3) || all_zero(sb, 3))
    return contact_of_hulls<Side>(a, 3, b);
  return crossing_triangles<Side>(a, b, sa, sb).code();
}
// A row of two corners and one of three.
template <class Side> MEETC_HD contact_code contact_of_segment(const float *a, const float *b) {
  using signs = contact_signs<Side>;
  const int start = signs::side(b, a), end = signs::side(b, a + 3);
  if (start == 0 && end == 0)
    return contact_of_hulls<Side>(a, 2, b);
  label_list found;
  if (start * end <= 0) {
    int w[3];
    for (int j = 0; j < 3; ++j)
      w[j] = signs::det(a, a + 3, b + 3 * j, b + 3 * next_corner(j));
    if (const int c = carrier_by_edges(w[0], w[1], w[2]); c >= 0)
      found.add(start == 0 ? 0 : end == 0 ? 1 : first_edge, c);
  }
  return contact_code(found.data(), found.count());
}

// predicate_info::contacts for elements of `Corners` corners, and of three.
template <class Side, int Corners>
void contact_codes(const float *a, const float *b, const index_pair *pairs, std::size_t n, std::uint64_t *codes) {
  static_assert(Corners == 2 || Corners == 3);
  for (std::size_t i = 0; i < n; ++i) {
    const float *const row_a = a + std::size_t{3} * Corners * pairs[i].a, *const row_b =
                                                                              b + std::size_t{9} * pairs[i].b;
    if constexpr (Corners == 3)
      codes[i] = contact_of_triangles<Side>(row_a, row_b).bits();
    else
      codes[i] = contact_of_segment<Side>(row_a, row_b).bits();
  }
}

} // MEETC_NAMESPACE(meetc)

#endif
