// Two boxes against exact answers, on every family of operands, under every control word. (All other predicates are judged in
// tests/extremes, on more families and every rung.)
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/judge.hpp"
#include "tests/generated/judge/operands.hpp"

#include <algorithm>
#include <limits>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using namespace meetc::generated_test;

namespace {

struct control_word {
  unsigned found = 0;
  explicit control_word([[maybe_unused]] unsigned set) {
#if defined(__SSE2__)
    found = _mm_getcsr();
    _mm_setcsr((found & ~0xe040U) | set);
#endif
  }
  ~control_word() {
#if defined(__SSE2__)
    _mm_setcsr(found);
#endif
  }
  control_word(const control_word &) = delete;
  control_word &operator=(const control_word &) = delete;
};

// Calls f for the predicate of two boxes, whose order of rows is the catalogue's.
template <class F> void for_two_boxes(F &&f) {
  int predicates = 0;
  for_each_predicate([&](auto p) {
    if constexpr (p.a == shape::box && p.b == shape::box) {
      ++predicates;
      f(p);
    }
  });
  CHECK(predicates == 1);
}

} // namespace

TEST_CASE("two boxes: every way against the oracle and against separating axes, on every family") {
  for_two_boxes([](auto p) {
    std::uint64_t seed = 1;
    int all = 0, hits = 0;
    for (const family &f : families()) {
      INFO(p.name << " on " << f.name);
      random_numbers random(seed++);
      int wrong = 0;
      for (int i = 0; i < effort(1200); ++i, ++all) {
        const pair_of_rows rows = f.make(p.a, p.b, random);
        const bool want = touching(p.a, rows.a, p.b, rows.b, p.surface);
        hits += want;
        // A difference of two numbers has the sign of the rounded one.
        wrong += p.hit(rows.a, rows.b) != want || p.template plain<float>(rows.a, rows.b) != want ||
                 p.template plain<double>(rows.a, rows.b) != want || touching_by_axes(p.a, rows.a, p.b, rows.b) != want;
        for (const unsigned word : {0x8040U, 0x2000U, 0x4000U, 0x6000U, 0xe040U}) { // FTZ, DAZ; down, up, to zero; all
          const control_word changed(word);
          wrong += p.hit(rows.a, rows.b) != want;
        }
      }
      CHECK(wrong == 0);
    }
    CHECK(hits > all / 10);
    CHECK(hits < all - all / 10);
  });
}

TEST_CASE("two boxes: numbers that are not finite do no harm") {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN(),
                  special[] = {inf, -inf, nan, -nan, 0x1p-149F, std::numeric_limits<float>::max()};
  for_two_boxes([&](auto p) {
    random_numbers random(31);
    int answers[2] = {0, 0};
    for (const family &f : families())
      for (int i = 0; i < effort(60); ++i) {
        pair_of_rows c = f.make(p.a, p.b, random);
        for (row *r : {&c.a, &c.b})
          for (float &number : *r)
            if (random.one_in(4))
              number = special[random.integer(0, 5)];
        const bool hit = p.hit(c.a, c.b);
        CHECK(hit == p.hit(c.a, c.b));
        ++answers[hit];
      }
    CHECK(answers[0] > 0);
    CHECK(answers[1] > 0);
  });
}
