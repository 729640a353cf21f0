// Contacts of balls and segments against rational numbers: labels, coordinates rounded once, and planted mistakes.
#include "tests/catch.hpp"
#include "tests/runtime/contacts/round_families.hpp"
#include "tests/runtime/contacts/round_truth.hpp"

#include <cga/ball_segment.hpp>
#include <cga/side_sphere_point.hpp>
#include <cga/sphere_segment.hpp>
#include <meetc/contact/root_place.hpp>
#include <meetc/contact/round_pair.hpp>
#include <string>

using namespace meetc::contacts_test;
using meetc::contact_code;

namespace {

using side = cga::side_sphere_point_sign;

template <bool Surface> contact_code code_of(const round_rows &p) {
  return meetc::ball_segment_contact<side, Surface>(p.ball.data(), p.other.data()).code();
}

bool agrees(contact_code code, const std::vector<round_truth::label> &labels, bool surface) {
  if (code.labels() != static_cast<int>(labels.size()) || code.has_witness() ||
      code.dimension() != (labels.size() == 2 && !surface ? 1 : 0))
    return false;
  for (int i = 0; i < code.labels(); ++i)
    if (const round_truth::label &l = labels[static_cast<std::size_t>(i)];
        code.label(i) != meetc::label_of(l.ball, l.segment))
      return false;
  return true;
}

struct tally {
  std::size_t wrong = 0, meeting = 0, apart = 0, untrue = 0;
};
template <bool Surface, class Touches> tally compare(const round_family &f, int pairs) {
  std::mt19937 random(7);
  tally out;
  for (int i = 0; i < pairs; ++i) {
    const round_rows p = f.pair(random);
    const contact_code code = code_of<Surface>(p);
    out.wrong += !agrees(code, round_truth(p.ball.data(), p.other.data()).labels(Surface), Surface);
    ++(code.labels() > 0 ? out.meeting : out.apart);
    out.untrue += Touches::after_fp32(p.ball.data(), p.other.data()) != (code.bits() != 0);
  }
  return out;
}

enum class mistake { none, truncated, tie_away, other_root };

// A number with the mistake in place of the right one.
template <class Real> Real spoiled(Real right, mistake planted, const round_truth &truth, int which, int k) {
  const mpq_class at(right);
  if (planted == mistake::truncated && right != 0 && truth.side(which, k, at) == (right > 0 ? -1 : 1))
    return next(right, right > 0 ? -1 : 1);
  if (planted == mistake::tie_away)
    for (const int direction : {-1, 1})
      if (truth.side(which, k, halfway(right, direction)) == 0)
        return next(right, direction);
  return right;
}

struct coordinates {
  std::size_t wrong = 0, checked = 0, ties = 0;
};
template <class Real> coordinates place(const round_family &f, int pairs, mistake planted = mistake::none) {
  std::mt19937 random(11);
  coordinates out;
  for (int i = 0; i < pairs; ++i) {
    const round_rows p = f.pair(random);
    const round_truth truth(p.ball.data(), p.other.data());
    for (const round_truth::label &l : truth.labels(false)) {
      Real x[3];
      int carrier = l.ball;
      if (planted == mistake::other_root && carrier == meetc::first_root)
        carrier = meetc::second_root;
      meetc::place_round_label<Real>(p.ball.data(), p.other.data(), meetc::label_of(carrier, l.segment), x);
      for (int k = 0; k < 3; ++k) {
        ++out.checked;
        if (l.segment < 2) {
          out.wrong += x[k] != static_cast<Real>(p.other[static_cast<std::size_t>(3 * l.segment + k)]);
          continue;
        }
        if (!std::isfinite(x[k])) {
          ++out.wrong;
          continue;
        }
        const Real f_k = spoiled(x[k], planted, truth, l.ball, k);
        out.wrong += !is_rounded(f_k, [&](const mpq_class &y) { return truth.side(l.ball, k, y); });
        out.ties += truth.side(l.ball, k, halfway(x[k], 1)) == 0 || truth.side(l.ball, k, halfway(x[k], -1)) == 0;
      }
    }
  }
  return out;
}

mpq_class exactly(double x) {
  return mpq_class(x);
}
template <bool Fused> mpq_class exactly(const meetc::double_words<Fused> &x) {
  return mpq_class(x.hi) + mpq_class(x.lo);
}
// The number of roots that a part of their stated error does not hold.
template <class Real> std::size_t missed(double part) {
  std::mt19937 random(13);
  std::size_t out = 0;
  for (const round_family &f : round_families(6))
    for (int i = 0; i < 300; ++i) {
      const round_rows p = f.pair(random);
      const round_truth truth(p.ball.data(), p.other.data());
      for (const round_truth::label &l : truth.labels(true))
        if (l.segment == meetc::first_edge) {
          const auto t = meetc::ball_line<Real>(p.ball.data(), p.other.data()).root(l.ball);
          const mpq_class at = exactly(t.at), error = mpq_class(t.error) * part;
          out += truth.root_side(l.ball, at - error) < 0 || truth.root_side(l.ball, at + error) > 0;
        }
    }
  return out;
}

} // namespace

TEST_CASE("the stated error of a root holds it, and a thousandth of that does not") {
  CHECK(missed<float>(1) == 0);
  CHECK(missed<double>(1) == 0);
  CHECK(missed<float>(0.001) > 0);
  CHECK(missed<double>(0.001) > 0);
}

TEST_CASE(
    "the code of a ball and a segment has the labels of the definition, in order, and is empty where they are apart") {
  std::size_t meeting = 0, apart = 0;
  for (const round_family &f : round_families(6)) {
    CAPTURE(f.name);
    const tally solid = compare<false, cga::ball_segment>(f, 1500);
    const tally surface = compare<true, cga::sphere_segment>(f, 1500);
    CHECK(solid.wrong == 0);
    CHECK(surface.wrong == 0);
    CHECK(solid.untrue == 0);
    CHECK(surface.untrue == 0);
    CHECK(solid.meeting + surface.meeting > 0);
    meeting += surface.meeting, apart += surface.apart;
  }
  CHECK(meeting > 0);
  CHECK(apart > 0);
}

TEST_CASE("all labels of a ball and a segment occur") {
  std::array<std::size_t, 5> seen{};
  std::mt19937 random(3);
  for (const round_family &f : round_families(6))
    for (int i = 0; i < 500; ++i) {
      const contact_code code = code_of<false>(f.pair(random));
      for (int l = 0; l < code.labels(); ++l)
        ++seen[static_cast<std::size_t>(meetc::label_a(code.label(l)))];
    }
  for (const std::size_t count : seen)
    CHECK(count > 0);
}

TEST_CASE("coordinates of roots are the exact ones, rounded once") {
  for (const round_family &f : round_families(6)) {
    CAPTURE(f.name);
    const coordinates single = place<float>(f, 400), wide = place<double>(f, 400);
    CHECK(single.wrong == 0);
    CHECK(wide.wrong == 0);
    CHECK(single.checked > 0);
    if (f.name == std::string("ties of float32"))
      CHECK(single.ties > 20);
    if (f.name == std::string("ties of float64"))
      CHECK(wide.ties > 20);
  }
}

TEST_CASE("the judge of roots notices planted mistakes") {
  for (const mistake planted : {mistake::truncated, mistake::tie_away, mistake::other_root}) {
    std::size_t single = 0, wide = 0;
    for (const round_family &f : round_families(6))
      single += place<float>(f, 60, planted).wrong, wide += place<double>(f, 60, planted).wrong;
    CAPTURE(static_cast<int>(planted));
    CHECK(single > 0);
    CHECK(wide > 0);
  }
}
