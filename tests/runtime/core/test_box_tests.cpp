// The tests of one box against blocks, for every instruction set that runs here: they find what the plain loop does.
#include "meet/core/hierarchy/box_tests.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

using namespace meetc;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

// Coordinates that are often equal, and now and then no numbers.
float any(std::mt19937 &random) {
  const unsigned n = random() % 64;
  return n == 0 ? nan : n == 1 ? inf : n == 2 ? -inf : n == 3 ? -0.0F : static_cast<float>(n % 8) * 0x1p-3F;
}
box any_box(std::mt19937 &random) {
  box b{};
  for (int k = 0; k < 3; ++k) {
    const float x = any(random), y = any(random);
    b.lo[k] = y < x ? y : x, b.hi[k] = y < x ? x : y;
  }
  return b;
}

struct blocks {
  std::unique_ptr<box_block[]> of; // aligned, as the type asks
  std::size_t count;
  blocks(std::mt19937 &random, std::size_t n) : of(new box_block[n]), count(n) {
    for (std::size_t i = 0; i < n; ++i) {
      for (int lane = 0; lane < lanes; ++lane)
        of[i].set(lane, any_box(random));
      of[i].clear(static_cast<int>(random() % (lanes + 1)));
    }
  }
};

} // namespace

TEST_CASE("box tests: the boxes of chosen blocks, by their numbers") {
  int sets = 0;
  for (int set = 0; set < instruction_set_count; ++set) {
    const box_tests *const tests = box_tests_for(static_cast<instruction_set>(set));
    if (!tests)
      continue;
    ++sets;
    CHECK(tests->compiled_for == static_cast<instruction_set>(set));
    INFO(name_of(tests->compiled_for));
    std::mt19937 random(8);
    std::size_t found = 0;
    for (int i = 0; i < 500; ++i) {
      const blocks b(random, 2 * lanes);
      std::vector<std::uint32_t> chosen, want;
      for (std::uint32_t k = 0; k < b.count; ++k)
        if (random() % 2 != 0)
          chosen.push_back(k);
      const box q = any_box(random);
      for (const std::uint32_t block : chosen)
        for (std::uint32_t lane = 0; lane < lanes; ++lane)
          if (touching(b.of[block], q) >> lane & 1)
            want.push_back(block * lanes + lane);
      const std::unique_ptr<std::uint32_t[]> room(new std::uint32_t[chosen.size() * lanes]);
      const std::size_t n = tests->touched(b.of.get(), chosen.data(), chosen.size(), q, room.get());
      REQUIRE(std::vector(room.get(), room.get() + n) == want);
      found += n;
    }
    CHECK(found > 1000);
  }
  CHECK(sets >= 1);
  CHECK(best_box_tests().compiled_for >= instruction_set::baseline);
}

TEST_CASE("box tests: the meetings of a block of elements with chosen blocks, element by element, and their pairs") {
  for (int set = 0; set < instruction_set_count; ++set) {
    const box_tests *const tests = box_tests_for(static_cast<instruction_set>(set));
    if (!tests)
      continue;
    INFO(name_of(tests->compiled_for));
    std::mt19937 random(7);
    std::size_t found = 0, none = 0;
    for (int i = 0; i < 2000; ++i) {
      const blocks walker(random, 1), others(random, 3 * lanes);
      // The boxes around those blocks. Some hold less than their block: where the walker or an element of it does not touch
      // them, nothing is found, whatever the block holds.
      const std::unique_ptr<box_block[]> above(new box_block[3]);
      for (std::uint32_t k = 0; k < others.count; ++k)
        above[k / lanes].set(static_cast<int>(k % lanes), random() % 4 == 0 ? any_box(random) : others.of[k].around());
      const box around = random() % 4 == 0 ? any_box(random) : walker.of[0].around();
      std::vector<std::uint32_t> chosen;
      for (std::uint32_t k = 0; k < others.count && chosen.size() < lanes; ++k)
        if (random() % 3 != 0)
          chosen.push_back(k);
      if (random() % 4 == 0)
        chosen.resize(random() % (chosen.size() + 1));

      std::vector<meeting> want;
      for (std::uint32_t lane = 0; lane < lanes; ++lane)
        for (const std::uint32_t block : chosen) {
          const box mine = walker.of[0].get(static_cast<int>(lane)),
                    whole = above[block / lanes].get(static_cast<int>(block % lanes));
          const bool meets = (touching(walker.of[0], whole) >> lane & 1) && touching(others.of[block], around) != 0;
          const std::uint32_t mask = touching(others.of[block], mine);
          if (meets && mask != 0)
            want.push_back({block * lanes + lane, mask});
          none += !meets;
        }
      const std::unique_ptr<meeting[]> room(new meeting[most_meetings]);
      const std::size_t n = tests->meetings(
          {walker.of.get(), others.of.get(), above.get(), chosen.data(), chosen.size(), around}, room.get());
      REQUIRE(n == want.size());
      for (std::size_t k = 0; k < n; ++k)
        REQUIRE((room[k].block_and_lane == want[k].block_and_lane && room[k].mask == want[k].mask));
      found += n;

      if (n > 0 && random() % 4 == 0)
        want[0].mask = room[0].mask = 0; // a walk may empty some
      for (const bool swapped : {false, true}) {
        const std::uint32_t first = 0xfffffff0U - lanes * static_cast<std::uint32_t>(i);
        std::vector<index_pair> want_pairs;
        for (const meeting &m : want)
          for (std::uint32_t lane = 0; lane < lanes; ++lane)
            if (m.mask >> lane & 1) {
              const std::uint32_t mine = first + m.lane(), theirs = m.block() * lanes + lane;
              want_pairs.push_back(swapped ? index_pair{theirs, mine} : index_pair{mine, theirs});
            }
        const std::unique_ptr<index_pair[]> pairs(new index_pair[n * lanes]);
        const index_pair *const end = tests->pairs_of(room.get(), n, first, swapped, pairs.get());
        REQUIRE(static_cast<std::size_t>(end - pairs.get()) == want_pairs.size());
        for (std::size_t k = 0; k < want_pairs.size(); ++k)
          REQUIRE((pairs[k].a == want_pairs[k].a && pairs[k].b == want_pairs[k].b));
      }
    }
    CHECK(found > 1000);
    CHECK(none > 1000);
  }
}
