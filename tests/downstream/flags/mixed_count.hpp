// Counts the wrong answers of this translation unit. MIXED_CALLER: an attribute of the functions that ask.
// MIXED_FEW: without the predicate whose compilation takes most of a test's time.
#pragma once
#include "rows.hpp"

#include <cga/cga.hpp>
#include <cga/header_only.hpp>
#include <meetc/decide/boxes.hpp>

#ifndef MIXED_CALLER
#define MIXED_CALLER
#endif

namespace {

template <class P> MIXED_CALLER long wrong_of(std::size_t n) {
  std::vector<float> a, b;
  make_rows(P::inputs_a, P::inputs_b, n, a, b);
  long wrong = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const float *x = a.data() + i * P::inputs_a, *y = b.data() + i * P::inputs_b;
    const bool truth = meetc::decide<P>(meetc::integer_signs<P>(x, y));
    wrong += meetc::decide_certified<P>(x, y) != truth;
    wrong += meetc::decide<P>(meetc::exact_signs<P>(x, y)) != truth;
    wrong += meetc::certify<P, meetc::in_fp32>(x, y) == (truth ? meetc::answer::no : meetc::answer::yes);
    wrong += meetc::certify<P, meetc::in_fp64>(x, y) == (truth ? meetc::answer::no : meetc::answer::yes);
    wrong += meetc::certify<P, meetc::in_fp64x2>(x, y) == (truth ? meetc::answer::no : meetc::answer::yes);
  }
  return wrong;
}

// The corner of a triangle that is so large that products of differences overflow.
MIXED_CALLER long wrong_of_large() {
  long wrong = 0;
  for (const float h : {0x1p103F, 0x1.8p103F, 0x1p104F, 0x1p110F, 0x1p126F}) {
    const cga::point<float> p{0, 0, 0};
    const cga::triangle<float> t{{h, -h, -h}, {-h, h, 0}, {h, -h, h}};
    wrong += !cga::point_triangle::hit(p, t);
#ifndef MIXED_FEW
    wrong += !cga::segment_triangle::hit({p, p}, t);
#endif
    wrong += cga::point_triangle::filter(p, t) == meetc::answer::no;
  }
  return wrong;
}

MIXED_CALLER long wrong_of_all(std::size_t n) {
  long wrong = wrong_of<cga::point_triangle>(n) + wrong_of<cga::ball_segment>(n) + wrong_of_large();
#ifndef MIXED_FEW
  wrong += wrong_of<cga::segment_triangle>(n);
#endif
  return wrong;
}

} // namespace
