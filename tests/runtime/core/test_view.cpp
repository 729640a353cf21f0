// Views, poses and the messages of check() for bad input.
#include "tests/catch.hpp"
#include "toy.hpp"

#include "meet/core/views/rows.hpp"

#include <cstring>
#include <vector>

using namespace meetc;
using namespace toy;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

rows gathered(const view &v, const kind_info &kind, const pose &at = {}) {
  rows out(v.elements * static_cast<std::size_t>(kind.fields));
  REQUIRE(gather(v, kind, at, 0, v.elements, out.data()) == status::ok);
  return out;
}

bool same_bits(const rows &x, const rows &y) {
  return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(float)) == 0);
}

// The arithmetic of a pose in volatile steps, which no compiler may fuse.
float moved(const double *m, float x, float y, float z) {
  volatile double a = m[0] * static_cast<double>(x);
  volatile double b = m[1] * static_cast<double>(y);
  volatile double c = m[2] * static_cast<double>(z);
  volatile double ab = a + b;
  volatile double abc = ab + c;
  volatile double all = abc + m[3];
  return static_cast<float>(all);
}

} // namespace

TEST_CASE("the identity passes every bit through") {
  const rows r = {-0.0f, 0.0f, 1e-45f, -1e-45f, 3e38f, 1e-39f, 0.1f, 0.2f, 0.3f, 1, 2, 3};
  CHECK(same_bits(gathered(view_of(r, boxes), rods), r));
  CHECK(pose{}.identity());
  for (int i = 0; i < 12; ++i) {
    pose p;
    p.m[i] += 1e-16 + (i % 5 == 0 && i < 11 ? 1e-15 : 0);
    CHECK(!p.identity());
  }
  pose p;
  p.length_scale = 2;
  CHECK(!p.identity());
}

TEST_CASE("a pose is applied in fp64 in its order, without fma, and rounded once") {
  std::mt19937 g(50);
  for (int i = 0; i < 2000; ++i) {
    pose p;
    for (double &m : p.m)
      m = std::ldexp(static_cast<double>(g()) - 2147483648.0, static_cast<int>(g() % 40) - 50) / 3;
    p.length_scale = static_cast<double>(g() % 1000) / 7;
    rows r;
    for (int k = 0; k < 3; ++k)
      r.push_back(std::ldexp(uniform(g, -1, 1), static_cast<int>(g() % 20) - 10));
    r.push_back(uniform(g, 0, 1));
    const rows got = gathered(view_of(r, balls), balls, p);
    for (std::size_t k = 0; k < 3; ++k) {
      const double *m = p.m + 4 * k;
      CHECK(got[k] == moved(m, r[0], r[1], r[2]));
      const long double wide = static_cast<long double>(m[0]) * r[0] + static_cast<long double>(m[1]) * r[1] +
                               static_cast<long double>(m[2]) * r[2] + m[3];
      const long double size = std::abs(m[0] * r[0]) + std::abs(m[1] * r[1]) + std::abs(m[2] * r[2]) + std::abs(m[3]);
      CHECK(std::abs(static_cast<long double>(got[k]) - wide) <= 0x1p-24L * std::abs(wide) + 0x1p-50L * size);
    }
    CHECK(got[3] == static_cast<float>(static_cast<double>(r[3]) * p.length_scale));
  }
  // Cancellation makes an fma, or another order, visible in float32.
  pose p;
  p.m[0] = 0.1;
  p.m[1] = -0.3;
  CHECK(gathered(view_of({3, 1, 0, 1}, balls), balls, p)[0] == static_cast<float>(0.1 * 3 - 0.3));
  CHECK(gathered(view_of({3, 1, 0, 1}, balls), balls, p)[0] == 0x1p-54f);
  p.m[0] = 1e17;
  p.m[1] = 1;
  p.m[2] = -1e17;
  CHECK(gathered(view_of({1, 1, 1, 1}, balls), balls, p)[0] == 0);
}

