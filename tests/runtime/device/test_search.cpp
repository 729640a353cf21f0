// The model that chooses how a device finds candidates.
#include "core/device/search.hpp"
#include "tests/catch.hpp"

#include <string>

using namespace meetc;

TEST_CASE("search: small sets take every pair, large ones a hierarchy, whose cost is not a product") {
  CHECK(expected_costs({.a = 300, .b = 300}).least() == search::every_pair);
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

TEST_CASE("search: each has a name") {
  for (int i = 0; i < searches; ++i)
    CHECK(!std::string(name_of(static_cast<search>(i))).empty());
}
