// A user's program with any flags: batches of inputs near zero through the headers' certified rungs, in loops that a
// compiler may vectorise, against integers. No certified answer may be wrong.
//
//   hostile            in the environment of the process
//   hostile words      and again under every control word that is not the standard one
//
// With HOSTILE_FEW defined it has one predicate of each sort, because compiling them all takes most of a test's time.
#include "rows.hpp"
#include "words.hpp"

#include <cga/cga.hpp>
#include <cga/header_only.hpp>
#include <meetc/decide/boxes.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>

namespace {

struct tally {
  long cases = 0, certified = 0, wrong = 0, hit_wrong = 0;
} total;
bool boxed_rungs_too = true;                // they do not ask the control word
const decltype(plain_word) *word = nullptr; // that hits are taken under
// The control word while a batch is answered.
std::unique_ptr<other_word> under_the_word() {
  return std::unique_ptr<other_word>(word ? new other_word(*word) : nullptr);
}

template <class P> void check_decisions() {
  const std::size_t n = word ? 3000 : 20000;
  std::vector<float> a, b;
  make_rows(P::inputs_a, P::inputs_b, n, a, b);
  const auto row_a = [&](std::size_t i) { return a.data() + i * P::inputs_a; };
  const auto row_b = [&](std::size_t i) { return b.data() + i * P::inputs_b; };
  std::vector<unsigned char> truth(n), hit(n);
  for (std::size_t i = 0; i < n; ++i)
    truth[i] = meetc::decide<P>(meetc::integer_signs<P>(row_a(i), row_b(i)));
  std::vector<meetc::answer> answers[5];
  for (auto &one : answers)
    one.assign(n, meetc::answer::unsure);
  {
    const auto changed = under_the_word();
    for (std::size_t i = 0; i < n; ++i)
      hit[i] = meetc::decide_certified<P>(row_a(i), row_b(i));
    for (std::size_t i = 0; i < n; ++i)
      answers[0][i] = meetc::certify<P, meetc::in_fp32>(row_a(i), row_b(i));
    for (std::size_t i = 0; i < n; ++i)
      answers[1][i] = meetc::certify<P, meetc::in_fp64>(row_a(i), row_b(i));
    for (std::size_t i = 0; i < n; ++i)
      answers[2][i] = meetc::certify<P, meetc::in_fp64x2>(row_a(i), row_b(i));
  }
  if (boxed_rungs_too) {
    // Each pair in its own box, the least power of two that holds its differences and lengths.
    std::vector<float> side(n);
    for (std::size_t i = 0; i < n; ++i) {
      float most = 0;
      for (int k = 0; k < P::inputs_a; ++k)
        most = std::fmax(most, std::fabs(row_a(i)[k]));
      for (int k = 0; k < P::inputs_b; ++k)
        most = std::fmax(most, std::fabs(row_b(i)[k]));
      side[i] = meetc::power_above(2 * most);
    }
    for (std::size_t i = 0; i < n; ++i)
      if (meetc::box_holds<P>(side[i])) {
        using meetc::box_form;
        using meetc::boxed_signs;
        answers[3][i] = meetc::decide_sets<P>(boxed_signs<P, box_form::per_object>(row_a(i), row_b(i), side[i]));
        answers[4][i] = meetc::decide_sets<P>(boxed_signs<P, box_form::whole_box>(row_a(i), row_b(i), side[i]));
      }
  }
  for (std::size_t i = 0; i < n; ++i) {
    ++total.cases;
    total.hit_wrong += hit[i] != truth[i];
    for (const auto &one : answers) {
      total.certified += one[i] != meetc::answer::unsure;
      total.wrong += one[i] == (truth[i] ? meetc::answer::no : meetc::answer::yes);
    }
  }
}

// An operand that is a row.
template <int Fields> struct operand {
  const float *row;
  friend void to_row(const operand &x, float *out) { std::copy_n(x.row, Fields, out); }
};
// One bounded rung, as the entry points run it: unsure in any environment but the standard one.
template <class P, class A> meetc::sign_set sign_set_by(const float *row_a, const float *row_b) {
  if (!meetc::standard_environment())
    return meetc::sign_set::all();
  const meetc::sign_set s = meetc::certify_sign_here<P, A>(meetc::after_check(row_a), meetc::after_check(row_b));
  return {meetc::before_return(s.bits)};
}

template <class P> void check_signs() {
  const std::size_t n = word ? 3000 : 40000;
  std::vector<float> a, b;
  make_rows(P::inputs_a, P::inputs_b, n, a, b);
  std::vector<meetc::sign_set> fp32(n, meetc::sign_set::all()), fp64 = fp32;
  std::vector<meetc::sign> sign(n);
  {
    const auto changed = under_the_word();
    for (std::size_t i = 0; i < n; ++i)
      fp32[i] = sign_set_by<P, meetc::in_fp32>(&a[i * P::inputs_a], &b[i * P::inputs_b]);
    for (std::size_t i = 0; i < n; ++i)
      fp64[i] = sign_set_by<P, meetc::in_fp64>(&a[i * P::inputs_a], &b[i * P::inputs_b]);
    for (std::size_t i = 0; i < n; ++i)
      sign[i] = meetc::sign_certified<P>(operand<P::inputs_a>{&a[i * P::inputs_a]},
                                         operand<P::inputs_b>{&b[i * P::inputs_b]});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const meetc::sign truth = meetc::decide_sign<P>(meetc::integer_signs<P>(&a[i * P::inputs_a], &b[i * P::inputs_b]));
    ++total.cases;
    total.hit_wrong += sign[i] != truth;
    for (const meetc::sign_set s : {fp32[i], fp64[i]}) {
      total.certified += s.bits != 7;
      total.wrong += !(s.bits & meetc::sign_set::of(truth).bits);
    }
  }
}

// Error-free transforms on arrays, fed with products and sums that a compiler would like to fuse.
long inexact_transforms() {
  constexpr std::size_t n = 100000;
  std::vector<double> x(n), y(n), z(n), sum(n), rest(n), product(n), low(n);
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = static_cast<double>(any(-0x3fffffff, 0x3fffffff)) * 0x1p22 + any(0, 0x3fffff);
    y[i] = static_cast<double>(any(-0x3fffffff, 0x3fffffff)) * 0x1p22 + any(0, 0x3fffff);
    z[i] = any(0, 1) ? -(x[i] * y[i]) : static_cast<double>(any(-0x3fffffff, 0x3fffffff)) * std::ldexp(1.0, any(0, 60));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const meetc::double_double s = meetc::two_sum(x[i] * y[i], z[i]);
    sum[i] = s.hi, rest[i] = s.lo;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const meetc::double_double p = meetc::two_product(x[i], y[i]);
    product[i] = p.hi, low[i] = p.lo;
  }
  long wrong = 0;
  for (std::size_t i = 0; i < n; ++i) {
    using meetc::int128;
    const volatile double rounded = x[i] * y[i];
    wrong += static_cast<int128>(sum[i]) + static_cast<int128>(rest[i]) !=
             static_cast<int128>(rounded) + static_cast<int128>(z[i]);
    wrong += static_cast<int128>(product[i]) + static_cast<int128>(low[i]) !=
             static_cast<int128>(x[i]) * static_cast<int128>(y[i]);
  }
  return wrong;
}

