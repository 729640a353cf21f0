// The model that chooses how a device finds candidates.
#include "core/device/search.hpp"
#include "tests/catch.hpp"

#include <string>

using namespace meetc;

TEST_CASE("search: few elements and many take every pair, large sets a hierarchy, whose cost is not a product") {
  CHECK(expected_costs({.a = 300, .b = 1'000'000}).least() == search::every_pair);
  CHECK(expected_costs({.a = 1'000'000, .b = 1'000'000}).least() == search::tree);
  const auto tree = [](std::uint64_t n) { return expected_costs({.a = n, .b = n}).of[static_cast<int>(search::tree)]; };
  CHECK(tree(16'000'000) < 16.5 * tree(1'000'000));
  CHECK(expected_costs({.a = 1, .b = 22'000'000}).of[static_cast<int>(search::every_pair)] < tree(22'000'000));
}

TEST_CASE("search: what is made already costs nothing, and long elements are not left to enclosing balls") {
  const search_sizes fresh{.a = 50'000, .b = 50'000};
  search_sizes made = fresh, longer = fresh;
  made.made_a = made.made_b = true;
  longer.long_elements = true;
  const auto cost = [](const search_sizes &s, search by) { return expected_costs(s).of[static_cast<int>(by)]; };
  CHECK(cost(made, search::tree) < cost(fresh, search::tree));
  CHECK(cost(longer, search::tree) == cost(fresh, search::tree));
  CHECK(cost(longer, search::every_pair) > cost(fresh, search::every_pair));
  CHECK(cost(longer, search::groups) > cost(fresh, search::groups));
}

TEST_CASE("search: the choice is that which was measured to be the fastest, in the scenes of docs/gpu.md") {
  const auto chosen = [](std::uint64_t a, std::uint64_t b, bool long_elements = false) {
    return expected_costs({.a = a, .b = b, .long_elements = long_elements}).least();
  };
  const auto of_balls = [](std::uint64_t a, std::uint64_t b) {
    return expected_costs({.a = a, .b = b, .balls = true}).least();
  };
  for (const std::uint64_t n : {1'024U, 4'096U, 16'384U, 65'536U, 262'144U, 1'048'576U, 4'194'304U, 16'777'216U})
    CHECK((chosen(n, n) == search::tree && of_balls(n, n) == search::tree));
  CHECK(chosen(69'451, 345'944) == search::tree);
  CHECK(chosen(345'944, 345'944) == search::tree);
  CHECK(chosen(4'444'864, 22'140'416) == search::tree);
  CHECK(chosen(100, 4'444'864, true) == search::tree);
  CHECK(chosen(10'000, 4'444'864, true) == search::tree);
  // Groups of a small set are large, and each touches many of a large one.
  CHECK(chosen(500, 2'000'000) == search::every_pair);
  CHECK(chosen(2'000'000, 20) == search::every_pair);
  CHECK(chosen(100, 12'000'000) == search::tree); // two tiles of the filter, of which the second is half empty
  CHECK(chosen(2'000, 5'000'000) == search::tree);
  CHECK(of_balls(500, 2'000'000) == search::tree);
  CHECK(of_balls(2'000'000, 20) == search::tree);
  CHECK(of_balls(20'000, 3'000'000) == search::tree);
}

TEST_CASE("search: each has a name") {
  for (int i = 0; i < searches; ++i)
    CHECK(!std::string(name_of(static_cast<search>(i))).empty());
}
