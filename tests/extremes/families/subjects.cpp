#include "subjects.hpp"

#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace meetc::extremes_test {
namespace {

using generated_test::exact;
using generated_test::operand;

template <class P, class T> int plain(const float *a, const float *b) {
  return decided<P>(meetc::plain_signs<P, T>(a, b));
}

template <class P> bool integers_hold(const float *a, const float *b) {
  meetc::sign s[P::atoms];
  all_signs<P>(meetc::integer_signs<P>(a, b), s);
  exact x[P::inputs_a], y[P::inputs_b];
  for (int i = 0; i < P::inputs_a; ++i)
    x[i] = exact(static_cast<double>(a[i]));
  for (int i = 0; i < P::inputs_b; ++i)
    y[i] = exact(static_cast<double>(b[i]));
  bool same = true;
  each_stage<P>([&](auto stage) {
    using Stage = decltype(stage);
    exact v[Stage::atoms];
    meetc::stage_values<Stage>(x, y, v);
    for (int i = 0; i < Stage::atoms; ++i)
      same = same && sgn(v[i].v) == static_cast<int>(s[Stage::first + i]);
  });
  return same;
}

template <class P> void run_all(const float *a, const float *b) {
  meetc::sign_set sets[P::atoms];
  meetc::sign s[P::atoms];
  all_signs<P>(meetc::bounded_signs<P, meetc::in_fp32>(a, b), sets);
  all_signs<P>(meetc::bounded_signs<P, meetc::in_fp64>(a, b), sets);
  all_signs<P>(meetc::bounded_signs<P, meetc::in_fp64x2>(a, b), sets);
  all_signs<P>(meetc::exact_signs<P>(a, b), s);
  all_signs<P>(meetc::integer_signs<P>(a, b), s);
  for (const float side : {0x1p-10F, 1.0F, 0x1p10F}) {
    all_signs<P>(meetc::boxed_signs<P, meetc::box_form::per_object>(a, b, side), sets);
    all_signs<P>(meetc::boxed_signs<P, meetc::box_form::whole_box>(a, b, side), sets);
  }
}

using answer_function = int (*)(const float *, const float *);

template <class P, answer_function Hit> subject make(const char *name, shape a, shape b, bool surface) {
  return {name,
          a,
          b,
          surface,
          lone_sign<P>,
          [](const float *x, const float *y, float side, const int *known) { return check<P>(x, y, side, known, Hit); },
          truth_of<P>,
          Hit,
          [](const float *x, const float *y) { return decided<P>(meetc::exact_signs<P>(x, y)); },
          plain<P, float>,
          plain<P, double>,
          integers_hold<P>,
          run_all<P>};
}

template <class P, shape A, shape B> int hit(const float *x, const float *y) {
  return P::hit(operand<A>(x), operand<B>(y));
}
template <class P, shape A, shape B> subject decision(const char *name, bool surface = false) {
  return make<P, hit<P, A, B>>(name, A, B, surface);
}

using enum shape;
int side_of_triangle(const float *x, const float *y) {
  return static_cast<int>(cga::side(operand<triangle>(x), operand<point>(y)));
}
int side_of_sphere(const float *x, const float *y) {
  return static_cast<int>(cga::side(operand<sphere>(x), operand<point>(y)));
}
int twist(const float *x, const float *y) {
  return static_cast<int>(cga::twist(operand<segment>(x), operand<segment>(y)));
}

const subject all[] = {
    decision<cga::segment_segment, segment, segment>("segment_segment"),
    decision<cga::point_triangle, point, triangle>("point_triangle"),
    decision<cga::segment_triangle, segment, triangle>("segment_triangle"),
    decision<cga::triangle_triangle, triangle, triangle>("triangle_triangle"),
    decision<cga::sphere_sphere, sphere, sphere>("sphere_sphere", true),
    decision<cga::ball_ball, sphere, sphere>("ball_ball"),
    decision<cga::ball_segment, sphere, segment>("ball_segment"),
    decision<cga::sphere_segment, sphere, segment>("sphere_segment", true),
    decision<cga::ball_triangle, sphere, triangle>("ball_triangle"),
    decision<cga::sphere_triangle, sphere, triangle>("sphere_triangle", true),
    make<cga::side_triangle_point_sign, side_of_triangle>("side_triangle_point", triangle, point, false),
    make<cga::side_sphere_point_sign, side_of_sphere>("side_sphere_point", sphere, point, false),
    make<cga::twist_segment_segment_sign, twist>("twist_segment_segment", segment, segment, false),
};

} // namespace

std::span<const subject> subjects() {
  return all;
}

const subject &subject_named(const char *name) {
  for (const subject &s : all)
    if (std::strcmp(s.name, name) == 0)
      return s;
  throw std::invalid_argument(name);
}

float box_side(shape a, const row &x, shape b, const row &y) {
  double widest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = x[axis], high = low;
    for (const auto &[kind, r] : {std::pair(a, &x), std::pair(b, &y)})
      for (std::size_t i = axis; i < 3 * static_cast<std::size_t>(generated_test::points_of(kind)); i += 3) {
        low = std::min(low, static_cast<double>((*r)[i]));
        high = std::max(high, static_cast<double>((*r)[i]));
      }
    const meetc::double_double width = meetc::two_sum(high, -low);
    widest = std::max(widest, width.lo > 0 ? std::nextafter(width.hi, HUGE_VAL) : width.hi);
  }
  for (const auto &[kind, r] : {std::pair(a, &x), std::pair(b, &y)})
    if (generated_test::padded(kind))
      widest = std::max(widest, static_cast<double>(r->back()));
  int e = 0;
  const double m = std::frexp(widest, &e); // widest = m 2^e, 1/2 <= m < 1
  e -= m == 0.5;
  return e > 127 ? 0 : std::ldexp(1.0F, std::max(e, -149));
}

std::string text(const pair_of_rows &p) {
  std::ostringstream out;
  out << std::hexfloat << "a = {";
  for (const float f : p.a)
    out << ' ' << f;
  out << " } b = {";
  for (const float f : p.b)
    out << ' ' << f;
  out << " }";
  return out.str();
}

} // namespace meetc::extremes_test
