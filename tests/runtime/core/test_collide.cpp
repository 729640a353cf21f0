// All touching pairs against brute force, on several numbers of threads.
#include "tests/catch.hpp"
#include "toy.hpp"

#include <thread>

using namespace meetc;
using namespace toy;

namespace {

constexpr float huge = 3e38f, tiny = 1e-45f, most = std::numeric_limits<float>::max();

void agree(const rows &a, const rows &b, const predicate_info &p) {
  const toy::truth want = brute(a, b, p);
  const prepared x = prepare(view_of(a, *p.a), *p.a, {}, 2), y = prepare(view_of(b, *p.b), *p.b, {}, 1);
  for (const int threads : {1, 2, 3, 8}) {
    collide_options o;
    o.threads = threads;
    const result r = collide(x, y, p, rung::fp32, o);
    CHECK(same(r.pairs, want.pairs));
    CHECK(r.count == want.pairs.size());
    CHECK(r.candidates == want.candidates);
    o.want = answer_kind::count;
    const result counted = collide(x, y, p, rung::fp32, o);
    CHECK(counted.count == want.pairs.size());
    CHECK(counted.pairs.empty());
    o.want = answer_kind::any;
    CHECK(collide(x, y, p, rung::fp32, o).count == !want.pairs.empty());
  }
}

rows join(rows a, const rows &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

} // namespace

TEST_CASE("random boxes, sparse to dense, many sizes") {
  for (const std::size_t n : {1u, 2u, 15u, 16u, 17u, 255u, 256u, 257u, 700u})
    for (const float size : {0.01f, 0.2f, 3.0f}) {
      CAPTURE(n, size);
      agree(some_boxes(n, 1, size, 1), some_boxes(400, 1, size, 2), box_box_hit);
    }
  agree(some_boxes(5000, 1, 0.03f, 3), some_boxes(900, 1, 0.03f, 4), box_box_hit);
}

TEST_CASE("balls, and balls against boxes") {
  agree(some_balls(900, 1, 0.1f, 5), some_balls(700, 1, 0.1f, 6), ball_ball_hit);
  agree(some_balls(900, 1, 0.1f, 5), some_boxes(500, 1, 0.1f, 7), ball_box_hit);
}

TEST_CASE("clusters far from each other, which one grid cannot tell apart") {
  rows a, b;
  for (const float at : {-1e30f, -1.0f, 0.0f, 1e-20f, 1.0f, 1e10f, 1e37f}) {
    const float range = std::max(std::abs(at), 1e-30f) * 1e-3f;
    a = join(a, some_boxes(150, range, range * 0.1f, 8, at));
    b = join(b, some_boxes(130, range, range * 0.1f, 9, at));
  }
  agree(a, b, box_box_hit);
}

TEST_CASE("a set against itself gives every ordered pair") {
  const rows a = some_boxes(600, 1, 0.1f, 10);
  agree(a, a, box_box_hit);
  const prepared x = prepare(view_of(a, boxes), boxes);
  const result r = collide(x, x, box_box_hit, rung::exact);
  const auto equal = [](index_pair p) { return p.a == p.b; };
  CHECK(std::count_if(r.pairs.begin(), r.pairs.end(), equal) == 600);
}

// More leaves than a walk keeps at once.
TEST_CASE("a set whose elements all touch each other") {
  constexpr std::size_t n = 4200;
  rows a = some_balls(n, 1, 1, 11);
  for (std::size_t i = 0; i < n; ++i)
    a[4 * i + 3] += 2;
  const prepared x = prepare(view_of(a, balls), balls), y = prepare(view_of(a, balls), balls);
  collide_options o;
  o.threads = 2;
  o.want = answer_kind::count;
  CHECK(collide(x, y, ball_ball_hit, rung::fp32, o).count == n * n);
  CHECK(collide(x, x, ball_ball_hit, rung::fp32, o).count == n * n);
}

// The half that is tested has to give all that two copies of the set give, in every kind of answer.
TEST_CASE("a set against itself, by a predicate that is symmetric, gives what two copies of it give") {
  predicate_info half = box_box_hit;
  half.symmetric = true;
  for (const std::size_t n : {std::size_t{1}, std::size_t{15}, std::size_t{16}, std::size_t{17}, std::size_t{600}})
    for (const float size : {0.05f, 0.6f}) {
      const rows a = some_boxes(n, 1, size, 11);
      const prepared x = prepare(view_of(a, boxes), boxes), copy = prepare(view_of(a, boxes), boxes);
      std::vector<std::uint32_t> owners(n), others(n);
      for (std::size_t i = 0; i < n; ++i)
        owners[i] = static_cast<std::uint32_t>(i / 3), others[i] = static_cast<std::uint32_t>(i / 5);
      for (const bool owned : {false, true})
        for (const answer_kind want :
             {answer_kind::pairs, answer_kind::count, answer_kind::flags, answer_kind::counts, answer_kind::any}) {
          collide_options o;
          o.want = want;
          if (owned)
            o.owner_a = owners, o.owner_b = others;
          const result one = collide(x, x, half, rung::exact, o), two = collide(x, copy, half, rung::exact, o);
          INFO(n << " boxes of " << size << (owned ? ", owned" : "") << ", answer " << static_cast<int>(want));
          CHECK(one.count == two.count);
          CHECK(same(one.pairs, two.pairs));
          CHECK((one.flags.a == two.flags.a && one.flags.b == two.flags.b));
          CHECK((one.counts.a == two.counts.a && one.counts.b == two.counts.b));
          CHECK((want == answer_kind::any || one.candidates == two.candidates));
        }
    }
}

TEST_CASE("empty sets and single elements") {
  agree({}, {}, box_box_hit);
  agree({}, some_boxes(40, 1, 1, 11), box_box_hit);
  agree(some_boxes(40, 1, 1, 11), {}, box_box_hit);
  agree({0, 0, 0, 1, 1, 1}, {1, 1, 1, 2, 2, 2}, box_box_hit);
  agree({0, 0, 0, 1, 1, 1}, {1.0000001f, 1, 1, 2, 2, 2}, box_box_hit);
  float lo[3], hi[3];
  prepare(view_of({}, boxes), boxes).bounds(lo, hi);
  CHECK(lo[0] > hi[0]);
  prepare(view_of({0, 1, 2, 3, 4, 5, -1, 2, 2, 2, 9, 3}, boxes), boxes).bounds(lo, hi);
  CHECK((lo[0] == -1 && lo[1] == 1 && lo[2] == 2 && hi[0] == 3 && hi[1] == 9 && hi[2] == 5));
}

TEST_CASE("degenerate sets: all equal, points on a lattice, signed zeros") {
  rows equal, points, zeros;
  std::mt19937 g(12);
  for (int i = 0; i < 300; ++i) {
    equal = join(equal, {1, 2, 3, 4, 5, 6});
    rows p;
    for (int k = 0; k < 3; ++k)
      p.push_back(static_cast<float>(g() % 4));
    points = join(points, join(p, p));
    rows z;
    for (int k = 0; k < 6; ++k)
      z.push_back(g() % 2 ? 0.0f : -0.0f);
    zeros = join(zeros, z);
  }
  agree(equal, equal, box_box_hit);
  agree(points, points, box_box_hit);
  agree(zeros, join(zeros, points), box_box_hit);
}

TEST_CASE("the whole range of float32") {
  rows large = some_boxes(300, huge / 2, huge / 4, 13), small, mixed;
  std::mt19937 g(14);
  for (int i = 0; i < 300; ++i) {
    rows s, m;
    for (int k = 0; k < 3; ++k) {
      s.push_back(static_cast<float>(g() % 40) * tiny);
      m.push_back(std::ldexp(g() % 2 ? 1.0f : -1.0f, static_cast<int>(g() % 277) - 149));
    }
    rows s1 = s, m1 = m;
    for (int k = 0; k < 3; ++k) {
      s1[static_cast<std::size_t>(k)] += static_cast<float>(g() % 8) * tiny;
      float &v = m1[static_cast<std::size_t>(k)];
      v = std::max(v, std::ldexp(1.0f, static_cast<int>(g() % 277) - 149));
    }
    small = join(small, join(s, s1));
    mixed = join(mixed, join(m, m1));
  }
  agree(large, large, box_box_hit);
  agree(small, small, box_box_hit);
  agree(mixed, join(small, large), box_box_hit);
  agree({-most, -most, -most, most, most, most}, join(mixed, small), box_box_hit);
}

TEST_CASE("balls whose boxes are infinite") {
  rows a = some_balls(200, huge / 2, huge, 15), b = some_balls(100, 1, 0.1f, 16);
  for (int i = 0; i < 20; ++i)
    b = join(b, {huge, -huge, huge, most});
  agree(a, b, ball_ball_hit);
  agree(b, join(a, b), ball_ball_hit);
}

namespace {
// A kind whose box is not a number where x is 7.
void odd_box(const float *r, float lo[3], float hi[3]) {
  for (int k = 0; k < 3; ++k)
    lo[k] = hi[k] = r[0] == 7.0f ? std::numeric_limits<float>::quiet_NaN() : r[k];
}
bool always(const float *, const float *) {
  return true;
}
constexpr kind_info odd{"odd", "x,y,z", 3, box_roles, 0, boxes_by<3, odd_box>, nullptr};
constexpr predicate_info odd_hit = plain("odd", "", odd, odd, decide<3, 3, always>);
} // namespace

TEST_CASE("a box that is not a number touches everything") {
  rows a, b;
  for (int i = 0; i < 400; ++i) {
    a = join(a, {static_cast<float>(i % 20), 0, static_cast<float>(i % 3)});
    b = join(b, {static_cast<float>(i % 31), 0, static_cast<float>(i % 5)});
  }
  agree(a, b, odd_hit);
}

TEST_CASE("where everything overlaps, the count needs no list") {
  const rows a = some_boxes(3000, 0, 1, 17);
  const prepared x = prepare(view_of(a, boxes), boxes);
  collide_options o;
  o.want = answer_kind::count;
  const result r = collide(x, x, box_box_hit, rung::fp32, o);
  CHECK(r.count == 9'000'000);
  CHECK(r.candidates == 9'000'000);
  o.want = answer_kind::any;
  CHECK(collide(x, x, box_box_hit, rung::fp32, o).candidates < 100'000);
}

TEST_CASE("collide refuses arguments that do not fit") {
  const prepared x = prepare(view_of(some_boxes(3, 1, 1, 18), boxes), boxes);
  const prepared y = prepare(view_of(some_balls(3, 1, 1, 18), balls), balls);
  CHECK_THROWS_AS(collide(x, y, box_box_hit, rung::fp32), std::invalid_argument);
  CHECK_THROWS_AS(collide(x, x, box_box_hit, rung::fp64), std::invalid_argument);
  const std::uint32_t owner[2] = {0, 0};
  collide_options o;
  o.owner_a = owner;
  CHECK_THROWS_AS(collide(x, x, box_box_hit, rung::fp32, o), std::invalid_argument);
}

TEST_CASE("prepare names the first bad element") {
  rows bad = some_balls(5000, 1, 1, 19);
  bad[4 * 4321 + 3] = -1;
  bad[4 * 4500] = std::numeric_limits<float>::infinity();
  try {
    prepare(view_of(bad, balls), balls);
    FAIL("not refused");
  } catch (const input_error &e) {
    CHECK(e.where.kind == fault_kind::rule);
    CHECK(e.where.element == 4321);
    CHECK(std::string(e.what()) == "element 4321: breaks the rule r >= 0");
  }
}

TEST_CASE("a prepared set can be moved, and used by several threads at once") {
  const rows a = some_boxes(500, 1, 0.2f, 20);
  prepared first = prepare(view_of(a, boxes), boxes);
  const prepared x = std::move(first);
  const std::size_t want = brute(a, a, box_box_hit).pairs.size();
  std::uint64_t got[4] = {};
  {
    std::vector<std::jthread> users;
    for (std::uint64_t &g : got)
      users.emplace_back([&] { g = collide(x, x, box_box_hit, rung::fp32, {.threads = 2}).count; });
  }
  for (const std::uint64_t g : got)
    CHECK(g == want);
}
