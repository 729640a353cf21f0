// Expressions that can be parsed and have no meaning: wrong types, members, indices, domains. They are found when a
// kernel is expanded, so each error carries the trail that led to it.
#include "tests/catch.hpp"
#include "tests/gen/error_fixture.hpp"

using namespace meetc::compiler_test;

namespace {
constexpr const char *blade = "'-I*(c - r*r*n)'";             // a.toml:19, its text from column 10
constexpr const char *hit = "'sign(norm2(meet(S, T))) >= 0'"; // a.toml:40, its text from column 8
constexpr const char *in_norm2 = "in kernel norm2(meet(sphere, sphere)), at s.toml:4:12";
constexpr const char *in_touch = "in kernel touch, at s.toml:4:12";
constexpr const char *touch = "'touch'";

const broken values[] = {
    {blade, "'c . r'", "a.toml:19:10", "point has no 'r'; it has: x, y, z", "c . r", in_norm2},
    {blade, "'c.x.y'", "a.toml:19:10", "a number has no members", "c.x.y", in_norm2},
    {blade, "'sphere(c, c)'", "a.toml:19:20", "'r' of sphere is a real, not a point", "c",
     "in sphere(c, c), at a.toml:19:10"},
    {blade, "'point(r, r, c)'", "a.toml:19:22", "'z' of point is a real, not a point", "c", in_norm2},
    {blade, "'[c, r]'", "a.toml:19:10", "a list where a number or a multivector is needed", "[c, r]", in_norm2},
    {blade, "'c[r]'", "a.toml:19:12", "this is not a multiple of one basis blade", "r", in_norm2},
    {blade, "'c[e1 + e2]'", "a.toml:19:12", "not a multiple of one basis blade", "e1 + e2", in_norm2},
    {blade, "'c[0]'", "a.toml:19:12", "not a multiple of one basis blade", "0", in_norm2},
    {blade, "'c[e1*e1]'", "a.toml:19:12", "'e1*e1' is not the product of different basis vectors", "e1*e1", in_norm2},
    {blade, "'c[n*nb]'", "a.toml:19:12", "'n*nb' is not the product of different basis vectors", "n*nb", in_norm2},
    {blade, "'c^2'", "a.toml:19:10", "'^' is the outer product, which a number only scales: write c*c for a square",
     "c^2", in_norm2},
    {blade, "'(c - n)^2'", "a.toml:19:10", "write (c - n)*(c - n) for a square", "(c - n)^2", in_norm2},
    {blade, "'c^3'", "a.toml:19:10", "which a number only scales: write c*c*c for a power", "c^3", in_norm2},
    {blade, "'c^4'", "a.toml:19:10", "write c*c*c*c for a power", "c^4", in_norm2},
    {blade, "'c^-1'", "a.toml:19:10", "write inverse(c) for an inverse", "c^-1", in_norm2},
    {blade, "'c^0.5'", "a.toml:19:10",
     "'^' is the outer product, which a number only scales: write c*c for a square, and '*' to scale", "c^0.5",
     in_norm2},
    {blade, "'2 ^ c'", "a.toml:19:10", "'^' is the outer product", "2 ^ c", in_norm2},
    {blade, "'c | -2'", "a.toml:19:10", "'|' is the inner product, and a number has none", "c | -2", in_norm2},
    {blade, "'c/0'", "a.toml:19:12", "'0' has no inverse: its product with its reverse is 0", "0", in_norm2},
    {blade, "'c/(1 - 1)'", "a.toml:19:12", "'(1 - 1)' has no inverse", "(1 - 1)", in_norm2},
    {blade, "'c/r'", "a.toml:19:12",
     "nothing says that 'r' is not 0, and only a number other than 0 divides; leave the factor out here, and divide "
     "where "
     "the value is used",
     "r", in_norm2},
    {blade, "'c/(c + r*e1)'", "a.toml:19:12",
     "nothing says that V = '(c + r*e1)' has an inverse: V*~V depends on the operands, and may be 0; multiply by ~V "
     "here, "
     "and divide by rnorm2(V) where the value is used",
     "(c + r*e1)", in_norm2},
    {blade, "'c/n'", "a.toml:19:12", "'n' has no inverse: its product with its reverse is 0", "n", in_norm2},
    {blade, "'inverse(n - n)*c'", "a.toml:19:18", "'n - n' has no inverse", "n - n", in_norm2},
    {blade, "'inverse(c)'", "a.toml:19:18", "'c' has no inverse: its product with its reverse is 0", "c", in_norm2},
    {blade, "'grade(c, 6)'", "a.toml:19:19", "a grade is a whole number from 0 to 5", "6", in_norm2},
    {blade, "'grade(c, 1/2)'", "a.toml:19:19", "a grade is a whole number from 0 to 5", "1/2", in_norm2},
    {blade, "'grade(c, r)'", "a.toml:19:19", "a grade is a whole number from 0 to 5", "r", in_norm2},
    {blade, "'sandwich(1 + c, c)'", "a.toml:19:10",
     "sandwich(1 + c, c) needs an even or an odd V, and this V has grades of both sorts; take its parts, as in "
     "grade(V, 1)",
     "sandwich(1 + c, c)", in_norm2},
    {blade, "'reflect(c, c + 1)'", "a.toml:19:10", "reflect(c, c + 1) needs an even or an odd p", "reflect(c, c + 1)",
     in_norm2},
    {blade, "'~[c]'", "a.toml:19:11", "a list where a number or a multivector is needed", "[c]", in_norm2},
    {blade, "'c & [c]'", "a.toml:19:14", "a list where a number or a multivector is needed", "[c]", in_norm2},
    {blade, "'c*(r > 0)'", "a.toml:19:12", "a truth where a number or a multivector is needed", "(r > 0)", in_norm2},
    {blade, "'sign(r)'", "a.toml:19:10", "a sign where a number or a multivector is needed", "sign(r)", in_norm2},
    {blade, "'sign(r) + r'", "a.toml:19:10", "a sign and a number: signs only multiply with signs", "sign(r) + r",
     in_norm2},
    {blade, "'grade(c + r)'", "a.toml:19:16", "this has no single grade", "c + r", in_norm2},
    {blade, "'grade(c - c)'", "a.toml:19:16", "this has no single grade: it is zero", "c - c", in_norm2},
    {blade, "'any(k in r: k > 0)'", "a.toml:19:19", "a number where a list is needed", "r", in_norm2},
    {blade, "'sphere'", "a.toml:19:10", "'sphere' is a kind, not a value", "sphere", in_norm2},
};

const broken truths[] = {
    {hit, "'S.r'", "a.toml:40:8", "a number where a truth is needed; compare it, as in 's > 0'", "S.r", in_touch,
     touch},
    {hit, "'sign(S.r)'", "a.toml:40:8", "a sign where a truth is needed; compare it", "sign(S.r)", in_touch, touch},
    {hit, "'S'", "a.toml:40:8", "a sphere where a truth is needed", "S", in_touch, touch},
    {hit, "'meet(S, T)'", "a.toml:40:8", "a multivector where a truth is needed", "meet(S, T)", in_touch, touch},
    {hit, "'-sign(S.r)'", "a.toml:40:8", "a sign where a truth is needed", "-sign(S.r)", in_touch, touch},
    {hit, "'not sign(S.r)'", "a.toml:40:12", "a sign where a truth is needed", "sign(S.r)", in_touch, touch},
    {hit, "'S.r > 0 or S.r'", "a.toml:40:19", "a number where a truth is needed", "S.r", in_touch, touch},
    {hit, "'S.r and S.r > 0'", "a.toml:40:8", "a number where a truth is needed", "S.r", in_touch, touch},
    {hit, "'if sign(S.r) then S.r > 0 else S.r < 0'", "a.toml:40:11", "a sign where a truth is needed", "sign(S.r)",
     in_touch, touch},
    {hit, "'if S.r > 0 then T.r else S.r < 0'", "a.toml:40:24", "a number where a truth is needed", "T.r", in_touch,
     touch},
    {hit, "'all(p in [S.r]: p)'", "a.toml:40:24", "a number where a truth is needed", "p", in_touch, touch},
    {hit, "'each(p in [S.c]: p)'", "a.toml:40:8", "a list where a truth is needed", "each(p in [S.c]: p)", in_touch,
     touch},
    {hit, "'any(p in S: p > 0)'", "a.toml:40:17", "a sphere where a list is needed", "S", in_touch, touch},
    {"hit = ", "reject = ['S.r']\nhit = ", "a.toml:40:12", "a number where a truth is needed", "S.r", in_touch, touch},
};

const broken signs[] = {
    {hit, "'sign(meet(S, T)) > 0'", "a.toml:40:13", "a multivector where a number is needed", "meet(S, T)", in_touch,
     touch},
    {hit, "'sign(S.r > 0) > 0'", "a.toml:40:13", "a truth where a number or a multivector is needed", "S.r > 0",
     in_touch, touch},
    {hit, "'sign(S.r) > 2'", "a.toml:40:20", "a sign compares with -1, 0, 1 or another sign", "2", in_touch, touch},
    {hit, "'sign(S.r) > 1/2'", "a.toml:40:20", "a sign compares with -1, 0, 1", "1/2", in_touch, touch},
    {hit, "'sign(S.r) > S.r'", "a.toml:40:20", "a sign compares with -1, 0, 1", "S.r", in_touch, touch},
    {hit, "'-2 < sign(S.r)'", "a.toml:40:8", "a sign compares with -1, 0, 1", "-2", in_touch, touch},
    {hit, "'sign(S.r) + sign(T.r) > 0'", "a.toml:40:8", "a sign and a sign: signs only multiply with signs",
     "sign(S.r) + sign(T.r)", in_touch, touch},
    {hit, "'2*sign(S.r) > 0'", "a.toml:40:8", "signs only multiply with signs", "2*sign(S.r)", in_touch, touch},
    {hit, "'sign(S.r)^sign(T.r) > 0'", "a.toml:40:8", "signs only multiply with signs", "sign(S.r)^sign(T.r)", in_touch,
     touch},
    {hit, "'(S.r > 0) == (T.r > 0)'", "a.toml:40:21", "a truth where a number or a multivector is needed", "(T.r > 0)",
     in_touch, touch},
    {hit, "'S > T'", "a.toml:40:12", "a multivector where a number is needed", "T", in_touch, touch},
    {hit, "'[S] > 0'", "a.toml:40:8", "a list where a number or a multivector is needed", "[S]", in_touch, touch},
};

// Functions and predicates called with arguments that they cannot take. The trail names every call on the way.
const broken calls[] = {
    {hit, "'side(S, T) >= 0'", "a.toml:32:22", "a multivector where a number is needed", "meet(H, p)",
     "  in side(S, T), at a.toml:40:8\n  in kernel touch, at s.toml:4:12\n", touch},
    {hit, "'side(S, [S.c]) > 0'", "a.toml:36:27", "a list where a number or a multivector is needed", "Y",
     "  in meet(H, p), at a.toml:32:22\n  in side(S, [S.c]), at a.toml:40:8\n", touch},
    {hit, "'side(S.c, T.c) > 0'", "a.toml:32:22",
     "meet(H, p) is not defined here: grade(X) + grade(Y) >= 5 does not hold, grade(X) = 1, grade(Y) = 1", "meet(H, p)",
     "  in side(S.c, T.c), at a.toml:40:8\n", touch},
    {hit, "'near(S, S.c)'", "a.toml:40:8", "unknown function 'near'", "near(S, S.c)", "", touch},
    {"[predicates.touch]",
     "[predicates.near]\nof = ['s: segment', 'T: sphere']\nhit = 'T.r > 0'\n"
     "[predicates.asks]\nof = ['S: sphere', 'T: sphere']\nhit = 'near(S, T)'\n[predicates.touch]",
     "a.toml:43:8", "'s' of near is a segment, not a sphere", "near(S, T)", "in kernel asks, at s.toml:4:12", "'asks'"},
    {"where = 'grade(X) + grade(Y) >= 5'", "where = 'norm2(X) >= 0'", "a.toml:36:10",
     "the domain of a function must not depend on numbers", "norm2(X) >= 0", in_norm2},
    {"where = 'grade(X) + grade(Y) >= 5'", "where = 'grade(X)'", "a.toml:36:10", "a number where a truth is needed",
     "grade(X)", in_norm2},
};
const broken orders[] = {
    {"'side(H, p)' = 'sign(meet(H, p))'", "'side(H, p)' = {is = 'sign(meet(H, p))', orders = 'touch'}", "a.toml:32:51",
     "'side' orders touch only as a function of its first operand, which has two points, and of a pair of its second "
     "ones",
     "'touch'", "", "'side(sphere, point)'"},
    {"where = 'grade", "orders = 'touch'\nwhere = 'grade", "a.toml:36:10", "'meet' orders touch and must be a sign",
     "'touch'", "", "'meet(sphere, sphere)'"},
};
const broken contacts[] = {
    {"hit =", "contacts = 'side'\nhit =", "a.toml:40:12",
     "contacts are found of two or three points and three, and of a ball (a point, then its radius) and two points, "
     "and "
     "touch takes sphere and sphere",
     "'side'", "", "'touch'"},
    {"hit =", "contacts = 'witness'\nhit =", "a.toml:40:12",
     "touch must say whether a ball's inside belongs to it; write mode = 'solid' or mode = 'surface'", "'witness'", "",
     "'touch'"},
    {"['S: sphere', 'T: sphere']", "['S: segment', 'T: sphere']\ncontacts = 'witness'", "a.toml:40:12",
     "a witness is placed for a ball (a point, then its radius) and a ball or three points, and touch takes segment "
     "and "
     "sphere",
     "'witness'", "", "'touch'"},
    {"[kinds.segment]",
     "[kinds.triangle]\nstore = ['a: point', 'b: point', 'c: point']\nblade = 'a ^ b ^ c ^ n'\nhull = '[a, b, c]'\n"
     "[predicates.cross]\nof = ['s: segment', 't: triangle']\nhit = 'side(t, s.p) == 0'\ncontacts = 'meet'\n"
     "[kinds.segment]",
     "a.toml:31:12", "'meet' tells the contacts of cross and must be a sign", "'meet'", "", "'meet(triangle, point)'"},
};
} // namespace

TEST_CASE("values of the wrong type") {
  check_broken(values);
}
TEST_CASE("truths of the wrong type") {
  check_broken(truths);
}
TEST_CASE("signs where none can be, and what they cannot be compared with") {
  check_broken(signs);
}
TEST_CASE("calls outside of a function's domain, with the trail") {
  check_broken(calls);
}

TEST_CASE("signs that are not homogeneous are refused where the exact rung needs them to be") {
  const broken rows[] = {
      {hit, "'sign(S.r - 1) > 0'", "s.toml:4:13", "a sign of 'touch' is not homogeneous in the stored numbers", "touch",
       in_touch, touch},
      {hit, "'sign(S.r - 1) > 0'", "s.toml:4:13", "multiply the terms -1 by a number of the kind's own", "touch",
       in_touch, touch},
      {hit, "'S.c.x*S.c.x*S.c.x > S.c.y'", "s.toml:4:13", "by 2 numbers of the kind's own", "touch", in_touch, touch},
  };
  check_broken(rows);
}
TEST_CASE("contacts whose operands do not fit, and a value that is no sign") {
  check_broken(contacts);
}
TEST_CASE("orders of hits whose operands do not fit") {
  check_broken(orders);
}
