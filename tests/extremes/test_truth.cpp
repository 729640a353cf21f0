// Checks the judges: the integers' signs against GMP's rationals, and the answers by signs and by geometry against a
// third method, which shares nothing with either. (The campaign compares signs and geometry with each other.)
#include "tests/catch.hpp"
#include "tests/extremes/families/families.hpp"
#include "tests/extremes/judges/geometry.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/judge.hpp"

using namespace meetc::extremes_test;
using meetc::generated_test::effort;

namespace {

template <class F> void on_every_cell(int cases, std::uint64_t seed, F &&f) {
  for (const family &from : families())
    for (const subject &s : subjects()) {
      if (!from.applies(s.a, s.b))
        continue;
      random_numbers random(seed++);
      INFO(s.name << " on " << from.name);
      bool same = true;
      for (int i = 0; i < effort(cases) && same; ++i) {
        const pair_of_rows p = from.make(s.a, s.b, random);
        INFO(text(p));
        same = f(s, p);
        if (!same)
          CHECK(same);
      }
    }
}

} // namespace

TEST_CASE("truth: the integers' signs are those of the rationals") {
  on_every_cell(60, 300,
                [](const subject &s, const pair_of_rows &p) { return s.integers_hold(p.a.data(), p.b.data()); });
}

TEST_CASE("truth: segments and triangles by separating axes, too") {
  on_every_cell(300, 900, [](const subject &s, const pair_of_rows &p) {
    using namespace meetc::generated_test;
    if (s.sign || padded(s.a))
      return true;
    const int want = touching_by_axes(s.a, p.a, s.b, p.b);
    return s.truth(p.a.data(), p.b.data()) == want && truth_by_geometry(s, p) == want;
  });
}
