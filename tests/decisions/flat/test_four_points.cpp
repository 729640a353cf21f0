// segment_segment and point_triangle for all real points, at the level of signs: for four points the class and
// the signs of one direction determine every determinant and every turn and, unless the points span a plane,
// every difference. docs/decisions.md says why; here the emitted decisions are run on those signs.
#include "tests/catch.hpp"
#include "tests/decisions/flat/witness.hpp"

using namespace meetc::decisions_test;
using meetc::sign_set;

namespace {

// The possible signs of every value, for a class of n points that span d-space and a direction
// (placement.hpp).
template <class P> std::vector<sign_set> signs_of(key k, int d, const place &direction) {
  std::vector<sign_set> out;
  constexpr int n = written<P>::of_a + written<P>::of_b;
  for (const atom &a : atoms_of<P>().all()) {
    const int along = sign_of(direction[static_cast<std::size_t>(a.axis)]);
    int sign = 0;
    bool known = true;
    switch (a.kind) {
    case shape::determinant:
      sign = d == 3 ? orientation(k, n, a.of) : 0;
      break;
    case shape::turn: // a component of a cross product in the plane across the direction
      sign = d == 2 ? along * orientation(k, n, a.of) : 0;
      known = d < 3;
      break;
    case shape::difference: // of points on a line; a - b, where the key has b - a
      sign = d == 1 ? -along * orientation(k, n, a.of) : 0;
      known = d < 2;
      break;
    }
    out.push_back(known ? sign_set::of(static_cast<meetc::sign>(a.sign * sign)) : sign_set::all());
  }
  return out;
}

template <class P> int check_signs() {
  constexpr int m = written<P>::of_a, n = m + written<P>::of_b;
  int situations = 0;
  bool decided = true, witnessed = true;
  for (int d = 0; d <= 3; ++d)
    for (const auto &[k, x] : classes_of(n, d)) {
      const bool meets = hulls_meet(k, n, d, m);
      for (const placement &p : placements(d)) {
        std::vector<sign_set> s = signs_of<P>(k, d, p.direction);
        // The actual signs of points of this class are among the possible ones.
        meetc::sign real[P::atoms];
        integer_pair<P>(placed(x, p)).all(real);
        for (std::size_t i = 0; i < P::atoms; ++i)
          witnessed = witnessed && (s[i].bits & sign_set::of(real[i]).bits) != 0;
        if (meets) // then all ranges overlap, for which alone differences are used; those of equal points do
          for (std::size_t i = 0; i < P::atoms; ++i)
            if (s[i].bits == 7 && atoms_of<P>().all()[i].kind == shape::difference)
              s[i] = sign_set::of(meetc::sign::zero);
        // The answer is certain, whatever the undetermined signs are.
        decided = decided && meetc::to_answer(P::whole(s.data())) == (meets ? meetc::answer::yes : meetc::answer::no);
        if (d < 3 || &p == &placements(3).front())
          ++situations;
      }
    }
  CHECK(decided);
  CHECK(witnessed);
  return situations;
}

} // namespace

// 1 + 74 * 13 + 50 * 13 + 2
TEST_CASE("four_points: segment_segment on every sign vector") {
  CHECK(check_signs<cga::segment_segment>() == 1615);
}
TEST_CASE("four_points: point_triangle on every sign vector") {
  CHECK(check_signs<cga::point_triangle>() == 1615);
}
