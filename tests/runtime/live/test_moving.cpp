// Sets that move: what a refitted set answers, against one that is prepared from the same elements.
#include "scenes.hpp"
#include "tests/catch.hpp"

#include "meet/core/sets/element_set.hpp"

#include <cmath>
#include <limits>

using namespace live_test;

namespace {

pose turned() {
  pose at;
  const double c = std::cos(0.7), s = std::sin(0.7);
  at.m[0] = c, at.m[1] = -s, at.m[4] = s, at.m[5] = c, at.m[3] = 0.125, at.m[11] = -0.0625;
  return at;
}

// Every answer of both sets about `other` is the same, which is b of the predicate, on every rung and number of threads.
void check_same(const prepared &refitted, const prepared &anew, const prepared &other, const predicate_info &p) {
  CHECK(refitted.elements() == anew.elements());
  CHECK(refitted.set().reach == anew.set().reach);
  CHECK(refitted.set().longest == anew.set().longest);
  CHECK(refitted.set().grid == anew.set().grid);
  float ends[2][6];
  refitted.bounds(ends[0], ends[0] + 3), anew.bounds(ends[1], ends[1] + 3);
  CHECK(std::equal(ends[0], ends[0] + 6, ends[1]));
  for (const rung precision : rungs) {
    collide_options o;
    o.first_met = p.first_met != nullptr;
    const result want = collide(anew, other, p, precision, o);
    for (const int threads : {1, 3}) {
      o.threads = threads;
      const result have = collide(refitted, other, p, precision, o);
      CHECK((plain(have.pairs) == plain(want.pairs)));
      CHECK(have.first_met == want.first_met);
    }
    o.first_met = false;
    o.want = answer_kind::counts;
    CHECK(collide(refitted, other, p, precision, o).counts.a == collide(anew, other, p, precision, o).counts.a);
  }
}

} // namespace

TEST_CASE("a mesh that moves answers as if it was prepared anew") {
  const predicate_info &p = predicate("triangle_triangle");
  const mesh at_first = self_test::eight_torus(0.6, 24, 16);
  const mesh other = shaken(at_first, 0.05F, 7);
  const prepared set_b = prepare(other.view(), *p.b);
  pose grid = turned();
  grid.grid = 0x1p-12;
  for (const int threads : {1, 3}) {
    moving_set moving(at_first.view(), *p.a, {}, threads);
    CHECK(moving.looseness() == 1);
    unsigned seed = 1;
    for (const float far : {0.01F, 0.3F, 0.0F})
      for (const pose &at : {pose(), turned(), grid}) {
        mesh m = shaken(at_first, far, ++seed);
        m.index.clear(); // it is not read again
        view v = m.view();
        v.elements = at_first.faces();
        moving.update(v, at, threads);
        m.index = at_first.index;
        const prepared anew = prepare(m.view(), *p.a, at);
        check_same(moving, anew, set_b, p);
        CHECK(plain(self_pairs(moving, m.view(), self_test::predicates()).pairs) ==
              plain(self_pairs(anew, m.view(), self_test::predicates()).pairs));
        const auto pairs = collide(moving, set_b, p, rung::certified).pairs;
        contact_options o;
        o.at_a = at;
        CHECK(contacts(m.view(), other.view(), p, pairs, o).codes ==
              contacts(m.view(), other.view(), p, collide(anew, set_b, p, rung::certified).pairs, o).codes);
      }
    const mesh last = shaken(at_first, 2, seed);
    moving.update(last.view());
    moving.reorder(last.view(), {}, threads);
    CHECK(moving.looseness() == 1);
    check_same(moving, prepare(last.view(), *p.a), set_b, p);
    moving.update(at_first.view());
    check_same(moving, prepare(at_first.view(), *p.a), set_b, p);
  }
}

TEST_CASE("rows that move answer as if they were prepared anew") {
  const mesh other = self_test::eight_torus(0.6, 30, 20);
  for (const char *const name : {"segment_triangle", "ball_triangle"}) {
    const predicate_info &p = predicate(name);
    const bool balls = p.a->fields == 4;
    const prepared set_b = prepare(other.view(), *p.b);
    const auto made = [&](unsigned seed) {
      return balls ? some_balls(700, 0.1F, seed) : some_segments(700, 0.5F, seed);
    };
    const std::vector<float> at_first = made(1);
    moving_set moving(rows(at_first, *p.a), *p.a);
    for (unsigned seed = 2; seed < 5; ++seed) {
      // With a record's other numbers between them, and where nothing is aligned.
      const std::vector<float> numbers = made(seed);
      const auto fields = static_cast<std::size_t>(p.a->fields), stride = 4 * fields + 5;
      std::vector<char> bytes(700 * stride + 1);
      for (std::size_t i = 0; i < 700; ++i)
        std::copy_n(reinterpret_cast<const char *>(&numbers[i * fields]), 4 * fields, &bytes[1 + i * stride]);
      const view v{.data = reinterpret_cast<const float *>(bytes.data() + 1), .stride_bytes = stride, .elements = 700};
      moving.update(v);
      check_same(moving, prepare(v, *p.a), set_b, p);
      CHECK(moving.looseness() > 2); // neighbours are no neighbours any more
      moving.reorder(v);
      CHECK(moving.looseness() == 1);
      moving.update(rows(at_first, *p.a));
      moving.reorder(rows(at_first, *p.a));
    }
  }
}

