// Bodies that move without being prepared again, against sets that were prepared in each pose.
#include "tests/catch.hpp"
#include "tests/runtime/world/poses.hpp"

#include "meet/bodies/meshes.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meet/core/world/world.hpp"

#include <cga/cga_runtime.hpp>

#include <algorithm>
#include <limits>
#include <random>
#include <string>

using namespace meetc;
using world_test::drawn;

namespace {

const kind_info &kind_named(const char *name) {
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.kind_count; ++i)
    if (std::string_view(all.kinds[i].name) == name)
      return all.kinds[i];
  throw std::invalid_argument(name);
}

// A shape's numbers, of which views are taken.
struct numbers {
  const kind_info *kind;
  bodies::mesh mesh;       // of triangles
  std::vector<float> rows; // of other kinds
  view as_view() const {
    if (!rows.empty())
      return {rows.data(), 0, 0, nullptr, rows.size() / static_cast<std::size_t>(kind->fields)};
    return {mesh.xyz.data(), mesh.vertices(), 0, mesh.index.data(), mesh.triangles()};
  }
};

std::vector<numbers> some_shapes() {
  return {{&kind_named("triangle"), bodies::icosphere(3), {}},
          {&kind_named("triangle"), bodies::torus(40, 20), {}},
          {&kind_named("triangle"), bodies::block(4, 3, 2, 2), {}},
          {&kind_named("segment"), {}, bodies::segment_cloud(700, 3, 0.4)},
          {&kind_named("sphere"), {}, bodies::sphere_cloud(500, 4, 0.01, 0.1)}};
}

struct scene {
  std::vector<numbers> shapes = some_shapes();
  std::vector<std::size_t> shape_of; // of each body
  world bodies{cga::catalogue()};

  explicit scene(std::size_t n) {
    std::vector<std::shared_ptr<const prepared>> sets;
    for (const numbers &s : shapes)
      sets.push_back(std::make_shared<prepared>(prepare(s.as_view(), *s.kind)));
    for (std::size_t i = 0; i < n; ++i) {
      shape_of.push_back(i % shapes.size());
      bodies.add("body " + std::to_string(i), sets[shape_of.back()]);
    }
  }
  prepared in_place(std::uint32_t i) const {
    const numbers &s = shapes[shape_of[i]];
    return prepare(s.as_view(), *s.kind, bodies.at(i), 1);
  }
};

std::vector<std::pair<std::uint32_t, std::uint32_t>> as_pairs(const std::vector<index_pair> &list) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  for (const index_pair p : list)
    out.emplace_back(p.a, p.b);
  std::ranges::sort(out);
  return out;
}

// Compares with each pair of sets that were prepared in the poses. Returns the number of pairs of bodies that touch.
std::size_t compare(const scene &s, rung precision, const world_answer &have) {
  std::size_t at = 0;
  for (std::uint32_t a = 0; a < s.bodies.size(); ++a)
    for (std::uint32_t b = a + 1; b < s.bodies.size(); ++b) {
      const prepared x = s.in_place(a), y = s.in_place(b);
      const std::optional<choice> by = first_for(fitting(cga::catalogue(), x.kind(), y.kind()), "solid");
      REQUIRE(by);
      collide_options o;
      o.threads = 1;
      const result want =
          by->swapped ? collide(y, x, *by->predicate, precision, o) : collide(x, y, *by->predicate, precision, o);
      if (want.count == 0)
        continue;
      CAPTURE(a, b);
      REQUIRE(at < have.touching.size());
      const touching_bodies &t = have.touching[at++];
      REQUIRE((t.a == a && t.b == b));
      std::vector<index_pair> pairs = want.pairs;
      if (by->swapped)
        for (index_pair &p : pairs)
          std::swap(p.a, p.b);
      CHECK(as_pairs(t.found.pairs) == as_pairs(pairs));
      CHECK(t.found.count == want.count);
    }
  CHECK(at == have.touching.size());
  return at;
}

} // namespace

TEST_CASE("bodies answer as sets that were prepared in their poses") {
  scene s(15);
  std::mt19937 g(1);
  std::size_t touching = 0;
  for (int frame = 0; frame < 6; ++frame) {
    for (std::uint32_t i = 0; i < s.bodies.size(); ++i)
      s.bodies.move(i, drawn(g, frame < 3 ? 2.0 : 4.0));
    for (const rung precision : {rung::certified, rung::fp32}) {
      world_options o;
      o.want = answer_kind::pairs;
      o.precision = precision;
      o.threads = 2;
      const world_answer have = s.bodies.touching(o);
      touching += compare(s, precision, have);
      CHECK(have.near >= have.touching.size());
    }
  }
  CHECK(touching > 60);
}

TEST_CASE("bodies at the ends of float32, in steps of it and far away answer likewise") {
  for (const double scale : {0x1p-140, 0x1p-20, 0x1p20, 0x1p120}) {
    CAPTURE(scale);
    scene s(10);
    std::mt19937 g(2);
    for (std::uint32_t i = 0; i < s.bodies.size(); ++i) {
      pose p = drawn(g, 1.5);
      for (double &m : p.m)
        m *= scale;
      p.length_scale = scale;
      s.bodies.move(i, p);
    }
    world_options o;
    o.want = answer_kind::pairs;
    compare(s, rung::certified, s.bodies.touching(o));
    for (std::uint32_t i = 0; i < s.bodies.size(); ++i) { // a step of float32 is as long as a body
      pose p = drawn(g, 2);
      for (int k = 0; k < 3; ++k)
        p.m[4 * k + 3] += 0x1p24;
      s.bodies.move(i, p);
    }
    compare(s, rung::certified, s.bodies.touching(o));
  }
}

