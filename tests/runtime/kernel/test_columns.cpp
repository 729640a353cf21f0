// From balls to the sign of the matrix unit's result, whatever the unit does within its model: balls that touch give
// negative results. The constants of the margins are proved in proofs/, and tests/proofs reduces each in turn. Here the
// whole way is tested, from float32 numbers through the frame to halves.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/runtime/kernel/scenes.hpp"

#include <cmath>
#include <limits>

using namespace meetc::matrix_test;
using meetc::placing;
using meetc::generated_test::effort;

namespace {

struct placed {
  ball in_frame;
  placing where;
  columns x, y;
  float float_x[form::products + 1], float_y[form::products + 1];
};

placed with_columns(placed p) {
  p.x = columns_of<form, true>(p.in_frame, p.where);
  p.y = columns_of<form, false>(p.in_frame, p.where);
  meetc::to_floats<form, true>(p.in_frame.data(), p.where, p.float_x);
  meetc::to_floats<form, false>(p.in_frame.data(), p.where, p.float_y);
  return p;
}
placed put(const meetc::matrix_frame &frame, const sphere &s) {
  placed out{};
  out.where = place(frame, s, meetc::cover::element, out.in_frame);
  return with_columns(out);
}
placed padding() {
  placed out{};
  out.where = placing::nowhere;
  return with_columns(out);
}

// The sign bit, which is all that the kernels use.
bool kept(const placed &x, const placed &y) {
  return std::signbit(meetc::bilinear<form>(x.float_x, y.float_y));
}

struct tally {
  long touching = 0, exact = 0, missed = 0, missed_in_float = 0; // exact: touching, and not one ulp less
  long apart = 0, kept = 0, kept_in_float = 0;                   // both inside and apart; kept for all that
  long padding = 0;                                              // results that may be negative beside padding
};

void go_through(const family &f, int scenes, tally &sum) {
  std::mt19937_64 random(11);
  const placed nothing = padding();
  for (int i = 0; i < scenes; ++i) {
    const scene s = f.make(random);
    const meetc::matrix_frame frame = frame_around(s.owners);
    const auto pair = [&](const sphere &a, const placed &p, const sphere &b, const placed &q) {
      // Either ball may be X.
      const bool negative = multiply(p.x, q.y).always_negative && multiply(q.x, p.y).always_negative;
      const bool in_float = kept(p, q) && kept(q, p);
      if (touch(a, b)) {
        ++sum.touching;
        sphere less = b;
        less[3] = std::nextafter(less[3], -1.0F);
        sum.exact += less[3] >= 0 && !touch(a, less);
        sum.missed += !negative;
        sum.missed_in_float += !in_float;
      } else if (p.where == placing::inside && q.where == placing::inside) {
        ++sum.apart;
        sum.kept += !multiply(p.x, q.y).never_negative;
        sum.kept_in_float += kept(p, q);
      }
    };
    std::vector<placed> owners, others;
    for (const sphere &x : s.owners)
      owners.push_back(put(frame, x));
    for (const sphere &x : s.others)
      others.push_back(put(frame, x));
    for (std::size_t j = 0; j < owners.size(); ++j) {
      for (std::size_t k = 0; k < others.size(); ++k)
        pair(s.owners[j], owners[j], s.others[k], others[k]);
      pair(s.owners[j], owners[j], s.owners[0], owners[0]); // a set against itself
    }
    for (const auto *set : {&owners, &others})
      for (const placed &p : *set) {
        sum.padding += !multiply(nothing.x, p.y).never_negative + !multiply(p.x, nothing.y).never_negative;
        sum.padding += kept(nothing, p) + kept(p, nothing);
      }
  }
}

// Whether the pair's result is negative under Form's margins, whatever the unit does.
template <class Form> bool surely_kept(const ball &a, const ball &b) {
  return multiply(columns_of<Form, true>(a, placing::inside), columns_of<Form, false>(b, placing::inside))
      .always_negative;
}

struct no_linear : form {
  static constexpr float margin_linear = 0;
};
struct no_absolute : form {
  static constexpr float margin_absolute = 0;
};

} // namespace