TEST_CASE("a refused update names the element as preparing does, and leaves the set as it was") {
  const predicate_info &p = predicate("triangle_triangle"), &with_balls = predicate("ball_triangle");
  const mesh good = self_test::eight_torus(0.6, 30, 20);
  const prepared set_b = prepare(good.view(), *p.b);
  const auto refused = [&](moving_set &moving, const view &v, const pose &at, const kind_info &kind) {
    std::string want;
    try {
      prepare(v, kind, at);
    } catch (const input_error &e) {
      want = e.what();
    }
    CHECK(!want.empty());
    CHECK_THROWS_WITH(moving.update(v, at), want);
    CHECK_THROWS_WITH(moving.reorder(v, at), want);
  };
  moving_set moving(good.view(), *p.a);
  const result before = collide(moving, set_b, p, rung::certified);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    for (const std::size_t vertex : {0, 311, 599}) {
      mesh m = good;
      m.xyz[3 * vertex + 1] = bad;
      refused(moving, m.view(), {}, *p.a);
      refused(moving, m.view(), turned(), *p.a);
    }
  pose far;
  far.m[3] = 1e39;
  refused(moving, good.view(), far, *p.a);
  view null = good.view();
  null.data = nullptr;
  refused(moving, null, {}, *p.a);
  view shorter = good.view();
  shorter.stride_bytes = 8;
  refused(moving, shorter, {}, *p.a);
  view fewer = good.view();
  --fewer.elements;
  CHECK_THROWS_AS(moving.update(fewer), std::invalid_argument);
  fewer = good.view();
  --fewer.vertices;
  CHECK_THROWS_AS(moving.update(fewer), std::invalid_argument);
  pose wrong;
  wrong.grid = 3;
  CHECK_THROWS_AS(moving.update(good.view(), wrong), std::invalid_argument);
  CHECK((plain(collide(moving, set_b, p, rung::certified).pairs) == plain(before.pairs)));

  std::vector<float> balls = some_balls(100, 0.1F, 1);
  moving_set of_balls(rows(balls, *with_balls.a), *with_balls.a);
  const result hits = collide(of_balls, set_b, with_balls, rung::certified);
  std::vector<float> negative = balls;
  negative[4 * 71 + 3] = negative[4 * 30 + 3] = -1;
  refused(of_balls, rows(negative, *with_balls.a), {}, *with_balls.a);
  CHECK((plain(collide(of_balls, set_b, with_balls, rung::certified).pairs) == plain(hits.pairs)));

  mesh unused = good; // a vertex that no element has may be anything
  unused.xyz.insert(unused.xyz.end(), 3, 0);
  moving_set with_unused(unused.view(), *p.a);
  unused.xyz.back() = std::numeric_limits<float>::quiet_NaN();
  with_unused.update(unused.view());
  CHECK((plain(collide(with_unused, set_b, p, rung::certified).pairs) == plain(before.pairs)));
}

TEST_CASE("a moving set may be empty, and small, and goes where a prepared one does") {
  const predicate_info &p = predicate("triangle_triangle");
  moving_set none(view{}, *p.a);
  none.update(view{});
  CHECK(none.now().elements() == 0);
  CHECK(none.looseness() == 1);
  const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  moving_set one({.data = corners, .elements = 1}, *p.a);
  one.update({.data = corners, .elements = 1});
  CHECK(collide(one, one, p, rung::certified).count == 1);
  CHECK(collide(none, one, p, rung::certified).count == 0);
}

TEST_CASE("the looseness of points that lie on each other is a number") {
  const predicate_info &p = predicate("point_triangle");
  std::vector<float> rows(3 * 32);
  for (std::size_t i = 16; i < 32; ++i)
    rows[3 * i] = 1;
  moving_set moving({.data = rows.data(), .elements = 32}, *p.a);
  CHECK(moving.looseness() == 1);
  moving.update({.data = rows.data(), .elements = 32});
  CHECK(moving.looseness() == 1);
  for (std::size_t i = 0; i < 32; ++i)
    rows[3 * i + 1] = static_cast<float>(i);
  moving.update({.data = rows.data(), .elements = 32});
  CHECK(moving.looseness() > 1);
  const std::uint32_t index[32] = {};
  CHECK_THROWS_AS(moving.update({.data = rows.data(), .vertices = 1, .index = index, .elements = 32}), usage_error);
}
