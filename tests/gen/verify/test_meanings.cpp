// The meaning of a predicate: `verify` finds a right one right by exact geometry, and each planted mistake.
#include "gen/verify/verify.hpp"
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

const char *const imports = "'predicates/round.toml']", *const with_beyond = "'predicates/round.toml', "
                                                                             "'predicates/beyond.toml']";

// A predicate as it is added to the shipped ones, with a piece of it that is exchanged for a wrong one.
struct meaning_case {
  const char *name, *body, *right, *wrong;
};
const meaning_case cases[] = {
    {"ball_overlap",
     "of = ['S: sphere', 'T: sphere']\nmeans = 'overlap'\nhit = 'sign(((I*S) | (I*T)) + 4*S.r*T.r) > 0'\n", ") > 0",
     ") >= 0"},
    {"ball_overlap",
     "of = ['S: sphere', 'T: sphere']\nmeans = 'overlap'\nhit = 'sign(((I*S) | (I*T)) + 4*S.r*T.r) > 0'\n", "'overlap'",
     "'contains'"},
    {"box_overlap",
     "of = ['A: box', 'B: box']\nmeans = 'overlap'\n"
     "hit = 'all(k in axes: A.low[k] < B.high[k] and B.low[k] < A.high[k])'\n",
     "A.low[k] < B", "A.low[k] <= B"},
    {"box_overlap",
     "of = ['A: box', 'B: box']\nmeans = 'overlap'\n"
     "hit = 'all(k in axes: A.low[k] < B.high[k] and B.low[k] < A.high[k])'\n",
     "'overlap'", "'touch'"},
    {"pierces",
     "of = ['s: segment', 't: triangle']\nmeans = 'overlap'\n"
     "hit = 'side(t, s.p) * side(t, s.q) < 0 and inside(each(e in t.edges: twist(s, e)))'\n",
     "inside(", "agree("},
    {"pierces",
     "of = ['s: segment', 't: triangle']\nmeans = 'overlap'\n"
     "hit = 'side(t, s.p) * side(t, s.q) < 0 and inside(each(e in t.edges: twist(s, e)))'\n",
     " < 0 and", " <= 0 and"},
    {"ball_holds_ball",
     "of = ['S: sphere', 'T: sphere']\nmeans = 'contains'\n"
     "hit = 'sign(S.r - T.r) >= 0 and sign(((I*S) | (I*T)) - 4*S.r*T.r) >= 0'\n",
     "sign(S.r - T.r) >= 0 and ", ""},
    {"ball_holds_ball",
     "of = ['S: sphere', 'T: sphere']\nmeans = 'contains'\n"
     "hit = 'sign(S.r - T.r) >= 0 and sign(((I*S) | (I*T)) - 4*S.r*T.r) >= 0'\n",
     "T.r) >= 0'", "T.r) > 0'"},
    {"ball_holds_triangle",
     "of = ['S: sphere', 't: triangle']\nmeans = 'contains'\nhit = 'all(p in t.corners: side(S, p) >= 0)'\n", "'all(p",
     "'any(p"},
    {"box_holds_box",
     "of = ['A: box', 'B: box']\nmeans = 'contains'\n"
     "hit = 'all(k in axes: A.low[k] <= B.low[k] and B.high[k] <= A.high[k])'\n",
     "A.low[k] <= B.low", "A.low[k] < B.low"},
    {"box_holds_ball",
     "of = ['A: box', 'S: sphere']\nmeans = 'contains'\n"
     "hit = 'all(k in axes: A.low[k] <= S.c[k] - 2*S.r and S.c[k] + 2*S.r <= A.high[k])'\n",
     "S.c[k] - 2*S.r", "S.c[k] - S.r"},
    {"fork", "of = ['s: segment', 'e: segment']\nmeans = 'beyond'\ncommon = 1\nhit = 'one_ray(s.p, s.q, e.q)'\n",
     "'one_ray(s", "'in_line(s"},
    {"off_the_corners",
     "of = ['p: point', 't: triangle']\nmeans = 'beyond'\n"
     "hit = 'point_triangle(p, t) and not any(c in t.corners: all(k in axes: p[k] == c[k]))'\n",
     " and not any(c in t.corners: all(k in axes: p[k] == c[k]))", ""},
};

