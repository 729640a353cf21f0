// Groups of numbers: the weights that a sign's polynomial has.
#include "gen/bound/grading.hpp"
#include "tests/catch.hpp"

using namespace meetc;

namespace {

// A plane (N, d) and a sphere (c, r); c is a position.
struct space {
  meetc::poly::ring numbers{{"N.x", "N.y", "d", "c.x", "c.y", "r", "unused"}};
  meetc::poly::local_origin local{numbers,
                                  {{0, 0, 0, false},
                                   {0, 0, 1, false},
                                   {0, -1, 0, false},
                                   {1, 1, 0, true},
                                   {1, 1, 1, true},
                                   {1, -1, 0, false},
                                   {1, -1, 0, false}}};
  meetc::poly::poly at(const std::string &name) const {
    return meetc::poly::poly::variable(numbers, numbers.find(name));
  }
  meetc::poly::poly number(int n) const { return {numbers, n}; }
  meetc::poly::poly above() const { return at("N.x") * at("c.x") + at("N.y") * at("c.y") - at("d"); }
  meetc::poly::poly cut() const {
    return at("r") * at("r") * (at("N.x") * at("N.x") + at("N.y") * at("N.y")) - above() * above();
  }
};

// Whether every polynomial has one degree in each group.
bool is_graded(const bound::grading &g, const std::vector<const meetc::poly::poly *> &signs) {
  for (const meetc::poly::poly *p : signs)
    for (int j = 0; j < g.groups(); ++j) {
      std::vector<int> degrees;
      for (const auto &t : p->terms()) {
        int sum = 0;
        for (const auto &f : t.factors)
          sum += f.exponent * g.weights[static_cast<std::size_t>(f.variable)][static_cast<std::size_t>(j)];
        degrees.push_back(sum);
      }
      for (const int d : degrees)
        if (d != degrees.front())
          return false;
    }
  return true;
}

} // namespace

TEST_CASE("grading: a plane and a sphere have the groups of normals and of lengths, and an offset is of both") {
  const space s;
  const auto f = s.cut();
  const auto g = bound::find_grading({&f}, s.local);
  REQUIRE(g);
  CHECK(g->groups() == 2);
  CHECK(is_graded(*g, {&f}));
  using weights = std::vector<int>;
  CHECK(g->weights == std::vector<weights>{{0, 1}, {0, 1}, {1, 1}, {1, 0}, {1, 0}, {1, 0}, {0, 0}});
  CHECK(g->total() == weights{1, 1, 2, 1, 1, 1, 0});
  // The check can fail.
  const auto other = f + s.at("r");
  CHECK_FALSE(is_graded(*g, {&other}));
}

TEST_CASE("grading: what is homogeneous as it stands has no groups") {
  const space s;
  const auto f = s.at("c.x") * s.at("c.x") + s.at("c.y") * s.at("c.y") - s.at("r") * s.at("r"), g = s.at("N.x");
  const auto found = bound::find_grading({&f, &g}, s.local);
  REQUIRE(found);
  CHECK(found->weights.empty());
}

TEST_CASE("grading: signs share their groups, or have none") {
  const space s;
  const auto above = s.above(), whole = s.at("r") * s.at("r") - s.at("d"), one = s.at("r") - s.number(1),
             axes = s.at("c.x") * s.at("c.x") - s.at("c.y");
  const auto both = bound::find_grading({&above, &whole}, s.local); // normals then weigh as lengths do
  REQUIRE(both);
  CHECK(is_graded(*both, {&above, &whole}));
  CHECK(bound::find_grading({&whole}, s.local));
  const auto linear = s.at("r") - s.at("d");
  CHECK_FALSE(bound::find_grading({&whole, &linear}, s.local));
  CHECK_FALSE(bound::find_grading({&one}, s.local));
  CHECK_FALSE(bound::find_grading({&axes}, s.local)); // coordinates are subtracted from each other
}