TEST_CASE("points without z move in their plane, and kinds that cannot be moved are refused") {
  static constexpr role flat_roles[4] = {role::x, role::y, role::x, role::y};
  static constexpr kind_info flat{"flat", "x0,y0,x1,y1", 4, flat_roles, 0, nullptr, nullptr};
  pose p;
  p.m[3] = 10;
  p.m[6] = 1e30; // times z, which is none
  p.m[7] = -1;
  CHECK(can_move(flat));
  CHECK(gathered(view_of({1, 2, 3, 4}, flat), flat, p) == rows{11, 1, 13, 3});

  static constexpr role odd_roles[4] = {role::x, role::y, role::z, role::other};
  static constexpr kind_info odd{"odd", "x,y,z,w", 4, odd_roles, 0, boxes_by<4, ball_box>, nullptr};
  static constexpr role torn_roles[3] = {role::y, role::x, role::z};
  static constexpr kind_info torn{"torn", "y,x,z", 3, torn_roles, 0, boxes_by<3, ball_box>, nullptr};
  CHECK(!can_move(odd));
  CHECK(!can_move(torn));
  CHECK_NOTHROW(prepare(view_of({1, 2, 3, 4}, odd), odd));
  CHECK_THROWS_AS(prepare(view_of({1, 2, 3, 4}, odd), odd, p), std::invalid_argument);
}

TEST_CASE("strides, also odd ones, and indices") {
  const rows points = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<char> bytes(3 * 13);
  for (std::size_t i = 0; i < 3; ++i)
    std::memcpy(&bytes[13 * i], &points[3 * i], 12);
  const std::uint32_t index[] = {2, 0, 1, 1};
  void *at = bytes.data();
  const view v{static_cast<const float *>(at), 3, 13, index, 2};
  CHECK(gathered(v, rods) == rows{6, 7, 8, 0, 1, 2, 3, 4, 5, 3, 4, 5});
}

TEST_CASE("a stride of 0 means packed") {
  const rows r = some_balls(200, 1, 0.2F, 52), points = some_balls(30, 1, 1, 53); // 40 points
  std::vector<std::uint32_t> index;
  for (std::uint32_t i = 0; i < 80; ++i)
    index.push_back(i * 7 % 40);
  view packed = view_of(r, balls), stated = packed;
  packed.stride_bytes = 0;
  const view packed_points{points.data(), 40, 0, index.data(), 40},
      stated_points{points.data(), 40, 12, index.data(), 40};
  CHECK(gathered(packed, balls) == gathered(stated, balls));
  CHECK(gathered(packed_points, rods) == gathered(stated_points, rods));
  const prepared x = prepare(packed, balls), y = prepare({.data = r.data(), .elements = 200}, balls),
                 z = prepare(stated, balls);
  const result want = collide(z, z, ball_ball_hit, rung::fp32);
  CHECK(want.count > 200);
  CHECK(same(collide(x, x, ball_ball_hit, rung::fp32).pairs, want.pairs));
  CHECK(same(collide(y, y, ball_ball_hit, rung::fp32).pairs, want.pairs));
  pose moved;
  moved.m[3] = 1;
  CHECK(same_bits(gathered(packed, balls, moved), gathered(stated, balls, moved)));
}

