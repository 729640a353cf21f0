// Which predicates are proved to hold exactly where the boxes of their operands touch.
#include "gen/lower/predicate/by_boxes.hpp"
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <random>
#include <set>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

bool is_by_boxes(const spec_copy &copy) {
  return copy.compile().kernels.front().decision.by_boxes;
}

} // namespace

TEST_CASE("by boxes: of the shipped predicates, that of two boxes") {
  std::set<std::string> proved;
  for (const lower::kernel *k : default_kernels(want::predicates))
    if (k->decision.by_boxes)
      proved.insert(k->asked.name());
  CHECK(proved == std::set<std::string>{"box_box"});
}

TEST_CASE("by boxes: the exact answer is that of comparing the boxes") {
  std::mt19937_64 random(1);
  for (const lower::kernel *k : default_kernels(want::predicates)) {
    const lower::predicate &p = k->decision;
    if (!p.by_boxes)
      continue;
    int hits = 0, different = 0;
    for (int i = 0; i < 2000; ++i) {
      std::vector<poly::rational> numbers; // of each box the least and the greatest corner
      bool touch = true;
      for (int box = 0; box < 2; ++box) {
        long low[3], high[3];
        for (int axis = 0; axis < 3; ++axis) {
          const long x = static_cast<long>(random() % 5), y = static_cast<long>(random() % 5);
          low[axis] = std::min(x, y), high[axis] = std::max(x, y);
        }
        numbers.insert(numbers.end(), low, low + 3);
        numbers.insert(numbers.end(), high, high + 3);
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
        touch = touch && numbers[axis] <= numbers[9 + axis] && numbers[6 + axis] <= numbers[3 + axis];
      std::vector<int> signs;
      for (const poly::poly &atom : p.signs.atoms())
        signs.push_back(sgn(atom.evaluate(numbers)));
      hits += touch;
      different += touch != p.signs.evaluate(p.truths.hit, signs);
    }
    CHECK(different == 0);
    CHECK(hits > 100);
    CHECK(hits < 1900);
  }
}

TEST_CASE("by boxes: not claimed where the decision, or the box, is another one") {
  const char *const file = "primitives/box.toml";
  const struct {
    const char *from, *to;
  } changes[] = {
      {"A.low[k] <= B.high[k] and", "A.low[k] < B.high[k] and"},
      {"A.low[k] <= B.high[k] and B.low[k] <= A.high[k]", "A.low[k] <= B.high[k]"},
      {"A.low[k] <= B.high[k] and", "A.low[k] <= B.low[k] and"},
      {"all(k in axes: A.low", "any(k in axes: A.low"},
      {"where = 'low <= high'\n", ""},           // either corner may then be the lesser one
      {"high, point(low.x", "low, point(low.x"}, // still a corner with each end
  };
  for (const auto &m : changes) {
    INFO("'" << m.from << "' to '" << m.to << "'");
    const spec_copy copy({"box_box"});
    CHECK(is_by_boxes(copy));
    copy.replace(file, m.from, m.to);
    CHECK(is_by_boxes(copy) == (std::string(m.to) == "low, point(low.x"));
  }
}