// One piece of beyond.toml changed.
struct mutation {
  const char *kernel, *from, *to;
};
const mutation mutations[] = {
    {"beyond_corner", "reject = ['p1*q1 > 0', 'r1*s1 > 0']", "reject = ['p1*q1 >= 0', 'r1*s1 > 0']"},
    {"beyond_corner", "'r1*s1 > 0']", "'r1*s1 < 0']"},
    {"beyond_corner", "let.pq = '-twist", "let.pq = 'twist"},
    {"beyond_corner", "segment(B.b, B.c))'  #", "segment(B.c, B.b))'  #"},
    {"beyond_corner", "let.q1 = 'side(triangle(A.a, B.b, B.c), A.c)'", "let.q1 = 'side(triangle(A.a, B.b, B.c), A.b)'"},
    {"beyond_corner", "agree([r1, pq, -s1])", "agree([r1, pq, s1])"},
    {"beyond_corner", "agree([r1, pq, -s1]) or ", ""},
    {"beyond_corner", " or agree([p1, pq, -q1])", ""},
    {"beyond_corner", "agree([p1, pq, -q1])", "inside([p1, pq, -q1])"},
    {"beyond_corner", "p1 == 0 and q1 == 0 or r1 == 0 and s1 == 0", "p1 == 0 and q1 == 0"},
    {"beyond_corner", "then p1 == 0 and q1 == 0 and r1 == 0 and s1 == 0\n     and", "then"},
    {"beyond_corner", "any(p in [A.b, A.c]: between(A.a, p, B.b, B.c)) or ", ""},
    {"beyond_corner", " or any(p in [B.b, B.c]: between(A.a, p, A.b, A.c))", ""},
    {"beyond_corner", "any(k in axes: p[k] != v[k]) and ", ""},
    {"beyond_corner", "(not in_line(v, q, r) or one_ray(v, p, q) or one_ray(v, p, r))\nand ", ""},
    {"beyond_corner", " or one_ray(v, p, r)", ""},
    {"beyond_corner", "in_line(v, p, q) and any", "any"},
    {"beyond_corner", "turn(k, v, q, p) >= 0", "turn(k, v, q, p) > 0"},
    {"beyond_corner", " and turn(k, v, q, r) * turn(k, v, p, r) >= 0", ""},
    {"beyond_corner", " or p[k] > v[k] and q[k] > v[k]", ""},
    {"beyond_corner", "p[k] < v[k] and q[k] < v[k]", "p[k] < v[k] and q[k] > v[k]"},
    {"beyond_edge", "reject = ['side(A, B.c) != 0']", "reject = ['side(A, B.c) > 0', 'side(A, B.c) == 0']"},
    {"beyond_edge", "turn(k, A.a, A.b, B.c) > 0", "turn(k, A.a, A.b, B.c) >= 0"},
    {"beyond_edge", "turn(k, A.a, A.b, B.c) > 0", "turn(k, A.a, A.b, B.c) < 0"},
    {"beyond_edge", "turn(k, A.a, A.b, B.c) > 0", "turn(k, A.b, A.a, B.c) > 0"},
    {"beyond_edge", "in_line(A.a, A.b, A.c) and in_line(A.a, A.b, B.c)", "in_line(A.a, A.b, A.c)"},
    {"beyond_edge", "then one_ray(A.a, A.c, B.c)", "then in_line(A.a, A.c, B.c)"},
    {"beyond_edge", "ahead(k, A.a, A.b, A.c, B.c) or ", ""},
    {"beyond_edge", " or ahead(k, A.b, A.a, A.c, B.c)", ""},
    {"beyond_edge", "w[k] < p[k] and w[k] < q[k]", "w[k] < p[k] and w[k] <= q[k]"},
    {"beyond_edge", "v[k] < w[k] and w[k] < p[k]", "w[k] < p[k]"},
};

