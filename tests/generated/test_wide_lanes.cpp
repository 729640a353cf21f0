// Lanes of doubles: signs by exact doubles, by bounds in fp64 and by residues are never wrong, and limits that are too high
// are seen. With residues of 64 bits no pair of floats may ever show that, so residues of 16 bits stand in for them.
#include <meetc/simd/wide_decide.hpp>

#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/many_rows.hpp"

#include <algorithm>
#include <cga/cga.hpp>
#include <cga/cga_runtime.hpp>
#include <cga/header_only.hpp>

using namespace meetc::generated_test;
using meetc::answer;

namespace {

// Pairs of every family, and pairs whose numbers are integers of few bits, most of them degenerate somehow.
template <class P> many_rows hostile_rows(const P &p) {
  many_rows r(p, static_cast<std::uint32_t>(effort(300)));
  const meetc::predicate_info &info = named(cga::catalogue(), p.name);
  random_numbers random(12);
  const auto valid = [&random](const meetc::kind_info &kind, shape s, int bits) {
    row to(static_cast<std::size_t>(floats_of(s)));
    do {
      for (float &x : to)
        x = static_cast<float>(static_cast<int>(random.bits() % (2U << bits)) - (1 << bits));
      if (padded(s))
        to.back() = std::fabs(to.back());
    } while (kind.fault && kind.fault(to.data()));
    return to;
  };
  auto n = static_cast<std::uint32_t>(r.a.size()) / static_cast<std::uint32_t>(floats_of(p.a));
  for (int i = 0; i < effort(6000); ++i, ++n) {
    const row a = valid(*info.a, p.a, i % 12 + 1), b = valid(*info.b, p.b, i % 12 + 1);
    r.a.insert(r.a.end(), a.begin(), a.end());
    r.b.insert(r.b.end(), b.begin(), b.end());
    r.pairs.push_back({n, n});
  }
  return r;
}

struct tally {
  std::size_t wrong = 0, unsure = 0;
};
// Errors so large that residues alone prove signs other than zeros.
struct doubtful_bounds {
  static constexpr bool is_exact = false, by_power = false;
  template <class P, class Stage>
  static void values(const meetc::wide_rows<P> &rows, meetc::wide_lanes *v, meetc::wide_lanes *error,
                     meetc::wide_lanes *magnitude) {
    meetc::emitted_bounds::values<P, Stage>(rows, v, error, magnitude);
    for (int i = 0; i < Stage::atoms; ++i)
      error[i] = larger(magnitude_of(v[i]), error[i]);
  }
};
template <class P, class Width, class How = meetc::emitted_bounds>
tally run(const many_rows &r, const std::vector<answer> &truth) {
  std::vector<answer> out(r.pairs.size(), answer::no);
  meetc::decide_in_wide_lanes<P, Width, How>(r.a.data(), r.b.data(), r.pairs.data(), r.pairs.size(), out.data(),
                                             [](std::size_t) { return answer::unsure; });
  tally t;
  for (std::size_t i = 0; i < out.size(); ++i) {
    t.unsure += out[i] == answer::unsure;
    t.wrong += out[i] != answer::unsure && out[i] != truth[i];
  }
  return t;
}

} // namespace

TEST_CASE("wide lanes: residues are never wrong, and few pairs stay unsure") {
  int seen = 0, too_high = 0;
  for_each_predicate([&](auto p) {
    using P = typename decltype(p)::type;
    INFO(p.name);
    const many_rows r = hostile_rows(p);
    std::vector<answer> truth;
    for (const meetc::index_pair x : r.pairs)
      truth.push_back(meetc::to_answer(meetc::decide_exact<P>(r.a.data() + std::size_t{x.a} * P::inputs_a,
                                                              r.b.data() + std::size_t{x.b} * P::inputs_b)));
    const tally whole = run<P, meetc::residue_width<64>>(r, truth);
    CHECK(whole.wrong == 0);
    const tally few = run<P, meetc::residue_width<16>>(r, truth);
    CHECK(few.wrong == 0);
    CHECK(few.unsure >= whole.unsure);
    // One pair's functions know zeros by other means than residues. Neither leaves many more unsure than the other.
    std::size_t alone = 0;
    for (const meetc::index_pair x : r.pairs)
      alone += meetc::certify_here<P, meetc::in_fp64>(r.a.data() + std::size_t{x.a} * P::inputs_a,
                                                      r.b.data() + std::size_t{x.b} * P::inputs_b) == answer::unsure;
    CHECK(whole.unsure <= 2 * alone);
    CHECK(run<P, meetc::residue_width<16, 14, 48, 0>, doubtful_bounds>(r, truth).wrong == 0);
    seen += run<P, meetc::residue_width<16, 48, 48, 0>, doubtful_bounds>(r, truth).wrong > 0;
    too_high += run<P, meetc::residue_width<64, 62, 48, 1000>>(r, truth).wrong > 0;
  });
  CHECK(seen == 11);
  CHECK(too_high > 0);
}

namespace {

// Triangles with corners of a cube as long as differences can be where doubles below 2^Limit are exact, and segments that
// begin between two of their corners, up to a rounding.
template <int Limit> int wrong_by_midpoints() {
  using P = cga::segment_triangle;
  random_numbers random(19);
  const auto side = static_cast<int>(meetc::exact_steps<P, Limit>()) - 1;
  many_rows r;
  for (std::uint32_t n = 0; n < static_cast<std::uint32_t>(effort(60000)); ++n) {
    const auto corner = [&] {
      const auto i = static_cast<int>(random.bits() % 8);
      return i < 3 ? 0 : i < 6 ? side : static_cast<int>(random.bits() % static_cast<unsigned>(side));
    };
    int a[P::inputs_a], b[P::inputs_b];
    std::generate(std::begin(a), std::end(a), corner);
    std::generate(std::begin(b), std::end(b), corner);
    for (int k = 0; k < 3; ++k)
      a[k] = (b[k] + b[3 + k]) / 2;
    for (const int x : a)
      r.a.push_back(static_cast<float>(x));
    for (const int x : b)
      r.b.push_back(static_cast<float>(x));
    r.pairs.push_back({n, n});
  }
  std::vector<answer> truth;
  for (const meetc::index_pair x : r.pairs)
    truth.push_back(meetc::to_answer(meetc::decide_exact<P>(r.a.data() + std::size_t{x.a} * P::inputs_a,
                                                            r.b.data() + std::size_t{x.b} * P::inputs_b)));
  return static_cast<int>(run<P, meetc::residue_width<64, 62, 48, Limit>>(r, truth).wrong);
}

} // namespace

TEST_CASE("exact doubles at their limit: nothing is wrong, and sixteen times as much is seen") {
  STATIC_REQUIRE(meetc::exact_steps<cga::triangle_triangle>() == 114'501); // as docs/proofs.md says
  CHECK(wrong_by_midpoints<53>() == 0);
  CHECK(wrong_by_midpoints<57>() > 0);
}
