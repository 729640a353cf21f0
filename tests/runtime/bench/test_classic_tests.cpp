// The classic tests for each instruction set: in lanes they give the scalar tests' answers, and these the exact ones where
// no rounding matters.
#include "tests/catch.hpp"

#include "app/made_sets.hpp"
#include "bench/classic_set.hpp"

#include <cga/cga_runtime.hpp>

#include <algorithm>
#include <limits>
#include <random>

using meetc::answer;
using meetc::baselines::classic_function;
using meetc::baselines::classic_table;
using meetc::bench::classic_set;

namespace {

// Element i of a against all of b.
std::vector<answer> answers(classic_function f, const classic_set &a, std::size_t i, const classic_set &b,
                            std::size_t from, std::size_t n) {
  constexpr std::size_t beyond = 16; // a group of lanes may reach beyond n, its answers may not
  std::vector<answer> out(n + beyond, answer::unsure);
  f(a.for_classic(), i, b.for_classic(), from, n, out.data());
  REQUIRE(std::count(out.begin() + static_cast<std::ptrdiff_t>(n), out.end(), answer::unsure) == beyond);
  out.resize(n);
  return out;
}

classic_set set_of(const char *kind, std::vector<float> rows) {
  return classic_set(meetc::app::of_rows(cga::catalogue(), kind, std::move(rows)));
}

// Each with its name, for each instruction set that runs here.
std::vector<const classic_table *> tables() {
  std::vector<const classic_table *> out;
  for (int s = 0; s < meetc::instruction_set_count; ++s)
    if (const classic_table *t = meetc::baselines::classic_tests_for(static_cast<meetc::instruction_set>(s)))
      out.push_back(t);
  return out;
}

std::vector<float> random_numbers(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1, 1);
  std::vector<float> out(n);
  for (float &x : out)
    x = place(random);
  return out;
}
// Whole numbers: many corners lie in planes of other triangles, and many triangles are coplanar.
std::vector<float> lattice_numbers(std::size_t n, unsigned seed, int most) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> place(0, most);
  std::vector<float> out(n);
  for (float &x : out)
    x = static_cast<float>(place(random));
  return out;
}

answer exact(const char *predicate, const classic_set &a, std::size_t i, const classic_set &b, std::size_t j) {
  const meetc::catalogue &all = cga::catalogue();
  for (int k = 0; k < all.predicate_count; ++k)
    if (all.predicates[k].name == std::string_view(predicate)) {
      const meetc::index_pair pair{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)};
      answer out{};
      all.predicates[k].decide[static_cast<int>(meetc::rung::exact)](a.rows(), b.rows(), &pair, 1, &out);
      return out;
    }
  throw std::logic_error("no such predicate");
}

constexpr std::size_t odd = 203; // no multiple of any number of lanes

} // namespace

TEST_CASE("each instruction set of this build has the classic tests, and says which it is") {
  REQUIRE(!tables().empty());
  CHECK(tables().front()->compiled_for == meetc::instruction_set::baseline);
  for (int s = 0; s < meetc::instruction_set_count; ++s) {
    const auto set = static_cast<meetc::instruction_set>(s);
    const classic_table *const t = meetc::baselines::classic_tests_for(set);
    CHECK((t != nullptr) == (cga::catalogue_for(set) != nullptr));
    CHECK((!t || t->compiled_for == set));
  }
}

TEST_CASE("Moeller's test in lanes gives the answers of the scalar one with stored planes, and of the published one") {
  for (const classic_table *t : tables()) {
    INFO(name_of(t->compiled_for));
    const classic_set a = set_of("triangle", random_numbers(9 * odd, 1)),
                      b = set_of("triangle", random_numbers(9 * odd, 2));
    std::size_t hits = 0;
    for (std::size_t i = 0; i < odd; ++i) {
      const std::vector<answer> scalar = answers(t->moller_stored, a, i, b, 0, odd);
      REQUIRE(answers(t->moller_lanes, a, i, b, 0, odd) == scalar);
      // Random triangles are far from where roundings differ.
      REQUIRE(answers(t->moller, a, i, b, 0, odd) == scalar);
      REQUIRE(answers(t->guigue_devillers, a, i, b, 0, odd) == scalar);
      for (std::size_t j = 0; j < odd; ++j) {
        REQUIRE(scalar[j] == exact("triangle_triangle", a, i, b, j));
        hits += scalar[j] == answer::yes;
      }
      // A part of b, from the middle of it.
      const std::vector<answer> part = answers(t->moller_lanes, a, i, b, 32, 77);
      REQUIRE(std::equal(part.begin(), part.end(), scalar.begin() + 32));
    }
    CHECK(hits > odd * odd / 20);
    CHECK(hits < odd * odd / 2);
  }
}

TEST_CASE("the lanes agree with the scalar test on degenerate triangles and on numbers that are not finite") {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> rows = lattice_numbers(9 * odd, 3, 3), broken = random_numbers(9 * 20, 4);
  for (std::size_t i = 0; i < broken.size(); i += 7)
    broken[i] = i % 2 ? inf : i % 3 ? nan : 1e30F;
  rows.insert(rows.end(), broken.begin(), broken.end());
  for (const classic_table *t : tables()) {
    INFO(name_of(t->compiled_for));
    const classic_set a = set_of("triangle", rows);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < a.count(); ++i) {
      const std::vector<answer> scalar = answers(t->moller_stored, a, i, a, 0, a.count());
      REQUIRE(answers(t->moller_lanes, a, i, a, 0, a.count()) == scalar);
      hits += static_cast<std::size_t>(std::count(scalar.begin(), scalar.end(), answer::yes));
    }
    CHECK(hits > a.count() * a.count() / 20);
  }
}

TEST_CASE("the Euclidean test in lanes gives the scalar one's answers, and the exact ones on whole numbers") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> rows = lattice_numbers(4 * odd, 5, 4);
  rows.insert(rows.end(), {nan, 0, 0, 1, 0, nan, 0, 1e30F});
  for (const classic_table *t : tables()) {
    INFO(name_of(t->compiled_for));
    const classic_set a = set_of("sphere", rows);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < a.count(); ++i) {
      const std::vector<answer> scalar = answers(t->balls, a, i, a, 0, a.count());
      REQUIRE(answers(t->balls_lanes, a, i, a, 0, a.count()) == scalar);
      for (std::size_t j = 0; i < odd && j < odd; ++j) {
        REQUIRE(scalar[j] == exact("ball_ball", a, i, a, j));
        hits += scalar[j] == answer::yes;
      }
    }
    CHECK(hits > odd * odd / 10);
    CHECK(hits < odd * odd);
  }
}

TEST_CASE("what our predicates store is computed for a classic set") {
  const classic_set a = set_of("triangle", random_numbers(9 * odd, 6));
  const meetc::catalogue &all = cga::catalogue();
  for (int k = 0; k < all.predicate_count; ++k)
    if (all.predicates[k].name == std::string_view("triangle_triangle")) {
      REQUIRE(all.predicates[k].stored_a.floats > 0);
      CHECK(meetc::bench::stored_for(all.predicates[k].stored_a, a).size() ==
            odd * static_cast<std::size_t>(all.predicates[k].stored_a.floats));
      CHECK(meetc::bench::stored_for({}, a).empty());
    }
}
