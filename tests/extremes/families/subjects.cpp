#include "subjects.hpp"

#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace meetc::extremes_test {
namespace {

using generated_test::exact;

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

// A predicate or a sign P as the public entry points of its kinds answer; hit(x, y) is theirs.
template <class P, class A, class B, class Hit> subject make(const char *name, Hit) {
  return {name,
          generated_test::shape_named(A::name),
          generated_test::shape_named(B::name),
          std::string_view(name).starts_with("sphere_"),
          lone_sign<P>,
          [](const float *x, const float *y, float side, const int *known) {
            return check<P>(x, y, side, known, [](const float *c, const float *d) { return Hit()(c, d); });
          },
          truth_of<P>,
          [](const float *x, const float *y) { return Hit()(x, y); },
          [](const float *x, const float *y) { return decided<P>(meetc::exact_signs<P>(x, y)); },
          plain<P, float>,
          plain<P, double>,
          integers_hold<P>,
          run_all<P>};
}

std::vector<subject> make_all() {
  std::vector<subject> out;
  cga::for_each_predicate([&out]<class P, class A, class B>(const cga::detail::on_kinds<P, A, B> &p) {
    const auto hit = [](const float *x, const float *y) { return static_cast<int>(P::hit(A::in(x), B::in(y))); };
    if (std::string_view(p.name) != "box_box")
      out.push_back(make<P, A, B>(p.name, hit));
  });
  cga::for_each_sign([&out]<class P, class A, class B>(const cga::detail::on_kinds<P, A, B> &p) {
    const auto sign = [](const float *x, const float *y) {
      return static_cast<int>(meetc::sign_certified<P>(A::in(x), B::in(y)));
    };
    out.push_back(make<P, A, B>(p.name, sign));
  });
  return out;
}
const std::vector<subject> &all() {
  static const std::vector<subject> made = make_all();
  return made;
}

} // namespace

std::span<const subject> subjects() {
  return all();
}

const subject &subject_named(const char *name) {
  for (const subject &s : all())
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
