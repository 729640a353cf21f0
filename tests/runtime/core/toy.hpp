// Toy kinds for the tests of core (boxes, balls and rods), and their answers by brute force.
#ifndef MEETC_TESTS_CORE_TOY_HPP
#define MEETC_TESTS_CORE_TOY_HPP

#include "meet/core/query/collide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace toy {

using meetc::answer;
using meetc::index_pair;
using meetc::kind_info;
using meetc::role;

// Turns a decision on two rows into a predicate's `decide`.
template <int FieldsA, int FieldsB, bool (*Hit)(const float *, const float *)>
void decide(meetc::row_array a, meetc::row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] =
        meetc::to_answer(Hit(a.rows + std::size_t{FieldsA} * pairs[i].a, b.rows + std::size_t{FieldsB} * pairs[i].b));
}

// A predicate with plain rungs only.
constexpr meetc::predicate_info plain(const char *name, const char *mode, const kind_info &a, const kind_info &b,
                                      meetc::decide_function fp32, meetc::decide_function exact = nullptr) {
  return {name, mode, &a, &b, {fp32, nullptr, nullptr, exact, nullptr}, {}, nullptr, 0, 0};
}

// Turns the box of one row into a kind's `boxes`.
template <int Fields, void (*Box)(const float *, float *, float *)>
void boxes_by(const float *rows, std::size_t n, float *out) {
  for (std::size_t i = 0; i < n; ++i)
    Box(rows + i * Fields, out + 6 * i, out + 6 * i + 3);
}

// ---- boxes: x0,y0,z0,x1,y1,z1; they hit where they overlap, closed ----
inline void box_box(const float *r, float lo[3], float hi[3]) {
  std::copy_n(r, 3, lo);
  std::copy_n(r + 3, 3, hi);
}
inline const char *box_fault(const float *r) {
  return r[0] <= r[3] && r[1] <= r[4] && r[2] <= r[5] ? nullptr : "low <= high";
}
inline bool boxes_hit(const float *a, const float *b) {
  bool hit = true;
  for (int k = 0; k < 3; ++k)
    hit &= a[k] <= b[k + 3] && b[k] <= a[k + 3];
  return hit;
}
inline constexpr role box_roles[6] = {role::x, role::y, role::z, role::x, role::y, role::z};
inline constexpr kind_info boxes{"box", "x0,y0,z0,x1,y1,z1", 6, box_roles, 0, boxes_by<6, box_box>, box_fault};
inline constexpr meetc::predicate_info box_box_hit =
    plain("box_box", "", boxes, boxes, decide<6, 6, boxes_hit>, decide<6, 6, boxes_hit>);

// ---- balls: x,y,z,r; they hit where they touch, in fp64 ----
inline void ball_box(const float *r, float lo[3], float hi[3]) {
  for (int k = 0; k < 3; ++k) {
    lo[k] = meetc::step_down(r[k] - r[3]);
    hi[k] = meetc::step_up(r[k] + r[3]);
  }
}
inline const char *ball_fault(const float *r) {
  return r[3] >= 0 ? nullptr : "r >= 0";
}
inline bool balls_hit(const float *a, const float *b) {
  double d2 = 0;
  for (int k = 0; k < 3; ++k)
    d2 += (static_cast<double>(a[k]) - b[k]) * (static_cast<double>(a[k]) - b[k]);
  const double r = static_cast<double>(a[3]) + b[3];
  return d2 <= r * r;
}
inline constexpr role ball_roles[4] = {role::x, role::y, role::z, role::length};
inline constexpr kind_info balls{"ball", "x,y,z,r", 4, ball_roles, 0, boxes_by<4, ball_box>, ball_fault};
inline constexpr meetc::predicate_info ball_ball_hit =
    plain("ball_ball", "solid", balls, balls, decide<4, 4, balls_hit>);

