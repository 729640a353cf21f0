// Every exponent, every control word, and values that are not numbers.
#include "tests/catch.hpp"
#include "tests/extremes/campaign.hpp"
#include "tests/generated/judge/effort.hpp"

#include <limits>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using namespace meetc::extremes_test;
using meetc::generated_test::effort;
using meetc::generated_test::scaled;

namespace {

// Sets flush-to-zero and rounding as another library might, and restores the old state.
class other_library {
public:
  explicit other_library([[maybe_unused]] unsigned word) {
#if defined(__SSE2__)
    _mm_setcsr((found_ & ~0xe040U) | word);
#endif
  }
  ~other_library() {
#if defined(__SSE2__)
    _mm_setcsr(found_);
#endif
  }
  other_library(const other_library &) = delete;
  other_library &operator=(const other_library &) = delete;

private:
#if defined(__SSE2__)
  unsigned found_ = _mm_getcsr();
#endif
};

} // namespace

TEST_CASE("surroundings: every power of two that float32 has") {
  for (const subject &s : subjects()) {
    random_numbers random(70);
    int exact = 0, wrong = 0;
    for (int i = 0; i < effort(20); ++i) {
      const pair_of_rows p = any_at_home(s.a, s.b, random);
      const int want = s.truth(p.a.data(), p.b.data());
      for (int k = -149; k <= 127; ++k) {
        const pair_of_rows q{scaled(p.a, k), scaled(p.b, k)};
        const outcome o = check_case(s, q, random);
        wrong += o.wrong != 0;
        if (scaled(q.a, -k) == p.a && scaled(q.b, -k) == p.b) { // nothing was lost: the answer is the same
          ++exact;
          wrong += s.hit(q.a.data(), q.b.data()) != want;
        }
      }
    }
    INFO(s.name);
    CHECK(wrong == 0);
    CHECK(exact > effort(20) * 277 / 2);
  }
}

TEST_CASE("surroundings: the answers survive flush-to-zero and other rounding modes") {
  for (const family &f : families())
    for (const subject &s : subjects()) {
      if (!f.applies(s.a, s.b))
        continue;
      INFO(s.name << " on " << f.name);
      random_numbers random(71);
      int wrong = 0;
      for (int i = 0; i < effort(40); ++i) {
        const pair_of_rows p = f.make(s.a, s.b, random);
        const int want = s.truth(p.a.data(), p.b.data());
        for (const unsigned word : {0x8040U, 0x8000U, 0x40U, 0x2000U, 0x4000U, 0x6000U, 0xe040U}) {
          const other_library changed(word);
          wrong += s.hit(p.a.data(), p.b.data()) != want || s.decided(p.a.data(), p.b.data()) != want;
        }
      }
      CHECK(wrong == 0);
    }
}

TEST_CASE("surroundings: a sphere of subnormal numbers is lost to flush-to-zero, and noticed") {
#if defined(__SSE2__)
  // Two balls at a distance of one step: with subnormals read as zero all four numbers are one.
  const subject &s = subject_named("ball_ball");
  const row a = {0, 0, 0, 0x1p-149F}, b = {0x1.8p-147F, 0, 0, 0x1p-148F}; // 6 > 1 + 2
  CHECK(s.hit(a.data(), b.data()) == 0);
  const other_library changed(0x8040U);
  CHECK(s.plain32(a.data(), b.data()) == 1);
  CHECK(s.hit(a.data(), b.data()) == 0);
#endif
}

TEST_CASE("surroundings: operands that are not finite do no harm") {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN(),
                  special[] = {inf, -inf, nan, -nan};
  for (const subject &s : subjects()) {
    INFO(s.name);
    random_numbers random(72);
    bool same = true;
    for (int i = 0; i < effort(1500); ++i) {
      pair_of_rows p = any_scale(s.a, s.b, random);
      for (row *r : {&p.a, &p.b})
        for (float &c : *r)
          if (random.one_in(5))
            c = special[random.integer(0, 3)];
      s.run_all(p.a.data(), p.b.data());
      same = same && s.hit(p.a.data(), p.b.data()) == s.hit(p.a.data(), p.b.data());
    }
    CHECK(same);
  }
}
