// Finds a predicate by its name, and checks the message where there is none.
#include "tests/catch.hpp"
#include "toy.hpp"

#include "meet/core/query/find.hpp"

using namespace meetc;

namespace {

const predicate_info two[] = {toy::rod_rod_hit, toy::ball_box_hit};

catalogue holding(int count) {
  catalogue all{};
  all.space = "toy";
  all.predicates = two;
  all.predicate_count = count;
  return all;
}

} // namespace

TEST_CASE("find: a predicate is found by its whole name") {
  CHECK(&find_predicate(holding(2), "rod_rod") == &two[0]);
  CHECK(&find_predicate(holding(2), "ball_box") == &two[1]);
}

TEST_CASE("find: an unknown name is refused with the names that there are") {
  for (const char *const name : {"ball_bo", "ball_boxes", ""})
    CHECK_THROWS_WITH(find_predicate(holding(2), name),
                      "no predicate '" + std::string(name) + "' in toy; there are: rod_rod, ball_box");
  CHECK_THROWS_WITH(find_predicate(holding(0), "rod_rod"), "no predicate 'rod_rod' in toy; there is none");
}
