// Sets as they are given, which a query puts into order, and which are culled before; the other scenes have none.
#include "engine.hpp"

#include "meet/core/device/set/cull.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>

namespace cuda_test {
namespace {

using namespace meetc;

constexpr rung certified[] = {rung::certified};

// A mesh of n by n squares, each two triangles, over a square of this size at z = height with waves of this height.
struct sheet {
  std::vector<float> points;
  std::vector<std::uint32_t> index;
  view of() const { return {points.data(), points.size() / 3, 3 * sizeof(float), index.data(), index.size() / 3}; }
};
sheet waves(std::uint32_t n, float size, float at, float height, float of_waves) {
  sheet s;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t k = 0; k <= n; ++k) {
      const float x = at + size * static_cast<float>(i) / static_cast<float>(n),
                  y = size * static_cast<float>(k) / static_cast<float>(n);
      s.points.insert(s.points.end(), {x, y, height + of_waves * std::sin(5 * x) * std::cos(7 * y)});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t p = i * (n + 1) + k;
      s.index.insert(s.index.end(), {p, p + 1, p + n + 1, p + 1, p + n + 2, p + n + 1});
    }
  return s;
}

// The same elements, given and in order.
struct both_sets {
  device_set given, in_order;
  both_sets(device &on, const view &v, const kind_info &kind, const pose &at = {})
      : given(device_set::given(on, v, kind)), in_order(on, v, kind, at) {
    given.move(at);
  }
};

// Whatever the scene, the list of pairs is the one that two sets in order have, also where one of them is in order.
void same_as_ordered(comparison &with, const std::string &scene, const predicate_info &p, both_sets &a, both_sets &b,
                     bool some) {
  for (both_sets *const s : {&a, &b}) {
    float have[2][3], want[2][3];
    s->given.bounds(have[0], have[1]), s->in_order.bounds(want[0], want[1]);
    with.require(scene, std::memcmp(have, want, sizeof want) == 0, "another box around all elements");
  }
  for (const rung r : all_rungs) {
    const device_result want = collide(with.on(), a.in_order, b.in_order, p, r);
    for (const auto &[of_a, of_b, culled] :
         {std::tuple(&a.given, &b.given, false), std::tuple(&a.given, &b.given, true),
          std::tuple(&a.given, &b.in_order, false), std::tuple(&a.in_order, &b.given, true)}) {
      device_options o;
      o.cull = culled;
      const device_result have = collide(with.on(), *of_a, *of_b, p, r, o);
      with.add(scene, p, have);
      with.require(scene,
                   have.pairs.size() == want.pairs.size() &&
                       std::equal(have.pairs.begin(), have.pairs.end(), want.pairs.begin(),
                                  [](index_pair x, index_pair y) { return x.a == y.a && x.b == y.b; }),
                   std::string(p.name) + (culled ? ", culled: " : ": ") + "another list, by " + name_of(r));
      with.require(scene, (have.count > 0) == some, std::string(p.name) + ": nothing touches, or something does");
    }
  }
}

// Meshes that reach into each other, that lie far apart, and that share one plane; with indices and in a pose.
void meshes(comparison &with, const settings &s) {
  const predicate_info &p = predicate_named("triangle_triangle");
  const std::uint32_t n = s.small ? 20 : 300;
  const sheet x = waves(n, 1, 0, 0, 0.1F), y = waves(n + 7, 1, 0.3F, 0.02F, 0), far = waves(n, 1, 5, 0, 0.1F),
              above = waves(n, 1, 0, 0.5F, 0), flat = waves(n, 1, 0.5F, 0.02F, 0);
  both_sets a(with.on(), x.of(), *p.a), b(with.on(), y.of(), *p.b), c(with.on(), far.of(), *p.b),
      d(with.on(), above.of(), *p.b), e(with.on(), flat.of(), *p.b);
  same_as_ordered(with, "given, meshes that cross", p, a, b, true);
  same_as_ordered(with, "given, meshes that cross", p, b, a, true);
  same_as_ordered(with, "given, in disjoint boxes", p, a, c, false);
  same_as_ordered(with, "given, one above the other", p, a, d, false);
  same_as_ordered(with, "given, in one plane", p, b, e, true);
  pose near;
  near.m[3] = -4.5;
  both_sets moved(with.on(), far.of(), *p.b, near);
  same_as_ordered(with, "given, in a pose", p, b, moved, true);
  same_as_ordered(with, "given, with itself", p, a, a, true);
  with.require("given, culling", cull_pays(*a.given.as_given(), *b.given.as_given()) == !s.small,
               "culled where it does not pay");
}

// Segments of all lengths and directions, as lines that mark their cells; some leave the other's box, or touch only it.
void lines(comparison &with, const settings &s) {
  engine random(s.seed + 50);
  const predicate_info &p = predicate_named("segment_triangle"), &q = predicate_named("segment_segment"),
                       &r = predicate_named("ball_segment");
  const sheet x = waves(s.small ? 16 : 200, 1, 0, 0, 0.1F);
  std::uniform_real_distribution<float> unit(-0.2F, 1.2F);
  for (const float length : {0.001F, 0.1F, 1.0F, 100.0F, 1e30F}) {
    rows_of of{p.a, {}};
    for (std::size_t i = 0; i < (s.small ? 60U : 2000U); ++i) {
      const float from[3] = {unit(random), unit(random), 0.2F * unit(random)};
      float way[3] = {unit(random) - 0.5F, unit(random) - 0.5F, unit(random) - 0.5F};
      if (i % 4 == 0) // along an axis, or a point
        way[i / 4 % 3] = 0, way[i / 8 % 3] = 0, way[i / 16 % 3] = 0;
      for (const float v : from)
        of.rows.push_back(v);
      for (std::size_t k = 0; k < 3; ++k)
        of.rows.push_back(from[k] + length * way[k]);
    }
    both_sets segments(with.on(), view_of(of), *p.a), mesh(with.on(), x.of(), *p.b);
    same_as_ordered(with, "given, segments x mesh", p, segments, mesh, true);
    same_as_ordered(with, "given, segments", q, segments, segments, true);
    const rows_of balls = random_rows(*r.a, 300, {1, 0.05, 1, 0}, random);
    both_sets of_balls(with.on(), view_of(balls), *r.a);
    same_as_ordered(with, "given, balls x segments", r, of_balls, segments, true);
  }
}

// Elements of all sizes, up to the ends of float32, each of which marks few cells.
void sizes_of_elements(comparison &with, const settings &s) {
  engine random(s.seed + 51);
  each_predicate([&](const predicate_info &p) {
    const std::size_t n = s.small ? 80 : 1200;
    const auto mixed = [&](const kind_info &kind) {
      rows_of out{&kind, {}};
      for (const double size : {1e-6, 1e-3, 0.02, 0.3, 3.0, 1e6, 1e30}) {
        const rows_of some = random_rows(kind, n / 7, {1, size, 1, 0}, random);
        out.rows.insert(out.rows.end(), some.rows.begin(), some.rows.end());
      }
      put_in_order(out);
      return out;
    };
    const rows_of x = mixed(*p.a), y = mixed(*p.b);
    with.same("given, all sizes", p, prepare(view_of(x), *p.a), prepare(view_of(y), *p.b), certified);
    // Most points of a cloud lie in no marked cell.
    const rows_of one = random_rows(*p.a, 1, {1, 1e-3, 1, 0.5}, random),
                  many = random_rows(*p.b, n, {2, 0.05, 1, 0}, random);
    with.same("given, one x many", p, prepare(view_of(one), *p.a), prepare(view_of(many), *p.b), certified);
  });
}

// A number that no set may have is refused in the words in which a device_set refuses it, also where culling leaves it out.
void refused(comparison &with, const settings &) {
  engine random(1);
  each_predicate([&](const predicate_info &p) {
    rows_of x = random_rows(*p.a, 100, {1, 0.1, 1, 0}, random), y = random_rows(*p.b, 100, {1, 0.1, 1, 0}, random);
    y.rows[50 * static_cast<std::size_t>(p.b->fields)] = std::numeric_limits<float>::quiet_NaN();
    y.rows[70 * static_cast<std::size_t>(p.b->fields) + 1] = std::numeric_limits<float>::infinity();
    device_set a = device_set::given(with.on(), view_of(x), *p.a), b = device_set::given(with.on(), view_of(y), *p.b);
    for (const bool culled : {false, true}) {
      device_options o;
      o.cull = culled;
      std::string said;
      try {
        collide(with.on(), a, b, p, rung::certified, o);
      } catch (const input_error &e) {
        said = e.what();
      }
      with.require("given, refused", said == describe(check(view_of(y), *p.b), *p.b), said);
    }
  });
  const predicate_info &p = predicate_named("triangle_triangle");
  sheet x = waves(5, 1, 0, 0, 0);
  x.index[40] = 1000;
  device_set a = device_set::given(with.on(), x.of(), *p.a);
  bool thrown = false;
  try {
    collide(with.on(), a, a, p, rung::certified);
  } catch (const input_error &) {
    thrown = true;
  }
  with.require("given, refused", thrown, "an index beyond the points");
}

// Elements that lie in the device's memory, whose pairs stay there.
void stay_there(comparison &with, const settings &s) {
  engine random(s.seed + 52);
  const predicate_info &p = predicate_named("ball_ball");
  const rows_of x = random_rows(*p.a, 500, {1, 0.1, 1, 0}, random);
  device_memory<float> rows;
  rows.reserve(x.rows.size(), "a test");
  check(cudaMemcpy(rows.data(), x.rows.data(), x.rows.size() * sizeof(float), cudaMemcpyHostToDevice), "a test");
  device_set there = device_set::given(with.on(), cuda::view{rows.data(), 4 * sizeof(float), nullptr, 0, 500}, *p.a),
             here = device_set::given(with.on(), view_of(x), *p.a);
  const device_result want = collide(with.on(), here, here, p, rung::certified);
  pairs_there pairs;
  device_options o;
  o.leave_there = &pairs;
  for (const answer_kind other :
       {answer_kind::pairs, answer_kind::count}) { // what another query finds is no list of this one
    o.want = other;
    collide(with.on(), here, here, p, rung::certified, o);
  }
  with.require("given there", pairs.size() == 0, "a list where none was asked for");
  o.want = answer_kind::pairs;
  const device_result have = collide(with.on(), there, there, p, rung::certified, o);
  collide(with.on(), here, there, p, rung::certified); // the list outlives the next query
  std::vector<index_pair> down(pairs.size());
  check(cudaMemcpy(down.data(), pairs.data(), down.size() * sizeof(index_pair), cudaMemcpyDeviceToHost), "a test");
  with.require("given there",
               have.pairs.empty() && have.count == want.count && pairs.size() == want.pairs.size() &&
                   std::memcmp(down.data(), want.pairs.data(), down.size() * sizeof(index_pair)) == 0,
               "another list");
}

// Given sets that are asked again and again, and whose numbers of elements change.
void again_and_again(comparison &with, const settings &s) {
  engine random(s.seed + 53);
  for (const char *const name : {"ball_ball", "box_box", "triangle_triangle"}) {
    const predicate_info &p = predicate_named(name);
    for (const std::size_t n : {400U, 401U, 90U}) {
      const rows_of x = random_rows(*p.a, n, {1, 0.1, 1, 0}, random),
                    y = random_rows(*p.b, n / 2, {1, 0.1, 1, 0}, random);
      device_set a = device_set::given(with.on(), view_of(x), *p.a), b = device_set::given(with.on(), view_of(y), *p.b);
      const result want = collide(prepare(view_of(x), *p.a), prepare(view_of(y), *p.b), p, rung::certified);
      for (int times = 0; times < 5; ++times) {
        const device_result have = collide(with.on(), a, b, p, rung::certified);
        with.require("given, again and again", same_list(have.pairs, want.pairs), std::string(name) + ": another list");
      }
    }
  }
}

// Packed rows, and rows that are not, of so many balls.
void many_balls(comparison &with, std::size_t n, engine &random) {
  const predicate_info &q = predicate_named("ball_ball");
  rows_of balls = random_rows(*q.a, n, {1, 0.01, 1, 0}, random);
  const rows_of others = random_rows(*q.b, 3000, {1, 0.01, 1, 0}, random);
  const result want = collide(prepare(view_of(balls), *q.a), prepare(view_of(others), *q.b), q, rung::certified);
  device_set of_others = device_set::given(with.on(), view_of(others), *q.b);
  device_memory<float> rows;
  rows.reserve(5 * n + 4, "a test");
  const auto upload = [&](std::size_t first, std::size_t stride) {
    std::vector<float> spread(n * stride);
    for (std::size_t i = 0; i < n; ++i)
      std::copy_n(&balls.rows[4 * i], 4, &spread[stride * i]);
    check(cudaMemcpy(rows.data() + first, spread.data(), spread.size() * sizeof(float), cudaMemcpyHostToDevice),
          "a test");
    return cuda::view{rows.data() + first, stride * sizeof(float), nullptr, 0, static_cast<std::uint32_t>(n)};
  };
  for (const auto &[first, stride] : {std::pair<std::size_t, std::size_t>{0, 4}, {1, 4}, {0, 5}}) {
    device_set there = device_set::given(with.on(), upload(first, stride), *q.a);
    const device_result have = collide(with.on(), there, of_others, q, rung::certified);
    with.add("given, many balls", q, have);
    with.require("given, many balls", have.count > 0 && same_list(have.pairs, want.pairs), "another list");
  }
  balls.rows[4 * 123'457] = std::numeric_limits<float>::quiet_NaN(); // not among those that the box is made of
  device_set bad = device_set::given(with.on(), upload(0, 4), *q.a);
  std::string said;
  try {
    collide(with.on(), bad, of_others, q, rung::certified);
  } catch (const input_error &e) {
    said = e.what();
  }
  with.require("given, many balls", said == describe(check(view_of(balls), *q.a), *q.a), said);
}

// More elements than one kernel arranges, of which culling leaves nearly all; rows that are packed, in order or not aligned.
void large(comparison &with, const settings &s) {
  if (s.small)
    return;
  const predicate_info &p = predicate_named("triangle_triangle");
  const sheet x = waves(900, 1, 0, 0, 0.1F), y = waves(907, 1, 0, 2e-7F, 0.1F);
  device_set a = device_set::given(with.on(), x.of(), *p.a), b = device_set::given(with.on(), y.of(), *p.b);
  device_options o;
  o.cull = true;
  const device_result culled = collide(with.on(), a, b, p, rung::certified, o);
  o.cull = false;
  const device_result whole = collide(with.on(), a, b, p, rung::certified, o);
  const result here = collide(prepare(x.of(), *p.a), prepare(y.of(), *p.b), p, rung::certified);
  with.add("given, two large sheets", p, culled);
  with.require("given, two large sheets", culled.count > 0 && same_list(culled.pairs, here.pairs),
               "culled: another list");
  with.require("given, two large sheets", same_list(whole.pairs, here.pairs), "another list");

  engine random(s.seed + 54);
  for (const std::size_t n : {std::size_t{700'000}, std::size_t{1'050'000}}) // by one kernel, and by a sort
    many_balls(with, n, random);
}

} // namespace

void given_scenes(comparison &with, const settings &s) {
  meshes(with, s);
  lines(with, s);
  sizes_of_elements(with, s);
  refused(with, s);
  stay_there(with, s);
  again_and_again(with, s);
  large(with, s);
}

} // namespace cuda_test
