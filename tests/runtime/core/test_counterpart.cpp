// Sets that are prepared for collisions with one other set: the answers of whole sets, from fewer elements.
#include "tests/catch.hpp"
#include "toy.hpp"

#include "meet/core/sets/element_set.hpp"

using namespace meetc;
using namespace toy;

namespace {

void same_answers(const rows &small, const rows &large, const predicate_info &p) {
  const prepared x = prepare(view_of(small, *p.a), *p.a, {}, 1), whole = prepare(view_of(large, *p.b), *p.b, {}, 1);
  for (const int threads : {1, 3}) {
    const prepared reduced = prepare(view_of(large, *p.b), *p.b, {}, threads, &x);
    CHECK(reduced.elements() == whole.elements());
    CHECK(reduced.set().elements <= whole.set().elements);
    float lo[3], hi[3], all_lo[3], all_hi[3];
    reduced.bounds(lo, hi);
    whole.bounds(all_lo, all_hi);
    CHECK(std::equal(lo, lo + 3, all_lo));
    CHECK(std::equal(hi, hi + 3, all_hi));
    CHECK(reduced.set().reach == whole.set().reach);
    collide_options o;
    o.threads = threads;
    const result want = collide(x, whole, p, rung::fp32, o), have = collide(x, reduced, p, rung::fp32, o);
    CHECK(same(have.pairs, want.pairs));
    CHECK(have.candidates == want.candidates);
    o.want = answer_kind::flags;
    CHECK(collide(x, reduced, p, rung::fp32, o).flags.b == collide(x, whole, p, rung::fp32, o).flags.b);
  }
}

} // namespace

TEST_CASE("a set prepared for another one answers as the whole set does") {
  const rows large = some_boxes(5000, 1, 0.05f, 110);
  for (const std::size_t n : {0u, 1u, 16u, 17u, 300u, 320u, 5000u}) {
    CAPTURE(n);
    same_answers(some_boxes(n, 1, 0.05f, 111), large, box_box_hit);
    same_answers(some_boxes(n, 0.1f, 0.05f, 112, 0.5f), large, box_box_hit);
    same_answers(some_balls(n, 1, 0.05f, 113), large, ball_box_hit);
    same_answers(some_boxes(n, 1, 0.05f, 114, 9), large, box_box_hit); // nothing is reduced
  }
  same_answers(some_boxes(3, 1, 0.1f, 115), {}, box_box_hit);
  same_answers(some_boxes(40, 1e38f, 2e38f, 116), some_boxes(900, 1e38f, 1e38f, 117), box_box_hit);
}

TEST_CASE("a small set leaves little of a large one") {
  const rows large = some_boxes(20'000, 1, 0.01f, 118);
  const prepared corners =
      prepare(view_of({-0.9f, -0.9f, -0.9f, -0.8f, -0.8f, -0.8f, 0.8f, 0.8f, 0.8f, 0.9f, 0.9f, 0.9f}, boxes), boxes);
  const prepared reduced = prepare(view_of(large, boxes), boxes, {}, 2, &corners); // whose common box is the scene
  CHECK(reduced.set().elements < 100);
  CHECK(reduced.set().elements > 0);
}

TEST_CASE("a set prepared for another one collides with that one alone, and its elements are checked") {
  rows r = some_boxes(50, 1, 0.1f, 119);
  const prepared x = prepare(view_of(r, boxes), boxes), y = prepare(view_of(r, boxes), boxes),
                 reduced = prepare(view_of(r, boxes), boxes, {}, 1, &x);
  CHECK(!reduced.whole());
  CHECK(x.whole());
  CHECK_NOTHROW(collide(x, reduced, box_box_hit, rung::fp32));
  CHECK_NOTHROW(collide(reduced, x, box_box_hit, rung::fp32));
  CHECK_THROWS_AS(collide(y, reduced, box_box_hit, rung::fp32), std::invalid_argument);
  CHECK_THROWS_AS(collide(reduced, reduced, box_box_hit, rung::fp32), std::invalid_argument);
  r[6 * 49] = std::numeric_limits<float>::quiet_NaN();
  CHECK_THROWS_AS(prepare(view_of(r, boxes), boxes, {}, 1, &x), input_error);
  r[6 * 49] = 9; // above its upper end, and far away
  CHECK_THROWS_AS(prepare(view_of(r, boxes), boxes, {}, 1, &x), input_error);
}
