// Equal points that settle decisions: what is claimed of the shipped scene and of other predicates, and that a wrong
// claim is found by the oracle.
#include "gen/lower/predicate/settled.hpp"
#include "gen/verify/verify.hpp"
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

// A claim in words: "s.p = e.q", two of them joined by " and ".
std::set<std::string> claims_of(const lower::kernel &k, const bound::kernel_bounds &b) {
  const auto point = [&](const std::vector<int> &inputs) {
    const std::string &path = k.decision.stored_inputs[static_cast<std::size_t>(inputs.front())];
    return path.substr(0, path.rfind('.'));
  };
  std::set<std::string> out;
  for (const std::uint32_t set : b.settled_by) {
    std::string claim;
    for (std::size_t i = 0; i < b.coincidences.size(); ++i)
      if (set >> i & 1)
        claim += fmt::format("{}{} = {}", claim.empty() ? "" : " and ", point(b.coincidences[i].x),
                             point(b.coincidences[i].y));
    out.insert(claim);
  }
  CHECK(out.size() == b.settled_by.size());
  return out;
}
std::set<std::string> claims_of(const compilation &c) {
  return claims_of(c.kernels.front(), c.bounds.front().value());
}

// Each of these points equal to each of those.
std::set<std::string> each_with_each(const std::vector<std::string> &these, const std::vector<std::string> &those) {
  std::set<std::string> out;
  for (const std::string &x : these)
    for (const std::string &y : those)
      out.insert(fmt::format("{} = {}", x, y));
  return out;
}

verify::report verified(const lower::kernel &k, const bound::kernel_bounds &b) {
  return verify::verify_settled(*default_scene().model, k, b, 300, 5);
}

} // namespace

TEST_CASE("settled: the claims of the shipped scene") {
  const auto claims = [](const char *name) { return claims_of(default_kernel(name), default_bounds(name)); };
  CHECK(claims("segment_segment") == each_with_each({"s.p", "s.q"}, {"e.p", "e.q"}));
  CHECK(claims("point_triangle") == each_with_each({"p"}, {"t.a", "t.b", "t.c"}));
  CHECK(claims("segment_triangle") == each_with_each({"s.p", "s.q"}, {"t.a", "t.b", "t.c"}));
  CHECK(claims("triangle_triangle") == each_with_each({"A.a", "A.b", "A.c"}, {"B.a", "B.b", "B.c"}));
  // A ball holds its centre, and a sphere does not.
  CHECK(claims("ball_ball") == each_with_each({"S.c"}, {"T.c"}));
  CHECK(claims("ball_segment") == each_with_each({"S.c"}, {"s.p", "s.q"}));
  CHECK(claims("ball_triangle") == each_with_each({"S.c"}, {"t.a", "t.b", "t.c"}));
  for (const char *surface : {"sphere_sphere", "sphere_segment", "sphere_triangle"})
    CHECK(claims(surface).empty());
}

TEST_CASE("settled: the oracle confirms every claim, and refutes all others") {
  int confirmed = 0, refuted = 0;
  for (const lower::kernel *k : default_kernels(want::predicates)) {
    INFO(k->asked.text);
    const bound::kernel_bounds &b = default_bounds(k->asked.name());
    const verify::report r = verified(*k, b);
    CHECK(r.wrong == 0);
    CHECK(r.cases == 300 * static_cast<long>(b.settled_by.size()));
    confirmed += static_cast<int>(b.settled_by.size());
    if (k->asked.name() == "box_box") // what a box's rule says of its corners settles more than is claimed
      continue;
    for (const bound::coincidence &c : bound::pairs_of_points(*k->decision.local)) {
      const auto at = std::find(b.coincidences.begin(), b.coincidences.end(), c);
      const std::uint32_t bit = at == b.coincidences.end() ? 0 : std::uint32_t{1} << (at - b.coincidences.begin());
      if (std::find(b.settled_by.begin(), b.settled_by.end(), bit) != b.settled_by.end())
        continue;
      bound::kernel_bounds planted = b;
      planted.coincidences = {c};
      planted.settled_by = {1};
      INFO("inputs " << c.x.front() << " and " << c.y.front());
      const verify::report wrong = verified(*k, planted);
      CHECK(wrong.wrong > 0);
      CHECK_FALSE(wrong.first_wrong.empty());
      ++refuted;
    }
  }
  CHECK(confirmed == 29);
  CHECK(refuted > 20);
}

