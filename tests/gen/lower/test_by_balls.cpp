// Which predicates are proved to hold exactly where two closed balls touch.
#include "gen/lower/predicate/by_balls.hpp"
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <random>
#include <set>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

bool is_by_balls(const spec_copy &copy) {
  return copy.compile().kernels.front().decision.by_balls;
}

} // namespace

TEST_CASE("by balls: of the shipped predicates, that of two balls") {
  std::set<std::string> proved;
  for (const lower::kernel *k : default_kernels(want::predicates))
    if (k->decision.by_balls)
      proved.insert(k->asked.name());
  CHECK(proved == std::set<std::string>{"ball_ball"});
}

TEST_CASE("by balls: the exact answer is that of the distance and the radii") {
  std::mt19937_64 random(1);
  for (const lower::kernel *k : default_kernels(want::predicates)) {
    const lower::predicate &p = k->decision;
    if (!p.by_balls)
      continue;
    int hits = 0, tangent = 0, different = 0;
    for (int i = 0; i < 2000; ++i) {
      long row[8]; // of each ball the centre and the radius
      for (int j = 0; j < 8; ++j)
        row[j] = static_cast<long>(random() % 5);
      long square = 0;
      for (int axis = 0; axis < 3; ++axis)
        square += (row[axis] - row[4 + axis]) * (row[axis] - row[4 + axis]);
      const long reach = row[3] + row[7];
      const bool touch = square <= reach * reach;
      std::vector<int> signs;
      const std::vector<poly::rational> numbers(row, row + 8);
      for (const poly::poly &atom : p.signs.atoms())
        signs.push_back(sgn(atom.evaluate(numbers)));
      hits += touch, tangent += square == reach * reach;
      different += touch != p.signs.evaluate(p.truths.hit, signs);
    }
    CHECK(different == 0);
    CHECK(hits > 100);
    CHECK(hits < 1900);
    CHECK(tangent > 20);
  }
}

namespace {

// Whether a new predicate `asked`, on a new kind unless there is none, is called a comparison of balls.
bool is_by_balls_of(const std::string &kind, const std::string &predicate) {
  const spec_copy copy({"asked"});
  copy.replace("cga3.toml", "[kinds.segment]", kind + "\n[kinds.segment]");
  copy.replace("predicates/round.toml", "[predicates.ball_ball]",
               "[predicates.asked]\n" + predicate + "\n[predicates.ball_ball]");
  return copy.compile().kernels.front().decision.by_balls;
}
std::string square_of_distance(const std::string &p, const std::string &q) {
  std::string out;
  for (const char *const axis : {".x", ".y", ".z"})
    out += (out.empty() ? "((" : " + (") + p + axis + " - " + q + axis + ")*(" + p + axis + " - " + q + axis + ")";
  return out + ")";
}
std::string hit_where_apart_by(const std::string &reach, const std::string &square) {
  return "hit = 'sign(" + (reach.empty() ? "0" : "(" + reach + ")*(" + reach + ")") + " - " + square + ") >= 0'\n";
}
constexpr const char *spheres = "of = ['S: sphere', 'T: sphere']\n";

} // namespace

TEST_CASE("by balls: of points too, and of two kinds whose numbers lie elsewhere") {
  const std::string radius_first = "[kinds.ball]\nstore = ['r: real', 'c: point']\nblade = '-I*(c - r*r*n)'\n"
                                   "where = 'r > 0'\nhull = '[c]'\npad = 'r'\n";
  CHECK(is_by_balls_of("", spheres + hit_where_apart_by("S.r + T.r", square_of_distance("S.c", "T.c"))));
  CHECK(is_by_balls_of("", "of = ['P: point', 'Q: point']\n" + hit_where_apart_by("", square_of_distance("P", "Q"))));
  CHECK(is_by_balls_of("",
                       "of = ['P: point', 'T: sphere']\n" + hit_where_apart_by("T.r", square_of_distance("P", "T.c"))));
  CHECK(is_by_balls_of("",
                       "of = ['S: sphere', 'P: point']\n" + hit_where_apart_by("S.r", square_of_distance("S.c", "P"))));
  CHECK(is_by_balls_of(radius_first, "of = ['S: ball', 'T: sphere']\n" +
                                         hit_where_apart_by("S.r + T.r", square_of_distance("S.c", "T.c"))));
}

