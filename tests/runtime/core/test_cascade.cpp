// `certified`: each rung sees only what the one before left unsure, for any number of threads. The scene's box.
#include "tests/catch.hpp"
#include "toy.hpp"

#include <atomic>

using namespace meetc;
using namespace toy;

namespace {

// The rung of the cascade, 0 to 3, that decides a pair of boxes, which depends only on their numbers. `every` >= 0: the
// same for all pairs.
int every = -1;
int hardness(const float *a, const float *b) {
  std::uint32_t hash = 1;
  for (int k = 0; k < 6; ++k)
    for (const float v : {a[k], b[k]}) {
      std::uint32_t bits;
      std::memcpy(&bits, &v, sizeof bits);
      hash = (hash ^ bits) * 0x9e3779b1u;
      hash ^= hash >> 15;
    }
  return every >= 0 ? every : static_cast<int>(hash % 4);
}

// The pairs that each rung was asked for, and those that an earlier rung would have decided.
std::atomic<std::uint64_t> asked[4], too_easy;
std::atomic<float> side_used;

template <int Rung> void certify_boxes(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  asked[Rung] += n;
  for (std::size_t i = 0; i < n; ++i) {
    const float *x = a.rows + std::size_t{6} * pairs[i].a, *y = b.rows + std::size_t{6} * pairs[i].b;
    const int needs = hardness(x, y);
    too_easy += needs < Rung;
    out[i] = needs > Rung ? answer::unsure : to_answer(boxes_hit(x, y));
  }
}
void certify_in_side(float side, row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  side_used = side;
  certify_boxes<0>(a, b, pairs, n, out);
}

constexpr predicate_info hard_boxes{"hard",
                                    "",
                                    &boxes,
                                    &boxes,
                                    {decide<6, 6, boxes_hit>, nullptr, nullptr, certify_boxes<3>, nullptr},
                                    {certify_boxes<0>, certify_boxes<1>, certify_boxes<2>},
                                    certify_in_side,
                                    0x1p-10f,
                                    0x1p10f};

void forget() {
  for (auto &n : asked)
    n = 0;
  too_easy = 0;
  side_used = 0;
}

// The candidates that each rung must leave unsure.
std::array<std::uint64_t, 3> handed_on(const rows &a, const rows &b) {
  std::array<std::uint64_t, 3> n{};
  for (std::size_t i = 0; i < a.size(); i += 6)
    for (std::size_t j = 0; j < b.size(); j += 6)
      for (std::size_t r = 0; r < 3; ++r)
        n[r] += boxes_hit(&a[i], &b[j]) && hardness(&a[i], &b[j]) > static_cast<int>(r);
  return n;
}

void agree(const rows &a, const rows &b) {
  const toy::truth truth = brute(a, b, hard_boxes);
  const auto unsure = handed_on(a, b);
  const prepared x = prepare(view_of(a, boxes), boxes), y = prepare(view_of(b, boxes), boxes);
  for (const int threads : {1, 2, 3, 8})
    for (const answer_kind want : {answer_kind::pairs, answer_kind::count}) {
      forget();
      const result r = collide(x, y, hard_boxes, rung::certified, {.want = want, .threads = threads});
      if (want == answer_kind::pairs)
        CHECK(same(r.pairs, truth.pairs));
      CHECK(r.count == truth.pairs.size());
      CHECK(r.candidates == truth.candidates);
      CHECK(std::equal(unsure.begin(), unsure.end(), r.rungs.unsure));
      CHECK(asked[0] == truth.candidates);
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(asked[k + 1] == unsure[k]);
      CHECK(too_easy == 0);
    }
}

rows unit(float low, float high) {
  return {low, -1, -1, high, 1, 1};
}

} // namespace

TEST_CASE("each rung sees what the one before left unsure, and all pairs are answered") {
  const rows a = some_boxes(700, 1, 0.3f, 90), b = some_boxes(900, 1, 0.3f, 91);
  for (every = -1; every <= 3; ++every)
    agree(a, b);
  every = -1;
  agree(a, a);
  agree({}, b);
  const rows dense = some_boxes(300, 0, 1, 92); // batches that are full
  agree(dense, dense);
}