TEST_CASE("the answer is the same for any number of threads, and the first pair is the least") {
  scene s(40);
  std::mt19937 g(3);
  for (std::uint32_t i = 0; i < s.bodies.size(); ++i)
    s.bodies.move(i, drawn(g, 3));
  world_options o;
  o.want = answer_kind::pairs;
  o.threads = 1;
  const world_answer one = s.bodies.touching(o);
  REQUIRE(one.touching.size() > 20);
  for (const int threads : {2, 7}) {
    o.threads = threads;
    const world_answer more = s.bodies.touching(o);
    REQUIRE(more.touching.size() == one.touching.size());
    CHECK(more.candidates == one.candidates);
    for (std::size_t i = 0; i < one.touching.size(); ++i) {
      CHECK((more.touching[i].a == one.touching[i].a && more.touching[i].b == one.touching[i].b));
      CHECK(as_pairs(more.touching[i].found.pairs) == as_pairs(one.touching[i].found.pairs));
    }
    o.first = true;
    const world_answer first = s.bodies.touching(o);
    REQUIRE(first.touching.size() == 1);
    CHECK((first.touching[0].a == one.touching[0].a && first.touching[0].b == one.touching[0].b));
    o.first = false;
  }
}

TEST_CASE("only few elements of bodies that hardly touch are moved") {
  const bodies::mesh ball = bodies::icosphere(5);
  const kind_info &triangle = kind_named("triangle");
  const prepared body = prepare({ball.xyz.data(), ball.vertices(), 0, ball.index.data(), ball.triangles()}, triangle);
  const box corner{{0.95f, -1, -1}, {3, 1, 1}};
  const prepared cap = posed(body, {}, {&corner, 1});
  CHECK(cap.elements() == ball.triangles());
  CHECK(!cap.whole());
  CHECK(cap.set().elements > 100);
  CHECK(cap.set().elements < ball.triangles() / 8);
  CHECK(posed(body, {}, {}).set().elements == 0);
  CHECK_THROWS_AS(posed(cap, {}, {&corner, 1}), std::invalid_argument);
}

TEST_CASE("bodies that are ignored are not asked about") {
  scene s(2);
  CHECK(s.bodies.touching().touching.size() == 1);
  s.bodies.ignore(1, 0);
  CHECK(s.bodies.touching().touching.empty());
  CHECK(s.bodies.touching().near == 0);
  s.bodies.ignore(0, 1, false);
  CHECK(s.bodies.touching().touching.size() == 1);
  CHECK_THROWS_AS(s.bodies.ignore(0, 2), std::out_of_range);
  CHECK(s.bodies.find("body 1") == 1);
  CHECK(!s.bodies.find("body"));
}

TEST_CASE("the pairs of some bodies and the others are among all pairs") {
  scene s(20);
  std::mt19937 g(4);
  for (std::uint32_t i = 0; i < s.bodies.size(); ++i)
    s.bodies.move(i, drawn(g, 2));
  const world_answer all = s.bodies.touching();
  const std::uint32_t some[] = {3, 8, 9};
  const auto is_some = [&](std::uint32_t b) { return std::ranges::find(some, b) != std::end(some); };
  world_options o;
  o.of = some;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> want, have;
  for (const touching_bodies &t : all.touching)
    if (is_some(t.a) != is_some(t.b))
      want.emplace_back(t.a, t.b);
  for (const touching_bodies &t : s.bodies.touching(o).touching)
    have.emplace_back(t.a, t.b);
  CHECK(have == want);
  CHECK(!want.empty());
  CHECK(want.size() < all.touching.size());
  const std::uint32_t none[] = {20};
  o.of = none;
  CHECK_THROWS_AS(s.bodies.touching(o), std::out_of_range);
}

TEST_CASE("a body that cannot be is refused with its name") {
  scene s(1);
  const auto shape = std::make_shared<prepared>(prepare(s.shapes[0].as_view(), *s.shapes[0].kind));
  CHECK_THROWS_WITH(s.bodies.add("body 0", shape), "body body 0: the name is taken");
  CHECK_THROWS_AS(s.bodies.add("", shape), std::invalid_argument);
  CHECK_THROWS_AS(s.bodies.add("owned", shape, {}, {1, 2}), std::invalid_argument);
  CHECK_THROWS_AS(s.bodies.add("none", nullptr), std::invalid_argument);
  pose far;
  far.m[3] = 1e39;
  const std::uint32_t gone = s.bodies.add("gone", shape, far);
  CHECK_THROWS_WITH(s.bodies.touching(), Catch::Contains("body gone, element 0: "));
  far.m[3] = std::numeric_limits<double>::quiet_NaN();
  s.bodies.move(gone, far);
  CHECK_THROWS_AS(s.bodies.touching(), input_error);
  far.m[3] = 0;
  far.grid = 3;
  CHECK_THROWS_AS(s.bodies.move(gone, far), std::invalid_argument);
}