TEST_CASE("balls that touch come out negative, whatever the unit loses, padding never does") {
  long exact = 0;
  for (const family &f : families()) {
    tally sum;
    go_through(f, effort(10000), sum);
    INFO(f.name << ": " << sum.touching << " touch, " << sum.exact << " of them just so; " << sum.apart << " apart, "
                << sum.kept << " and " << sum.kept_in_float << " of those kept");
    CHECK(sum.missed == 0);
    CHECK(sum.missed_in_float == 0);
    CHECK(sum.padding == 0);
    CHECK(sum.touching > effort(5000));
    exact += sum.exact;
  }
  CHECK(exact > effort(20000));
}

TEST_CASE("pairs that are apart are mostly let go") {
  tally sum;
  go_through(families()[0], effort(20000), sum);
  REQUIRE(sum.apart > effort(20000));
  CHECK(sum.kept < sum.apart / 500);
  CHECK(sum.kept_in_float < sum.apart / 500);
}

// Each of these margins is at least four times what the others leave over, so a quarter of it would suffice, and none
// would not.
TEST_CASE("without the linear margin some that touch may be missed") {
  std::mt19937_64 random(13);
  long seen = 0, missed = 0, missed_without = 0;
  for (int i = 0; i < 20000; ++i) {
    // Numbers in [1/8, 1/4) whose lower parts are just too small to be kept, beside others in the teens.
    ball a, b;
    double d2 = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      a[k] = (1024 + static_cast<double>(random() % 1023)) * 0x1p-13 + 0x1.ffp-15;
      b[k] = 12 + static_cast<double>(random() % 4096) / 1024;
      if (k < 3)
        d2 += (a[k] - b[k]) * (a[k] - b[k]);
    }
    b[3] = std::nextafter(std::sqrt(d2) - a[3], 100.0);
    if (!touch(a, b))
      continue;
    ++seen;
    missed += !surely_kept<form>(a, b);
    missed_without += !surely_kept<no_linear>(a, b);
  }
  CHECK(seen > 5000);
  CHECK(missed == 0);
  CHECK(missed_without > 0);
}

TEST_CASE("without the absolute margin points at the middle are missed") {
  const ball middle{0, 0, 0, 0};
  CHECK(surely_kept<form>(middle, middle));
  CHECK_FALSE(surely_kept<no_absolute>(middle, middle));
}

TEST_CASE("who meets whom, of objects that are not both inside") {
  constexpr placing all[] = {placing::inside, placing::apart, placing::astride, placing::everywhere, placing::nowhere};
  const auto meets = [](placing x, placing y) {
    const auto either = [&](placing p) { return x == p || y == p; };
    if (either(placing::nowhere))
      return false;
    return either(placing::everywhere) || !either(placing::apart);
  };
  const auto at = [](double v) { return ball{v, -v, v, std::fabs(v)}; };
  for (const placing first : all)
    for (const placing second : all) {
      if (first == placing::inside && second == placing::inside)
        continue;
      const bool any = meets(first, second);
      for (const double v : {0.0, 0x1p-14, 100.0, -2048.0, 2048.0}) {
        // With no radius the term is as large as it gets; with the radius alone as small.
        for (ball b : {at(v), ball{v, v, v, 0}, ball{0, 0, 0, std::fabs(v)}}) {
          const unit_result r = multiply(columns_of<form, true>(b, first), columns_of<form, false>(b, second));
          float x[form::products + 1], y[form::products + 1];
          meetc::to_floats<form, true>(b.data(), first, x);
          meetc::to_floats<form, false>(b.data(), second, y);
          CHECK((any ? r.always_negative : r.never_negative));
          CHECK(std::signbit(meetc::bilinear<form>(x, y)) == any);
        }
      }
    }
}