// ---- rods: two points, can be indexed; their boxes decide ----
inline void rod_box(const float *r, float lo[3], float hi[3]) {
  for (int k = 0; k < 3; ++k) {
    lo[k] = std::min(r[k], r[k + 3]);
    hi[k] = std::max(r[k], r[k + 3]);
  }
}
inline bool rods_hit(const float *a, const float *b) {
  float x[6], y[6];
  rod_box(a, x, x + 3);
  rod_box(b, y, y + 3);
  return boxes_hit(x, y);
}
inline constexpr kind_info rods{"rod", "x0,y0,z0,x1,y1,z1", 6, box_roles, 2, boxes_by<6, rod_box>, nullptr};
inline constexpr meetc::predicate_info rod_rod_hit = plain("rod_rod", "", rods, rods, decide<6, 6, rods_hit>);

// ---- balls against boxes ----
inline bool ball_hits_box(const float *a, const float *b) {
  double d2 = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = std::max({0.0, static_cast<double>(b[k]) - a[k], static_cast<double>(a[k]) - b[k + 3]});
    d2 += d * d;
  }
  return d2 <= static_cast<double>(a[3]) * a[3];
}
inline constexpr meetc::predicate_info ball_box_hit = plain("ball_box", "", balls, boxes, decide<4, 6, ball_hits_box>);

// ---- sets ----
using rows = std::vector<float>;

inline meetc::view view_of(const rows &r, const kind_info &kind) {
  const auto fields = static_cast<std::size_t>(kind.fields);
  return {r.data(), 0, fields * sizeof(float), nullptr, r.size() / fields};
}

inline float uniform(std::mt19937 &g, float lo, float hi) {
  return lo + (hi - lo) * (static_cast<float>(g() >> 8) * 0x1p-24f);
}

// n boxes of about `size` in a cube of `range` about `centre`.
inline rows some_boxes(std::size_t n, float range, float size, unsigned seed, float centre = 0) {
  std::mt19937 g(seed);
  rows r;
  for (std::size_t i = 0; i < n; ++i) {
    float b[6];
    for (int k = 0; k < 3; ++k) {
      b[k] = centre + uniform(g, -range, range);
      b[k + 3] = b[k] + uniform(g, 0, size);
    }
    r.insert(r.end(), b, b + 6);
  }
  return r;
}

inline rows some_balls(std::size_t n, float range, float size, unsigned seed) {
  std::mt19937 g(seed);
  rows r;
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k)
      r.push_back(uniform(g, -range, range));
    r.push_back(uniform(g, 0, size));
  }
  return r;
}

inline bool operator==(index_pair x, index_pair y) {
  return x.a == y.a && x.b == y.b;
}

inline bool same(const std::vector<index_pair> &x, const std::vector<index_pair> &y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](index_pair p, index_pair q) { return p == q; });
}

// Pairs whose boxes are not apart and that the predicate takes, in order; how many boxes were not apart.
struct truth {
  std::vector<index_pair> pairs;
  std::uint64_t candidates = 0;
};
inline truth brute(const rows &a, const rows &b, const meetc::predicate_info &p) {
  truth t;
  const std::size_t fa = static_cast<std::size_t>(p.a->fields), fb = static_cast<std::size_t>(p.b->fields);
  for (std::size_t i = 0; i < a.size() / fa; ++i)
    for (std::size_t j = 0; j < b.size() / fb; ++j) {
      float x[6], y[6];
      p.a->box(&a[i * fa], x, x + 3);
      p.b->box(&b[j * fb], y, y + 3);
      bool apart = false;
      for (int k = 0; k < 3; ++k)
        apart |= x[k + 3] < y[k] || y[k + 3] < x[k];
      if (apart)
        continue;
      ++t.candidates;
      const index_pair one{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)};
      answer said;
      p.decide[0](a.data(), b.data(), &one, 1, &said);
      if (said == answer::yes)
        t.pairs.push_back(one);
    }
  return t;
}

} // namespace toy

#endif
