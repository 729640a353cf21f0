// The tests of one box against blocks, for every instruction set that runs here: they find what the plain loop does.
#include "core/box_tests.hpp"

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

TEST_CASE("box tests: every instruction set finds what the plain loop finds") {
  int sets = 0;
  for (int set = 0; set < instruction_set_count; ++set) {
    const box_tests *const tests = box_tests_for(static_cast<instruction_set>(set));
    if (!tests)
      continue;
    ++sets;
    CHECK(tests->compiled_for == static_cast<instruction_set>(set));
    INFO(name_of(tests->compiled_for));
    std::mt19937 random(5);
    int some = 0, none = 0;
    for (int i = 0; i < 2000; ++i) {
      const blocks b(random, 4);
      const box q = any_box(random);
      for (std::size_t k = 0; k < b.count; ++k) {
        const std::uint32_t mask = touching(b.of[k], q);
        REQUIRE(tests->touching(b.of[k], q) == mask);
        ++(mask != 0 ? some : none);
      }
    }
    CHECK(some > 1000);
    CHECK(none > 1000);
  }
  CHECK(sets >= 1);
  CHECK(best_box_tests().compiled_for >= instruction_set::baseline);
}

TEST_CASE("box tests: the pairs of an element with chosen blocks, in order, either way round, within their room") {
  for (int set = 0; set < instruction_set_count; ++set) {
    const box_tests *const tests = box_tests_for(static_cast<instruction_set>(set));
    if (!tests)
      continue;
    INFO(name_of(tests->compiled_for));
    std::mt19937 random(6);
    for (int i = 0; i < 500; ++i) {
      const blocks b(random, 8);
      std::vector<std::uint32_t> chosen;
      for (std::uint32_t k = 0; k < b.count; ++k)
        if (random() % 2 != 0)
          chosen.push_back(k);
      const box q = any_box(random);
      for (const bool swapped : {false, true}) {
        const std::uint32_t slot = 0xfffffff0U - static_cast<std::uint32_t>(i);
        std::vector<index_pair> want;
        for (const std::uint32_t block : chosen)
          for (std::uint32_t lane = 0; lane < lanes; ++lane)
            if (touching(b.of[block], q) >> lane & 1) {
              const std::uint32_t theirs = block * lanes + lane;
              want.push_back(swapped ? index_pair{theirs, slot} : index_pair{slot, theirs});
            }
        // A sanitizer sees what is written beyond the room.
        const std::unique_ptr<index_pair[]> room(new index_pair[chosen.size() * lanes]);
        const index_pair *const end =
            tests->pairs({b.of.get(), chosen.data(), chosen.size(), q, slot, swapped}, room.get());
        REQUIRE(static_cast<std::size_t>(end - room.get()) == want.size());
        for (std::size_t k = 0; k < want.size(); ++k)
          REQUIRE((room[k].a == want[k].a && room[k].b == want[k].b));
      }
    }
  }
}

TEST_CASE("box tests: the leaves that a block of elements may touch, and which elements do") {
  for (int set = 0; set < instruction_set_count; ++set) {
    const box_tests *const tests = box_tests_for(static_cast<instruction_set>(set));
    if (!tests)
      continue;
    INFO(name_of(tests->compiled_for));
    std::mt19937 random(7);
    std::size_t found = 0, before = 0;
    for (int i = 0; i < 2000; ++i) {
      const blocks leaves(random, 3 * lanes), others(random, 2); // a walker, and the boxes around sixteen leaves
      const auto first = static_cast<std::uint32_t>(lanes * (random() % 3)),
                 from = static_cast<std::uint32_t>(random() % (4 * lanes));
      const box around = any_box(random);
      std::vector<std::uint32_t> numbers, elements;
      for (std::uint32_t lane = 0; lane < lanes; ++lane) {
        if (!(touching(others.of[1], around) >> lane & 1) || touching(leaves.of[first + lane], around) == 0)
          continue;
        const std::uint32_t walkers = touching(others.of[0], others.of[1].get(static_cast<int>(lane)));
        if (walkers == 0)
          continue;
        before += first + lane < from;
        if (first + lane >= from)
          numbers.push_back(first + lane), elements.push_back(walkers);
      }
      std::vector<std::uint32_t> got(lanes), got_elements(lanes);
      const std::size_t n = tests->leaves({&others.of[0], leaves.of.get(), &others.of[1], first, from, around},
                                          got.data(), got_elements.data());
      got.resize(n), got_elements.resize(n);
      REQUIRE(got == numbers);
      REQUIRE(got_elements == elements);
      found += n;
    }
    CHECK(found > 100);
    CHECK(before > 100);
  }
}