TEST_CASE("owners and the caller's memory get the same") {
  const rows a = some_boxes(600, 1, 0.3f, 93), b = some_boxes(500, 1, 0.3f, 94);
  const auto want = brute(a, b, hard_boxes).pairs;
  const auto unsure = handed_on(a, b);
  for (const int threads : {1, 4}) {
    std::vector<std::byte> work(workspace(hard_boxes, 600, 500, threads));
    std::vector<index_pair> out(want.size());
    std::uint64_t count = 0;
    rung_report rungs;
    REQUIRE(pairs(hard_boxes, rung::certified, view_of(a, boxes), {}, view_of(b, boxes), {},
                  {out.data(), out.size(), &count, &rungs}, {work.data(), work.size()},
                  {.threads = threads}) == status::ok);
    CHECK(same(out, want));
    CHECK(std::equal(unsure.begin(), unsure.end(), rungs.unsure));
    // A refused call leaves nothing from an earlier one.
    CHECK(pairs(hard_boxes, rung::fp64, view_of(a, boxes), {}, view_of(b, boxes), {}, {nullptr, 0, &count, &rungs},
                {work.data(), work.size()}) == status::no_such_rung);
    CHECK(rungs.unsure[0] == 0);
  }
  std::vector<std::uint32_t> items(600);
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i] = static_cast<std::uint32_t>(i / 7);
  collide_options o;
  o.owner_a = items;
  const prepared x = prepare(view_of(a, boxes), boxes), y = prepare(view_of(b, boxes), boxes);
  const result certified = collide(x, y, hard_boxes, rung::certified, o),
               plain = collide(x, y, hard_boxes, rung::fp32, o);
  CHECK(same(certified.pairs, plain.pairs));
  CHECK(plain.rungs.unsure[0] == 0);
}

TEST_CASE("a search for one pair goes no deeper than it must") {
  const rows a = some_boxes(500, 0, 1, 95);
  const prepared x = prepare(view_of(a, boxes), boxes);
  const collide_options any{.want = answer_kind::any, .threads = 1};
  forget();
  CHECK(collide(x, x, hard_boxes, rung::certified, any).count == 1);
  CHECK(asked[0] > 0);
  CHECK(asked[1] == 0); // the first batch holds pairs that fp32 is sure of
  every = 2;
  forget();
  const result r = collide(x, x, hard_boxes, rung::certified, any);
  CHECK(r.count == 1);
  CHECK(asked[2] > 0);
  CHECK(asked[2] == asked[1]);
  CHECK(asked[3] == 0);
  CHECK(r.rungs.unsure[1] == asked[2]);
  CHECK(r.rungs.unsure[2] == 0);
  every = -1;
}

TEST_CASE("a cascade that lacks a rung is refused") {
  const rows a = some_boxes(5, 1, 1, 96);
  const prepared x = prepare(view_of(a, boxes), boxes);
  std::vector<std::byte> work(workspace(hard_boxes, 5, 5, 1));
  std::uint64_t count = 9;
  const auto refused = [&](const predicate_info &p) {
    CHECK_THROWS_AS(collide(x, x, p, rung::certified), std::invalid_argument);
    CHECK(pairs(p, rung::certified, view_of(a, boxes), {}, view_of(a, boxes), {}, {nullptr, 0, &count},
                {work.data(), work.size()}, {.threads = 1}) == status::no_such_rung);
  };
  refused(box_box_hit);
  for (int i = 0; i < 3; ++i) {
    predicate_info p = hard_boxes;
    p.certify[i] = nullptr;
    refused(p);
  }
  predicate_info p = hard_boxes;
  p.decide[static_cast<int>(rung::exact)] = nullptr;
  refused(p);
}

namespace {

struct entered {
  float side;
  bool a, b;
  friend bool operator==(const entered &, const entered &) = default;
};
std::ostream &operator<<(std::ostream &out, const entered &e) {
  return out << "{side " << e.side << ", " << e.a << ", " << e.b << "}";
}

// By both layers, which must agree.
entered enter(float box, const rows &a, const rows &b, const predicate_info &p = hard_boxes, const pose &at_b = {},
              rung precision = rung::certified) {
  forget();
  const result r =
      collide(prepare(view_of(a, *p.a), *p.a), prepare(view_of(b, *p.b), *p.b, at_b), p, precision, {.box = box});
  const entered one{side_used, r.rungs.left_box_a, r.rungs.left_box_b};
  forget();
  std::vector<std::byte> work(workspace(p, a.size(), b.size()));
  std::uint64_t count = 0;
  rung_report rungs;
  REQUIRE(pairs(p, precision, view_of(a, *p.a), {}, view_of(b, *p.b), at_b, {nullptr, 0, &count, &rungs},
                {work.data(), work.size()}, {.box = box}) == status::ok);
  CHECK(count == r.count);
  CHECK(entered{side_used, rungs.left_box_a, rungs.left_box_b} == one);
  return one;
}

} // namespace