TEST_CASE("settled: no claim where the decision is another one") {
  const char *const flat = "predicates/flat.toml", *const round_ones = "predicates/round.toml";
  const struct {
    const char *kernel, *file, *from, *to;
  } changes[] = {
      {"segment_segment", flat, "turn(k, s.p, s.q, e.q) <= 0", "turn(k, s.p, s.q, e.q) < 0"},
      {"segment_segment", "predicates/words.toml", "p[k] <= q[k]", "p[k] < q[k]"},
      {"point_triangle", flat, "agree(each(e in t.edges: turn", "inside(each(e in t.edges: turn"},
      {"segment_triangle", flat, "else sp*sq <= 0 and agree", "else sp*sq < 0 and agree"},
      {"segment_triangle", flat, "reject = ['sp*sq > 0']", "reject = ['sp*sq >= 0']"}, // it denies the hit
      {"ball_ball", round_ones, "4*S.r*T.r) >= 0", "4*S.r*T.r) > 0"},
      {"ball_segment", round_ones, "side(S, p) >= 0", "side(S, p) > 0"},
  };
  for (const auto &m : changes) {
    INFO(m.kernel << ": '" << m.from << "' to '" << m.to << "'");
    const spec_copy copy({m.kernel});
    copy.replace(m.file, m.from, m.to);
    for (const std::string &claim : claims_of(copy.compile()))
      CHECK_THAT(claim, contains(" and ")); // two shared corners may still do
  }
}

TEST_CASE("settled: sets of two, points of one operand, and cases over a sign") {
  const auto compiled = [](const std::string &hit) {
    const spec_copy copy({"made"});
    copy.replace("predicates/flat.toml", "[predicates.segment_segment]",
                 fmt::format("[predicates.made]\nof = ['s: segment', 'e: segment']\nhit = '{}'\n\n"
                             "[predicates.segment_segment]",
                             hit));
    return copy.compile();
  };
  // Both ends of e lie on the line of s, seen along an axis.
  CHECK(claims_of(compiled("all(p in e.ends: turn(e1, s.p, s.q, p) == 0)")) ==
        std::set<std::string>{"s.p = s.q", "s.p = e.p and s.q = e.p", "s.p = e.q and s.q = e.q",
                              "s.p = e.p and s.p = e.q", "s.p = e.p and s.q = e.q", "s.p = e.q and s.q = e.p",
                              "s.q = e.p and s.q = e.q", "s.p = e.p and e.p = e.q", "s.p = e.q and e.p = e.q",
                              "s.q = e.p and e.p = e.q", "s.q = e.q and e.p = e.q"});
  // With one point shared, two different polynomials become one atom, whatever its sign is.
  CHECK(claims_of(compiled("turn(e1, s.p, s.q, e.q) > 0 or turn(e1, e.p, s.q, e.q) <= 0")).count("s.p = e.p") == 1);
  CHECK(claims_of(compiled("turn(e1, s.p, s.q, e.q) > 0 or turn(e1, e.p, s.q, e.q) < 0")).count("s.p = e.p") == 0);
  // A square is never negative.
  CHECK(claims_of(compiled("turn(e1, s.p, s.q, e.q) * turn(e1, e.p, s.q, e.q) >= 0")).count("s.p = e.p") == 1);
  CHECK(claims_of(compiled("turn(e1, s.p, s.q, e.q) * turn(e1, e.p, s.q, e.q) > 0")).count("s.p = e.p") == 0);
}
