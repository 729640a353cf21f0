// The enumeration finds mistakes: each decision with one mistake is refuted by a class.
#include "tests/catch.hpp"
#include "tests/decisions/flat/witness.hpp"

#include <cstdio>

using namespace meetc::decisions_test;

namespace {

// The number of placed classes for which a changed decision is wrong: by itself, or because a reject line holds
// for a pair that meets. Stops at the first one if told to.
template <class P> int wrong(change c, bool stop) {
  constexpr int m = written<P>::of_a, n = m + written<P>::of_b;
  int count = 0;
  for (int d = 3; d >= 0; --d)
    for (const auto &[k, x] : classes_of(n, d)) {
      const bool meets = hulls_meet(k, n, d, m);
      for (const placement &p : placements(d)) {
        meetc::sign s[P::atoms];
        integer_pair<P>(placed(x, p)).all(s);
        const formulas<meetc::sign> f(atoms_of<P>(), s, c);
        bool right = written<P>::whole(f) == meets;
        if constexpr (staged<P>)
          right = right && !(meets && written<P>::rejected(f));
        count += !right;
        if (stop && count > 0)
          return count;
      }
    }
  return count;
}

struct planted {
  change what;
  const char *text;
};

template <class P> void refute(std::initializer_list<planted> changes, bool stop) {
  for (const planted &c : changes) {
    CAPTURE(written<P>::name, c.text);
    const int found = wrong<P>(c.what, stop);
    std::printf("%-18s %-52s wrong in %s%d\n", written<P>::name, c.text, stop ? "at least " : "", found);
    CHECK(found > 0);
  }
}

} // namespace

TEST_CASE("changes: unchanged decisions are right") {
  CHECK(wrong<cga::segment_segment>(change::none, false) == 0);
  CHECK(wrong<cga::point_triangle>(change::none, false) == 0);
  CHECK(wrong<cga::segment_triangle>(change::none, false) == 0);
}
TEST_CASE("changes: segment_segment") {
  refute<cga::segment_segment>({{change::ss_off_the_plane, "the twist need not be 0"},
                                {change::ss_one_way_crossing, "the second's ends are not asked for"},
                                {change::ss_other_way_crossing, "the first's ends are not asked for"},
                                {change::ss_open_crossing, "the second's ends on opposite sides, < 0 for <= 0"},
                                {change::ss_no_overlap, "no range need overlap"},
                                {change::ss_open_overlap, "ranges overlap, < for <="},
                                {change::ss_two_axes, "no turns along the third axis"},
                                {change::ss_two_ranges, "no range along the third axis"}},
                               false);
}
TEST_CASE("changes: point_triangle") {
  refute<cga::point_triangle>({{change::pt_off_the_plane, "the side need not be 0"},
                               {change::pt_open, "turns agree, > 0 for >= 0"},
                               {change::pt_two_edges, "turns of two edges"},
                               {change::pt_no_overlap, "no range need overlap"},
                               {change::pt_two_axes, "no turns along the third axis"},
                               {change::pt_two_ranges, "no range along the third axis"}},
                              false);
}
TEST_CASE("changes: segment_triangle") {
  refute<cga::segment_triangle>({{change::st_open_ends, "ends on opposite sides, < 0 for <= 0"},
                                 {change::st_no_sides, "the ends' sides are not asked for"},
                                 {change::st_open_twists, "twists agree, > 0 for >= 0"},
                                 {change::st_no_twists, "the twists are not asked for"},
                                 {change::st_two_twists, "twists of two edges"},
                                 {change::st_no_end, "coplanar: the end is not asked for"},
                                 {change::st_two_edges, "coplanar: two edges"},
                                 {change::st_no_rare, "coplanar: as if it were not"},
                                 {change::st_rare_no, "coplanar: a miss"},
                                 {change::st_two_rejected, "rejected where one end is off the plane"}},
                                false);
}
TEST_CASE("changes: triangle_triangle") {
  refute<cga::triangle_triangle>({{change::tt_edges_of_one, "the edges of A alone"},
                                  {change::tt_closed_rejection, "rejected where a corner touches the plane"},
                                  {change::tt_hasty_rejection, "rejected by two corners"},
                                  {change::tt_rare_no, "a coplanar edge is a miss"}},
                                 true);
}
