// A user's program that changes the control word around calls: before a call, after it, and between two calls on the
// same operands. A value that was computed under one word must not be used under another, however much a compiler
// inlines and moves.
#include "rows.hpp"
#include "words.hpp"

#include <cga/cga.hpp>
#include <cga/header_only.hpp>
#include <meetc/decide/boxes.hpp>

#include <cstdio>
#include <vector>

namespace {

cga::triangle<float> triangle_of(const float *r) {
  return {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}};
}

// The program's own work on its operands includes differences that hit() computes as well. A compiler that inlines
// hit() would rather compute them once.
volatile float seen;
void look(const cga::point<float> &p, const cga::point<float> &q) {
  seen = q.x - p.x;
  seen = q.y - p.y;
  seen = q.z - p.z;
}
void look(const cga::sphere<float> &s, const cga::sphere<float> &t) {
  look(s.c, t.c);
  seen = s.r + t.r;
}
void look(const cga::point<float> &p, const cga::triangle<float> &t) {
  look(t.a, t.b), look(t.a, t.c), look(t.b, t.c), look(p, t.a), look(p, t.b), look(p, t.c);
}
void look(const cga::segment<float> &s, const cga::triangle<float> &t) {
  look(s.p, t), look(s.q, t);
}

// The answer under the word.
template <class P, class A, class B> __attribute__((noinline)) bool asked_under(A a, B b, decltype(plain_word) word) {
  set_control_word(word);
  const bool hit = P::hit(a, b);
  set_control_word(plain_word);
  return hit;
}
// The answer under the plain word, after the program has used the same operands under the other.
template <class P, class A, class B> __attribute__((noinline)) bool asked_after(A a, B b, decltype(plain_word) word) {
  set_control_word(word);
  look(a, b);
  set_control_word(plain_word);
  return P::hit(a, b);
}
// The answer under the plain word, before the program uses the same operands under the other.
template <class P, class A, class B> __attribute__((noinline)) bool asked_before(A a, B b, decltype(plain_word) word) {
  const bool hit = P::hit(a, b);
  set_control_word(word);
  look(a, b);
  set_control_word(plain_word);
  return hit;
}

bool may_compute_under(decltype(plain_word) word) {
  const other_word changed(word);
  return meetc::exceptions_are_masked();
}

template <class P, class A, class B> long wrong_of(const A &of_a, const B &of_b, std::size_t n) {
  std::vector<float> a, b;
  make_rows(P::inputs_a, P::inputs_b, n, a, b);
  long wrong = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (i % 2) { // whole numbers of the least step, which flush-to-zero loses
      for (int k = 0; k < P::inputs_a; ++k)
        a[i * P::inputs_a + static_cast<std::size_t>(k)] = static_cast<float>(any(0, 9)) * 0x1p-149F;
      for (int k = 0; k < P::inputs_b; ++k)
        b[i * P::inputs_b + static_cast<std::size_t>(k)] = static_cast<float>(any(0, 9)) * 0x1p-149F;
    }
    const float *x = a.data() + i * P::inputs_a, *y = b.data() + i * P::inputs_b;
    const bool truth = meetc::decide<P>(meetc::integer_signs<P>(x, y));
    const auto p = of_a(x);
    const auto q = of_b(y);
    for (const auto word : strange_words) {
      wrong += asked_under<P>(p, q, word) != truth;
      if (may_compute_under(word))
        wrong += (asked_after<P>(p, q, word) != truth) + (asked_before<P>(p, q, word) != truth);
    }
  }
  return wrong;
}

} // namespace

int main() {
  const auto sphere_of = [](const float *r) { return cga::sphere<float>{{r[0], r[1], r[2]}, r[3]}; };
  const auto point_of = [](const float *r) { return cga::point<float>{r[0], r[1], r[2]}; };
  const auto segment_of = [](const float *r) { return cga::segment<float>{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}}; };
  long wrong = wrong_of<cga::ball_ball>(sphere_of, sphere_of, 4000);
  wrong += wrong_of<cga::point_triangle>(point_of, triangle_of, 2000);
  wrong += wrong_of<cga::segment_triangle>(segment_of, triangle_of, 2000);
  std::printf("%ld wrong beside changes of the control word\n", wrong);
  return wrong != 0;
}
