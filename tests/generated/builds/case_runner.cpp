// A tiny program that is built with many compilers and flags. It decides the same hostile cases and prints for each
// predicate a hash of the answers, which must not depend on the build; how often a rung with a bound contradicted them,
// which must be never; and how often each such rung was unsure, which may differ.
//
// Cases are made of integers only (a conversion to float rounds once, in one way), so that they too are the same under
// any flags.
#include <cga/for_each.hpp>
#include <cga/header_only.hpp>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <meetc/decide/boxes.hpp>

namespace {

constexpr int cases = 20000;

std::uint64_t state = 0;
std::uint64_t bits() { // splitmix64
  std::uint64_t z = state += 0x9e3779b97f4a7c15;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  return z ^ z >> 31;
}
std::int64_t below(std::int64_t n) {
  return static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(n));
}

float from_bits(std::uint32_t b) {
  float f;
  std::memcpy(&f, &b, sizeof f);
  return f;
}
float pattern() {
  for (;;)
    if (const auto b = static_cast<std::uint32_t>(bits()); (b >> 23 & 0xff) != 0xff)
      return from_bits(b);
}

std::int64_t root(std::int64_t square) {
  std::int64_t low = 0, high = std::int64_t{1} << 31;
  while (low + 1 < high) {
    const std::int64_t middle = low + (high - low) / 2;
    (middle * middle <= square ? low : high) = middle;
  }
  return low;
}

// Makes one pair of rows: corners first, then a radius where there is one.
void make(int i, float *a, int fields_a, float *b, int fields_b) {
  const int corners_a = fields_a / 3, corners_b = fields_b / 3;
  std::int64_t p[9], q[9];
  const std::int64_t size = i % 3 == 0 ? 5 : std::int64_t{1} << (i % 3 == 1 ? 12 : 24);
  for (std::int64_t &c : p)
    c = below(size);
  for (std::int64_t &c : q)
    c = below(size);
  for (int j = 0; j < corners_b; ++j) { // corners of b lie on corners, edges and faces of a, in sixteenths
    const std::int64_t s = below(17), t = bits() & 1 ? 0 : below(17 - s);
    const int mode = static_cast<int>(below(3)), o = static_cast<int>(below(corners_a));
    const int u = (o + 1) % corners_a, v = (o + 2) % corners_a;
    for (int k = 0; k < 3; ++k)
      q[3 * j + k] = mode == 0 ? 16 * q[3 * j + k]
                               : 16 * p[3 * o + k] + s * (p[3 * u + k] - p[3 * o + k]) +
                                     t * (p[3 * v + k] - p[3 * o + k]) + (mode == 2 ? below(3) - 1 : 0);
  }
  std::int64_t square = 0;
  for (int k = 0; k < 3; ++k)
    square += (q[k] - 16 * p[k]) / 16 * ((q[k] - 16 * p[k]) / 16);
  for (int k = 0; k < 3 * corners_a; ++k)
    a[k] = static_cast<float>(16 * p[k]);
  for (int k = 0; k < 3 * corners_b; ++k)
    b[k] = static_cast<float>(q[k]);
  const std::int64_t reach = 16 * root(square), share = below(17);
  if (fields_a % 3)
    a[fields_a - 1] = static_cast<float>(fields_b % 3               ? reach * share / 16
                                         : reach + below(3) - 1 < 0 ? 0
                                                                    : reach + below(3));
  if (fields_b % 3)
    b[fields_b - 1] = static_cast<float>(reach - reach * share / 16);
  // The exponents are zero, one for all, one for each body, or bit patterns.
  const auto scale = [](float *r, int fields, int by) {
    const float step = from_bits(static_cast<std::uint32_t>(by < 0 ? 127 - 60 : 127 + 30) << 23);
    for (int k = 0; k < fields; ++k)
      for (int t = 0; t < (by < 0 ? -by : by); ++t)
        r[k] = r[k] * step; // no sum follows, so there is nothing to contract
  };
  switch (i % 14) {
  case 0: {
    const int by = static_cast<int>(below(6)) - 3;
    scale(a, fields_a, by), scale(b, fields_b, by);
    break;
  }
  case 1:
    scale(a, fields_a, static_cast<int>(below(6)) - 3);
    break;
  case 2:
    for (int k = 0; k < 3 * corners_b; ++k)
      if ((bits() & 7) == 0)
        b[k] = pattern();
    break;
  default:
    break;
  }
}

// The side of a box that holds the pair, with some room.
float box_side(const float *a, int fields_a, const float *b, int fields_b) {
  float low[3] = {a[0], a[1], a[2]}, high[3] = {a[0], a[1], a[2]}, widest = 0;
  const auto take = [&](const float *r, int fields) {
    for (int i = 0; i + fields % 3 < fields; ++i) {
      low[i % 3] = r[i] < low[i % 3] ? r[i] : low[i % 3];
      high[i % 3] = r[i] > high[i % 3] ? r[i] : high[i % 3];
    }
    if (fields % 3 && r[fields - 1] > widest)
      widest = r[fields - 1];
  };
  take(a, fields_a), take(b, fields_b);
  for (int k = 0; k < 3; ++k)
    widest = high[k] - low[k] > widest ? high[k] - low[k] : widest;
  return 2 * meetc::power_above(widest);
}

constexpr int rungs = 5; // fp32, fp64, fp64x2, and the box forms per object and static

template <class P> void bounded_answers(const float *a, const float *b, meetc::answer out[rungs]) {
  out[0] = meetc::certify<P, meetc::in_fp32>(a, b);
  out[1] = meetc::certify<P, meetc::in_fp64>(a, b);
  out[2] = meetc::certify<P, meetc::in_fp64x2>(a, b);
  out[3] = out[4] = meetc::answer::unsure;
  const float side = box_side(a, P::inputs_a, b, P::inputs_b);
  if (!meetc::box_holds<P>(side))
    return;
  out[3] = meetc::decide_sets<P>(meetc::boxed_signs<P, meetc::box_form::per_object>(a, b, side));
  out[4] = meetc::decide_sets<P>(meetc::boxed_signs<P, meetc::box_form::whole_box>(a, b, side));
}

template <class P, class Hit> void run(const char *name, Hit hit) {
  state = 42;
  std::uint64_t hash = 0xcbf29ce484222325;
  int hits = 0, wrong = 0, unsure[rungs] = {};
  for (int i = 0; i < cases; ++i) {
    float a[9], b[9];
    make(i, a, P::inputs_a, b, P::inputs_b);
    const bool answer = hit(a, b);
    hits += answer;
    hash = (hash ^ static_cast<std::uint64_t>(answer)) * 0x100000001b3;
    meetc::answer bounded[rungs];
    bounded_answers<P>(a, b, bounded);
    for (int r = 0; r < rungs; ++r) {
      unsure[r] += bounded[r] == meetc::answer::unsure;
      wrong += bounded[r] != meetc::answer::unsure && bounded[r] != meetc::to_answer(answer);
    }
  }
  std::printf("%s %016llx %d of %d wrong %d unsure", name, static_cast<unsigned long long>(hash), hits, cases, wrong);
  for (const int n : unsure)
    std::printf(" %d", n);
  std::printf("\n");
}

} // namespace

int main() {
  cga::for_each_predicate([]<class P, class A, class B>(const cga::detail::on_kinds<P, A, B> &p) {
    run<P>(p.name, [](const float *a, const float *b) { return P::hit(A::in(a), B::in(b)); });
  });
  return 0;
}