verify::report verified(const spec_copy &copy, long pairs, unsigned seed) {
  const compilation c = copy.compile();
  return verify::verify_predicate(*c.model, c.kernels.front(), pairs, seed);
}

// As many small runs as it takes to see a mistake.
long wrong_in(const spec_copy &copy, std::string &first) {
  const compilation c = copy.compile();
  for (unsigned seed = 1; seed <= 50; ++seed)
    if (const verify::report r = verify::verify_predicate(*c.model, c.kernels.front(), 100, seed); r.wrong > 0) {
      first = r.first_wrong;
      return r.wrong;
    }
  return 0;
}

} // namespace

TEST_CASE("verify judges a predicate by its meaning") {
  for (const meaning_case &c : cases) {
    INFO(c.name << ": '" << c.right << "' to '" << c.wrong << "'");
    const std::string table = std::string("[predicates.") + c.name + "]\n" + c.body;
    const spec_copy right({c.name}), wrong({c.name});
    for (const spec_copy *const copy : {&right, &wrong}) {
      copy->replace("cga3.toml", imports, with_beyond);
      copy->replace("predicates/beyond.toml", "[predicates.beyond_corner]", table + "[predicates.beyond_corner]");
    }
    const verify::report r = verified(right, 1500, 3);
    INFO(r.first_wrong);
    CHECK(r.wrong == 0);
    CHECK(r.hits > 10);
    CHECK(r.cases - r.hits > 10);
    wrong.replace("predicates/beyond.toml", c.right, c.wrong);
    std::string first;
    CHECK(wrong_in(wrong, first) > 0);
    CHECK_FALSE(first.empty());
  }
}

TEST_CASE("verify finds the predicates of neighbours right, and sees every mutation of them") {
  for (const char *const kernel : {"beyond_corner", "beyond_edge"}) {
    const spec_copy copy({kernel});
    copy.replace("cga3.toml", imports, with_beyond);
    const verify::report r = verified(copy, 4000, 5);
    INFO(kernel << ": " << r.first_wrong);
    CHECK(r.wrong == 0);
    CHECK(r.hits > 500);
    CHECK(r.degenerate > 500);
  }
  for (const mutation &m : mutations) {
    INFO(m.kernel << ": '" << m.from << "' to '" << m.to << "'");
    const spec_copy copy({m.kernel});
    copy.replace("cga3.toml", imports, with_beyond);
    copy.replace("predicates/beyond.toml", m.from, m.to);
    std::string first;
    CHECK(wrong_in(copy, first) > 0);
  }
}

TEST_CASE("a predicate of another meaning than touch keeps no tolerance, and says its meaning") {
  const temporary_folder folder;
  folder.write("a.toml", edited(small_algebra, "hit = 'sign(norm2(meet(S, T))) >= 0'",
                                "means = 'overlap'\nhit = 'sign(norm2(meet(S, T))) > 0'"));
  folder.write("s.toml", small_scene("'touch'") + "box = 1\ntolerance = 0.1\n");
  const outcome o = run_meetc("generate s.toml -o out", folder.path());
  CHECK(o.code == 2);
  CHECK_THAT(o.err, contains("'touch' keeps no tolerance: its meaning is not 'touch'"));
  folder.write("s.toml", small_scene("'touch'"));
  const outcome shown = run_meetc("show s.toml touch --emit=spec", folder.path());
  CHECK_THAT(shown.out, contains("means overlap\n"));
  CHECK_THAT(run_meetc("show s.toml touch", folder.path()).out, contains("//   means: overlap"));
}