TEST_CASE("by balls: not claimed of predicates that only look like two balls") {
  const std::string reach = "S.r + T.r";
  // A capsule, of which one end is compared.
  CHECK_FALSE(is_by_balls_of("[kinds.capsule]\nstore = ['p: point', 'q: point', 'r: real']\nblade = 'p^q^n'\n"
                             "where = 'r >= 0'\nhull = '[p, q]'\npad = 'r'\n",
                             "of = ['S: capsule', 'T: capsule']\n" +
                                 hit_where_apart_by(reach, square_of_distance("S.p", "T.p"))));
  // The rule is of another number, so that the radius can be negative.
  CHECK_FALSE(
      is_by_balls_of("[kinds.ball]\nstore = ['c: point', 'r: real', 's: real']\nblade = '-I*(c - r*r*n)'\n"
                     "where = 's >= 0'\nhull = '[c]'\npad = 'r'\n",
                     "of = ['S: ball', 'T: ball']\n" + hit_where_apart_by(reach, square_of_distance("S.c", "T.c"))));
  // There is a reject stage.
  CHECK_FALSE(is_by_balls_of("", spheres + ("reject = ['sign(S.r - T.r) > 0']\n" +
                                            hit_where_apart_by(reach, square_of_distance("S.c", "T.c")))));
  // One has no third coordinate.
  CHECK_THROWS_WITH(
      is_by_balls_of("[kinds.flat]\nstore = ['x: real', 'y: real']\nposition = true\n"
                     "blade = '2*(x*e1 + y*e2) + (x*x + y*y)*n - nb'\n",
                     "of = ['S: flat', 'T: sphere']\nhit = 'sign(T.r*T.r - ((S.x - T.c.x)*(S.x - T.c.x) + "
                     "(S.y - T.c.y)*(S.y - T.c.y))) >= 0'\n"),
      contains("kind 'flat' stores 2 coordinates, but 'axes' has 3"));
  // The coordinates of its hull are exchanged.
  CHECK_FALSE(
      is_by_balls_of("[kinds.ball]\nstore = ['c: point', 'r: real']\nblade = '-I*(c - r*r*n)'\n"
                     "where = 'r >= 0'\nhull = '[point(c.y, c.x, c.z)]'\npad = 'r'\n",
                     "of = ['S: ball', 'T: ball']\n" + hit_where_apart_by(reach, square_of_distance("S.c", "T.c"))));
}

TEST_CASE("by balls: not claimed where the decision, or the kind, is another one") {
  const struct {
    const char *file, *from, *to;
  } changes[] = {
      {"predicates/round.toml", "4*S.r*T.r) >= 0", "4*S.r*T.r) > 0"},
      {"predicates/round.toml", "4*S.r*T.r) >= 0", "4*S.r*T.r) <= 0"},
      {"predicates/round.toml", "4*S.r*T.r", "2*S.r*T.r"},
      {"predicates/round.toml", "4*S.r*T.r", "4*S.r*S.r"},
      {"predicates/round.toml", "4*S.r*T.r) >= 0", "4*S.r*T.r) >= 0 and sign(S.r - T.r) >= 0"},
      {"predicates/round.toml", "sign(((I*S) | (I*T)) + 4*S.r*T.r) >= 0", "sign(norm2(meet(S, T))) >= 0"},
      {"cga3.toml", "where = 'r >= 0'", ""}, // the radius may be negative
  };
  const spec_copy unchanged({"ball_ball"});
  CHECK(is_by_balls(unchanged));
  for (const auto &m : changes) {
    INFO("'" << m.from << "' to '" << m.to << "'");
    const spec_copy copy({"ball_ball"});
    copy.replace(m.file, m.from, m.to);
    CHECK_FALSE(is_by_balls(copy));
  }
}