void check_all() {
  check_decisions<cga::ball_segment>();
  check_decisions<cga::point_triangle>();
  check_signs<cga::side_sphere_point_sign>();
#ifndef HOSTILE_FEW
  check_decisions<cga::ball_ball>();
  check_decisions<cga::sphere_sphere>();
  check_decisions<cga::segment_segment>();
  check_decisions<cga::segment_triangle>();
  check_signs<cga::side_triangle_point_sign>();
  check_signs<cga::twist_segment_segment_sign>();
#endif
}

// The corner of a triangle that is so large that products of differences overflow: NaN must not be taken for an answer.
bool large_triangle_holds() {
  constexpr float h = 0x1p103F;
  const cga::triangle<float> t{{h, -h, -h}, {-h, h, 0}, {h, -h, h}};
  return cga::point_triangle::hit({0, 0, 0}, t) && cga::point_triangle::filter({0, 0, 0}, t) != meetc::answer::no;
}

} // namespace

int main(int argc, char **argv) {
  const bool standard = meetc::standard_environment();
  const unsigned faults = meetc::self_test();
  std::printf("standard %d, faults %u: %s\n", standard, faults, meetc::text_of_faults(faults));
  boxed_rungs_too = meetc::standard_control_word(); // what else is wrong they see themselves
  check_all();
  total.hit_wrong += !large_triangle_holds();
  std::printf("%ld cases, %ld certified, %ld certified wrong, %ld hits wrong\n", total.cases, total.certified,
              total.wrong, total.hit_wrong);
  if (standard)
    std::printf("%ld transforms inexact\n", inexact_transforms());
  if (argc > 1 && std::strcmp(argv[1], "words") == 0) {
    total = {};
    boxed_rungs_too = false;
    int noticed = 0, missed = 0, lacking = 0;
    for (const auto &w : strange_words) {
      bool kept, seen;
      {
        const other_word changed(w);
        kept = changed.kept;
        seen = !meetc::standard_environment() && meetc::self_test() != 0;
      }
      ++(!kept ? lacking : seen ? noticed : missed);
      word = &w;
      check_all();
    }
    std::printf("words: %d noticed, %d missed, %d lacking; %ld certified wrong, %ld hits wrong\n", noticed, missed,
                lacking, total.wrong, total.hit_wrong);
  }
}