TEST_CASE("the first rung takes the scene's box where both sets lie in it") {
  const rows in = unit(-1, 1), out = unit(-1, 1.0000001f), below = unit(-1.0000001f, 1);
  CHECK(enter(0, in, in) == entered{0, false, false});
  CHECK(enter(1, in, in) == entered{2, false, false});
  CHECK(enter(1.5f, in, in) == entered{4, false, false}); // the least power of two from 2 box on
  CHECK(enter(0.99999994f, in, in) == entered{0, true, true});
  CHECK(enter(1, in, out) == entered{0, false, true});
  CHECK(enter(1, below, in) == entered{0, true, false});
  CHECK(enter(1, in, {}) == entered{0, false, false}); // nothing to decide
  // As it stands after the pose.
  pose away;
  away.m[3] = 0.5;
  CHECK(enter(1, in, in, hard_boxes, away) == entered{0, false, true});
  CHECK(enter(2, in, in, hard_boxes, away) == entered{4, false, false});
  // A box that the bounds do not cover: no set has left it.
  CHECK(enter(0x1p9f, in, in) == entered{0x1p10f, false, false});
  CHECK(enter(0x1.000002p9f, in, in) == entered{0, false, false});
  CHECK(enter(std::numeric_limits<float>::infinity(), in, in) == entered{0, false, false});
  const rows zero(6, 0.0f);
  CHECK(enter(0x1p-11f, zero, zero) == entered{0x1p-10f, false, false});
  CHECK(enter(0x1p-12f, zero, zero) == entered{0, false, false});
  CHECK(enter(1e-45f, zero, zero) == entered{0, false, false});
  // Only `certified` uses it.
  CHECK(enter(1, out, out, hard_boxes, {}, rung::fp32) == entered{0, false, false});
  predicate_info none = hard_boxes;
  none.certify_in_box = nullptr;
  CHECK(enter(1, in, in, none) == entered{0, false, false});
}

TEST_CASE("no element is overlooked, and lengths may be twice the box") {
  for (const std::size_t at : {0u, 17u, 2047u, 2048u, 4999u}) {
    rows many = some_boxes(5000, 0.5f, 0.1f, 97), few = unit(-1, 1);
    CHECK(enter(1, many, few) == entered{2, false, false});
    many[6 * at + 1] = -1.0000001f;
    CHECK(enter(1, many, few) == entered{0, true, false});
  }
  predicate_info p = ball_ball_hit;
  p.decide[static_cast<int>(rung::exact)] = p.certify[0] = p.certify[1] = p.certify[2] = p.decide[0];
  p.certify_in_box = [](float side, row_array a, row_array b, const index_pair *list, std::size_t n, answer *said) {
    side_used = side;
    ball_ball_hit.decide[0](a, b, list, n, said);
  };
  p.box_most = 8;
  CHECK(enter(1, {1, 0, 0, 2}, {0, -1, 0, 0}, p) == entered{2, false, false});
  CHECK(enter(1, {1, 0, 0, 2.0000002f}, {0, -1, 0, 0}, p) == entered{0, true, false});
  CHECK(enter(1, {1, 0, 0, 2}, {0, -1.0000001f, 0, 0}, p) == entered{0, false, true});
  // A number that is neither a coordinate nor a length is in no box.
  static constexpr role odd_roles[6] = {role::x, role::y, role::z, role::other, role::x, role::y};
  kind_info odd = boxes;
  odd.roles = odd_roles;
  predicate_info q = hard_boxes;
  q.a = &odd;
  CHECK(enter(100, unit(-1, 1), unit(-1, 1), q) == entered{0, true, false});
}

TEST_CASE("a box that is not one is refused") {
  const rows a = unit(-1, 1);
  const prepared x = prepare(view_of(a, boxes), boxes);
  std::vector<std::byte> work(workspace(hard_boxes, 1, 1));
  for (const float box : {-1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    std::uint64_t count = 9;
    CHECK_THROWS_AS(collide(x, x, hard_boxes, rung::certified, {.box = box}), std::invalid_argument);
    CHECK(pairs(hard_boxes, rung::certified, view_of(a, boxes), {}, view_of(a, boxes), {}, {nullptr, 0, &count},
                {work.data(), work.size()}, {.box = box}) == status::bad_argument);
    CHECK(count == 0);
  }
}
