// Sets whose numbers are very small or very large: rungs that are never wrong read them multiplied by a power of two,
// exactly or not at all.
#include "tests/catch.hpp"
#include "toy.hpp"

#include "meet/core/sets/normalised.hpp"

#include <atomic>
#include <cmath>

using namespace meetc;
using namespace toy;

namespace {

std::atomic<float> largest{0};

// boxes_hit, with a record of the numbers.
void decide_seen(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 6; ++k)
      largest = std::max({largest.load(), std::abs(a.rows[6 * pairs[i].a + k]), std::abs(b.rows[6 * pairs[i].b + k])});
  decide<6, 6, boxes_hit>(a, b, pairs, n, out);
}
constexpr predicate_info seen = plain("seen", "", boxes, boxes, decide_seen, decide_seen);

rows times(rows r, double factor) {
  for (float &v : r)
    v = static_cast<float>(v * factor);
  return r;
}

prepared prepared_boxes(const rows &r) {
  return prepare(view_of(r, boxes), boxes);
}

} // namespace

TEST_CASE("the power is a multiple of 16, 0 for common sizes, and brings the larger set to between 1 and 2^16") {
  for (int e = -149; e < 128; ++e) {
    const auto size = static_cast<float>(std::ldexp(1.0, e));
    const prepared x = prepared_boxes({0, 0, 0, size, size, size}), y = prepared_boxes({0, 0, 0, 0, 0, size / 4});
    const int power = normalising_power(x.set(), y.set());
    CAPTURE(e, power);
    CHECK(power % 16 == 0);
    CHECK((power == 0) == (e >= -8 && e < 20));
    CHECK(power == normalising_power(y.set(), x.set()));
    if (power != 0) {
      CHECK(e + power >= 0);
      CHECK(e + power < 16);
    }
  }
  const prepared none = prepared_boxes({}), zeros = prepared_boxes({0, 0, 0, 0, 0, 0});
  CHECK(normalising_power(none.set(), none.set()) == 0);
  CHECK(normalising_power(zeros.set(), zeros.set()) == 0);
}

TEST_CASE("answers of normalised sets are those of the sets, and a plain rung reads the numbers as they are") {
  const rows small = some_boxes(800, 1, 0.2F, 21), other = some_boxes(700, 0.5F, 0.2F, 22);
  const auto want = collide(prepared_boxes(small), prepared_boxes(other), seen, rung::exact);
  REQUIRE(want.count > 100);
  for (const double factor : {0x1p-90, 0x1p-40, 0x1p60, 0x1p120}) {
    CAPTURE(factor);
    const prepared x = prepared_boxes(times(small, factor)), y = prepared_boxes(times(other, factor));
    largest = 0;
    const result have = collide(x, y, seen, rung::exact);
    CHECK(same(have.pairs, want.pairs));
    CHECK(have.candidates == want.candidates);
    CHECK(largest >= 0.5F);
    CHECK(largest < 0x1p16F);
    largest = 0;
    CHECK(same(collide(x, y, seen, rung::fp32).pairs, want.pairs));
    CHECK((largest < 0x1p-30F || largest > 0x1p50F));
  }
}

TEST_CASE("a number that would lose a bit leaves both sets as they are") {
  rows large = times(some_boxes(50, 1, 0.5F, 23), 0x1p100), with_small = large;
  with_small[0] = -0x1.8p-140F; // a box below it stays one
  with_small[3] = std::max(with_small[3], 0.0F);
  const prepared x = prepared_boxes(large), y = prepared_boxes(with_small);
  CHECK(x.normalised(-96) != nullptr);
  CHECK(y.normalised(-96) == nullptr);
  CHECK(y.normalised(-48) == nullptr);
  CHECK(y.normalised(16) != nullptr);
  largest = 0;
  const result have = collide(x, y, seen, rung::exact);
  CHECK(largest > 0x1p90F);
  CHECK(same(have.pairs, collide(x, y, seen, rung::fp32).pairs));
  // A caller that flushes subnormals gets the same.
#if defined(__SSE2__)
  const auto before = control_word();
  set_control_word(before | 0x8040); // flush to zero, denormals are zero
  const bool refused = y.normalised(-96) == nullptr;
  const bool exact_in_small = prepared_boxes({0, 0, 0, 0, 0, 0x1p-140F}).normalised(96) != nullptr;
  set_control_word(before);
  CHECK(refused);
  CHECK(exact_in_small);
#endif
}

TEST_CASE("a normalised set is made once for a power") {
  const prepared x = prepared_boxes(times(some_boxes(50, 1, 0.5F, 24), 0x1p40));
  const auto first = x.normalised(-32);
  CHECK(x.normalised(-32) == first);
  CHECK(x.normalised(-16) != first);
  REQUIRE(first != nullptr);
  for (std::size_t i = 0; i < 6 * x.set().elements; ++i)
    CHECK(first->set.rows[i] == x.set().rows[i] * 0x1p-32F);
}
