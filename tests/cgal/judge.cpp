#include "tests/cgal/judge.hpp"

#include <algorithm>
#include <array>
#include <CGAL/box_intersection_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>

namespace meetc::cgal_test {
namespace {

using predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using rationals = CGAL::Simple_cartesian<CGAL::Gmpq>;

template <class Kernel>
using set = std::variant<typename Kernel::Point_3, typename Kernel::Segment_3, typename Kernel::Triangle_3>;

template <class Kernel> typename Kernel::Point_3 point(const float *p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

// The point, segment or triangle that some corners span. The ends of collinear corners are the lexicographic extremes.
template <class Kernel> set<Kernel> reduced(const float *row, int corners) {
  using point_3 = typename Kernel::Point_3;
  std::array<point_3, 3> p;
  for (int i = 0; i < corners; ++i)
    p[static_cast<std::size_t>(i)] = point<Kernel>(row + 3 * i);
  if (corners == 3 && !CGAL::collinear(p[0], p[1], p[2]))
    return typename Kernel::Triangle_3(p[0], p[1], p[2]);
  const auto less = [](const point_3 &x, const point_3 &y) { return CGAL::lexicographically_xyz_smaller(x, y); };
  const auto [low, high] = std::minmax_element(p.begin(), p.begin() + corners, less);
  if (*low == *high)
    return *low;
  return typename Kernel::Segment_3(*low, *high);
}

struct touch {
  template <class X, class Y> bool operator()(const X &x, const Y &y) const { return CGAL::do_intersect(x, y); }
  bool operator()(const predicates::Point_3 &x, const predicates::Point_3 &y) const { return x == y; }
  bool operator()(const predicates::Point_3 &x, const predicates::Segment_3 &y) const { return y.has_on(x); }
  bool operator()(const predicates::Segment_3 &x, const predicates::Point_3 &y) const { return x.has_on(y); }
};

CGAL::Gmpq square(const CGAL::Gmpq &q) {
  return q * q;
}

bool spheres_touch(const float *a, const float *b, bool surface) {
  const CGAL::Gmpq d = CGAL::squared_distance(point<rationals>(a), point<rationals>(b));
  const CGAL::Gmpq r(static_cast<double>(a[3])), s(static_cast<double>(b[3]));
  return d <= square(r + s) && (!surface || d >= square(r - s));
}

bool sphere_touches(const float *a, const float *row, int corners, bool surface) {
  const auto centre = point<rationals>(a);
  const CGAL::Gmpq r = square(CGAL::Gmpq(static_cast<double>(a[3])));
  const set<rationals> b = reduced<rationals>(row, corners);
  const CGAL::Gmpq nearest =
      std::visit([&](const auto &x) -> CGAL::Gmpq { return CGAL::squared_distance(centre, x); }, b);
  if (nearest > r)
    return false;
  if (!surface)
    return true;
  for (int i = 0; i < corners; ++i)
    if (CGAL::squared_distance(centre, point<rationals>(row + 3 * i)) >= r)
      return true;
  return false;
}

using box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

std::vector<box> boxes_of(const body &b) {
  std::vector<box> out;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const float *row = b.row(i);
    double lo[3], hi[3];
    for (int k = 0; k < 3; ++k) {
      lo[k] = hi[k] = static_cast<double>(row[k]);
      if (b.kind == shape::sphere) { // the sum may round: one step further out
        const auto r = static_cast<double>(row[3]);
        lo[k] = std::nextafter(lo[k] - r, -std::numeric_limits<double>::infinity());
        hi[k] = std::nextafter(hi[k] + r, std::numeric_limits<double>::infinity());
      } else {
        for (std::size_t c = 1; c < floats_of(b.kind) / 3; ++c) {
          lo[k] = std::min(lo[k], static_cast<double>(row[3 * c + static_cast<std::size_t>(k)]));
          hi[k] = std::max(hi[k], static_cast<double>(row[3 * c + static_cast<std::size_t>(k)]));
        }
      }
    }
    out.emplace_back(lo, hi, static_cast<std::uint32_t>(i));
  }
  return out;
}

} // namespace

pair_list touching_pairs(const body &a, const body &b, bool surface, std::size_t *candidates) {
  if (a.kind != shape::sphere && (b.kind == shape::sphere || surface))
    throw std::invalid_argument("the sphere comes first");
  std::vector<box> boxes_a = boxes_of(a), boxes_b = boxes_of(b);
  const auto corners = [](const body &x) { return static_cast<int>(floats_of(x.kind) / 3); };
  // Each element is reduced once.
  std::vector<set<predicates>> sets_a, sets_b;
  if (a.kind != shape::sphere)
    for (const auto &[from, to] : {std::pair(&a, &sets_a), std::pair(&b, &sets_b)})
      for (std::size_t i = 0; i < from->size(); ++i)
        to->push_back(reduced<predicates>(from->row(i), corners(*from)));
  pair_list out;
  std::size_t asked = 0;
  CGAL::box_intersection_d(
      boxes_a.begin(), boxes_a.end(), boxes_b.begin(), boxes_b.end(), [&](const box &x, const box &y) {
        const std::uint32_t i = x.info(), j = y.info();
        ++asked;
        const bool hit = a.kind != shape::sphere   ? std::visit(touch(), sets_a[i], sets_b[j])
                         : b.kind == shape::sphere ? spheres_touch(a.row(i), b.row(j), surface)
                                                   : sphere_touches(a.row(i), b.row(j), corners(b), surface);
        if (hit)
          out.emplace_back(i, j);
      });
  std::sort(out.begin(), out.end());
  if (candidates)
    *candidates = asked;
  return out;
}

} // namespace meetc::cgal_test