TEST_CASE("a view that cannot hold its elements is named, and none of it is read") {
  const rows r = some_balls(100, 1, 1, 54);
  const std::vector<std::uint32_t> index(40, 2);
  struct bad_view {
    view of;
    const kind_info &kind;
    const char *said;
  };
  const view whole = view_of(r, balls);
  std::vector<bad_view> bad;
  for (const std::size_t stride : {1u, 4u, 12u, 15u})
    bad.push_back({{r.data(), 0, stride, nullptr, 10}, balls, "the stride is shorter than a row"});
  for (const std::size_t stride : {1u, 4u, 11u})
    bad.push_back({{r.data(), 10, stride, index.data(), 10}, rods, "the stride is shorter than a point"});
  bad.push_back({{r.data(), 0, 4, nullptr, 1}, balls, "the stride is shorter than a row"});
  bad.push_back({{nullptr, 0, 16, nullptr, 10}, balls, "the data is null"});
  bad.push_back({{nullptr, 10, 12, index.data(), 10}, rods, "the data is null"});
  bad.push_back({{r.data(), 100, 16, index.data(), 10}, balls, "elements of this kind have no index"});
  for (const bad_view &b : bad) {
    INFO(b.said << ", stride " << b.of.stride_bytes);
    const fault f = check(b.of, b.kind);
    CHECK(f.kind == fault_kind::view);
    CHECK(describe(f, b.kind) == b.said);
    for (const int threads : {1, 2})
      CHECK_THROWS_AS(prepare(b.of, b.kind, {}, threads), input_error);
    const predicate_info &by = &b.kind == &balls ? ball_ball_hit : rod_rod_hit;
    std::vector<std::byte> work(workspace(by, 100, 100, 1));
    std::uint64_t count = 7;
    pairs_out out;
    out.count = &count;
    const view other = &b.kind == &balls ? whole : view{r.data(), 10, 12, index.data(), 10};
    for (const auto &[x, y] : {std::pair(b.of, other), std::pair(other, b.of)})
      CHECK(pairs(by, rung::fp32, x, {}, y, {}, out, {work.data(), work.size()}, {.threads = 1}) == status::bad_view);
    CHECK(count == 0);
  }
  // Where nothing is read, nothing is wrong; an index that lies beyond no vertices is said to.
  CHECK(!check({nullptr, 0, 0, nullptr, 0}, balls));
  CHECK(!check({nullptr, 0, 4, nullptr, 0}, balls));
  CHECK(prepare({}, balls).elements() == 0);
  CHECK(check({nullptr, 0, 0, index.data(), 10}, rods).kind == fault_kind::index);
}

TEST_CASE("the first bad index is named") {
  const rows points(30);
  std::vector<std::uint32_t> index(2000, 9);
  const view v{points.data(), 10, 12, index.data(), 1000};
  CHECK(!check(v, rods));
  index[1501] = 10;
  index[1600] = 0xffffffff;
  const fault f = check(v, rods);
  CHECK(f.kind == fault_kind::index);
  CHECK((f.element == 750 && f.field == 1 && f.index == 10));
  CHECK(describe(f, rods) == "element 750: index 10 of point 1 lies beyond the vertices");
  CHECK_THROWS_AS(prepare(v, rods), input_error);
}

TEST_CASE("values that are not finite are named, as stored or as the pose made them") {
  rows r = some_balls(100, 1, 1, 51);
  r[4 * 70 + 2] = inf;
  r[4 * 90 + 1] = -inf;
  fault f = check(view_of(r, balls), balls);
  CHECK((f.kind == fault_kind::value && f.element == 70 && f.field == 2 && f.value == inf));
  CHECK(describe(f, balls) == "element 70: z is inf");

  pose turn; // takes z to x: the stored field is named all the same
  turn.m[0] = 0, turn.m[2] = 1;
  f = check(view_of(r, balls), balls, turn);
  CHECK((f.kind == fault_kind::value && f.element == 70 && f.field == 2));

  r[4 * 33 + 3] = std::numeric_limits<float>::quiet_NaN();
  f = check(view_of(r, balls), balls);
  CHECK((f.kind == fault_kind::value && f.element == 33 && f.field == 3 && std::isnan(f.value)));
  CHECK(describe(f, balls) == "element 33: r is nan");

  pose grow;
  grow.m[0] = 1e39;
  f = check(view_of({1, 2, 3, 4}, balls), balls, grow);
  CHECK((f.kind == fault_kind::moved && f.element == 0 && f.field == 0 && f.value == inf));
  CHECK(describe(f, balls) == "element 0: x becomes inf under the pose");
  CHECK(describe({}, balls) == "no fault");
}
