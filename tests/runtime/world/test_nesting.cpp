// Bodies inside one another: solids of cells against the count of cells, the rows of a truth table, open and turned meshes,
// poses, the ends of float32.
#include "tests/catch.hpp"
#include "tests/runtime/world/cells.hpp"
#include "tests/runtime/world/poses.hpp"

#include "meet/bodies/meshes.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meet/core/sets/topology.hpp"
#include "meet/core/world/world.hpp"

#include <cga/cga_runtime.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

using namespace meetc;
using namespace world_test;

namespace {

const kind_info &triangle() {
  return *find_predicate(cga::catalogue(), "triangle_triangle").a;
}
std::shared_ptr<const prepared> shape_of(const view &v, const kind_info &kind = triangle(), const pose &at = {}) {
  return std::make_shared<prepared>(prepare(v, kind, at, 1));
}
view view_of(const bodies::mesh &m) {
  return {m.xyz.data(), m.vertices(), 0, m.index.data(), m.triangles()};
}
world_options nested_options(int threads = 1) {
  world_options o;
  o.nested = true;
  o.threads = threads;
  return o;
}

const char *name_of(nesting how) {
  constexpr const char *names[] = {"a inside b", "b inside a", "overlapping", "unknown"};
  return names[static_cast<int>(how)];
}

struct told {
  std::string relation, why;
};
told relation_in(const std::shared_ptr<const prepared> &a, const std::shared_ptr<const prepared> &b,
                 const pose &at_a = {}, const pose &at_b = {}) {
  world w(cga::catalogue());
  w.add("a", a, at_a);
  w.add("b", b, at_b);
  const world_answer found = w.touching(nested_options());
  if (!found.touching.empty())
    return {found.nested.empty() ? "touching" : "touching and nested", ""};
  if (found.nested.empty())
    return {"apart", ""};
  REQUIRE(found.nested.size() == 1);
  CHECK((found.nested[0].a == 0 && found.nested[0].b == 1));
  return {name_of(found.nested[0].how), found.nested[0].why};
}
told relation_in(const triangles &a, const triangles &b) {
  return relation_in(shape_of(a.view()), shape_of(b.view()));
}

// The least element with an edge that others do not balance, by a table of all edges.
std::string open_at(const triangles &t) {
  using end = std::array<float, 3>;
  std::map<std::pair<end, end>, int> ways;
  const auto edge = [&](std::size_t i, std::size_t k) {
    const auto corner = [&](std::size_t c) {
      const float *const p = t.rows.data() + 9 * i + 3 * (c % 3);
      return end{p[0], p[1], p[2]};
    };
    return std::pair(corner(k), corner(k + 1));
  };
  const std::size_t n = t.rows.size() / 9;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      ++ways[edge(i, k)], --ways[{edge(i, k).second, edge(i, k).first}];
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (ways[edge(i, k)] != 0)
        return "element " + std::to_string(i);
  return "closed";
}

} // namespace

TEST_CASE("solids of cells lie in one another as a count of cells says, through corners, edges and flat faces") {
  std::mt19937 g(1);
  std::map<std::string, int> seen;
  for (int i = 0; i < 3000; ++i) {
    CAPTURE(i);
    const cells a = drawn_blocks(g), b = drawn_boxes(g);
    const lattice_map map = i % 3 == 0 ? identity : drawn_map(g);
    const bool swapped = i % 2 == 1;
    const char *const want = swapped ? relation_of(b, a) : relation_of(a, b);
    const triangles of_a = a.surface(map, &g), of_b = b.surface(map, &g);
    const told have = swapped ? relation_in(of_b, of_a) : relation_in(of_a, of_b);
    REQUIRE(have.relation == want);
    ++seen[want];
  }
  for (const char *const one : {"apart", "touching", "a inside b", "b inside a", "overlapping"})
    CHECK(seen[one] > 50);
}

TEST_CASE("the rows of the truth table of solids that do not touch") {
  const auto check = [](const cells &a, const cells &b, const std::string &want) {
    std::mt19937 g(7);
    for (const lattice_map &map : {identity, lattice_map{{{1, 2, 0}, {-1, 1, 1}, {0, 1, -2}}}}) {
      REQUIRE(relation_of(a, b) == want);
      CHECK(relation_in(a.surface(map, &g), b.surface(map, &g)).relation == want);
      const std::string exchanged = want == "b inside a" ? "a inside b" : want == "a inside b" ? "b inside a" : want;
      CHECK(relation_in(b.surface(map, &g), a.surface(map, &g)).relation == exchanged);
    }
  };
  const cells cube = box_of({0, 0, 0}, {9, 9, 9}), small = box_of({4, 4, 4}, {5, 5, 5});
  cells shell = cube, rings[2];
  shell.cut({1, 1, 1}, {8, 8, 8});
  cells with_island = shell;
  with_island.add({3, 3, 3}, {6, 6, 6});
  rings[0] = box_of({0, 0, 0}, {7, 7, 1}).cut({1, 1, 0}, {6, 6, 1});
  rings[1] = box_of({3, 3, -3}, {10, 4, 4}).cut({4, 3, -2}, {9, 4, 3});
  SECTION("cubes apart") {
    check(cube, box_of({11, 0, 0}, {12, 1, 1}), "apart");
  }
  SECTION("interlocked rings, free") {
    check(rings[0], rings[1], "apart");
  }
  SECTION("free in a cavity") {
    check(shell, small, "apart");
  }
  SECTION("free in a cavity, between the shell and its island") {
    check(with_island, box_of({1, 1, 1}, {2, 2, 2}), "touching");
    cells wide = box_of({0, 0, 0}, {19, 19, 19}).cut({1, 1, 1}, {18, 18, 18}).add({8, 8, 8}, {11, 11, 11});
    check(wide, box_of({3, 3, 3}, {5, 6, 7}), "apart");
    check(wide, box_of({9, 9, 9}, {10, 10, 10}), "b inside a");
  }
  SECTION("cube free in a cube") {
    check(cube, small, "b inside a");
  }
  SECTION("cube in the island of a shell") {
    check(with_island, small, "b inside a");
  }
  SECTION("cube in one of two components") {
    check(cells(cube).add({20, 0, 0}, {22, 2, 2}), small, "b inside a");
    check(cells(cube).add({-12, 0, 0}, {-10, 2, 2}), small, "b inside a");
  }
  SECTION("a body larger than the cavity around it") {
    cells thick = box_of({0, 0, 0}, {12, 12, 12}).cut({4, 4, 4}, {8, 8, 8});
    check(thick, box_of({2, 2, 2}, {10, 10, 10}), "overlapping");
    check(thick, box_of({2, 2, 2}, {10, 10, 10}).cut({3, 3, 3}, {9, 9, 9}), "b inside a");
    check(thick, box_of({5, 5, 5}, {7, 7, 7}), "apart");
  }
  SECTION("two components, one inside and one apart") {
    check(cube, cells(small).add({20, 0, 0}, {22, 2, 2}), "overlapping");
    check(cube, cells(small).add({2, 2, 2}, {3, 3, 3}), "b inside a");
  }
}

TEST_CASE("where a mesh is open, or goes around a point some other number of times, it is unknown, with the reason") {
  const triangles cube = box_of({0, 0, 0}, {9, 9, 9}).surface(), small = box_of({4, 4, 4}, {5, 5, 5}).surface();
  const std::string open_in_words = " has an edge where the surface is open or not oriented";
  const triangles beside = box_of({20, 4, 4}, {21, 5, 5}).surface();
  triangles open = cube, turned = cube, inside_out = cube, nested = cube, twice = cube;
  open.rows.erase(open.rows.begin() + 27, open.rows.begin() + 36); // face 3
  turned.turn_round(5);
  inside_out.turn_round();
  nested.append(box_of({1, 1, 1}, {8, 8, 8}).surface());
  twice.append(box_of({2, 2, 2}, {12, 12, 12}).surface());
  CHECK(relation_in(open, small).relation == "unknown");
  CHECK(relation_in(open, small).why == open_at(open) + " of a" + open_in_words);
  CHECK(relation_in(small, open).why == open_at(open) + " of b" + open_in_words);
  CHECK(relation_in(turned, small).why == open_at(turned) + " of a" + open_in_words);
  CHECK(relation_in(inside_out, small).why ==
        "a goes around element 0 of b -1 times, so that its normals point inwards");
  CHECK(relation_in(nested, small).why == "a goes around element 0 of b 2 times");
  CHECK(relation_in(twice, small).why == "a goes around element 0 of b 2 times");
  CHECK(relation_in(twice, box_of({10, 10, 10}, {11, 11, 11}).surface()).relation == "b inside a");
  for (const triangles *const t : {&open, &turned, &inside_out, &nested, &twice})
    CHECK(relation_in(*t, beside).relation == "apart");
  triangles cavity = inside_out; // of a larger cube, whose shell is well oriented
  cavity.append(box_of({-4, -4, -4}, {13, 13, 13}).surface());
  CHECK(relation_in(cavity, small).relation == "apart");
  CHECK(relation_in(cavity, box_of({-3, -3, -3}, {-2, -2, -2}).surface()).relation == "b inside a");

  const triangles sheet{{3, 3, 3, 6, 3, 4, 3, 6, 5}}; // an open mesh may lie inside, and holds nothing
  CHECK(relation_in(sheet, cube).relation == "a inside b");
  CHECK(relation_in(cube, sheet).relation == "b inside a");
  CHECK(relation_in(sheet, inside_out).why ==
        "b goes around element 0 of a -1 times, so that its normals point inwards");
  triangles flat = cube; // faces without area change nothing
  flat.append({{4, 2, 2, 4, 2, 2, 5, 2, 2, 1, 1, 1, 2, 2, 2, 1, 1, 1}});
  CHECK(relation_in(flat, small).relation == "b inside a");
}

TEST_CASE("sets of other kinds lie inside a mesh, and hold none") {
  const auto cube = shape_of(box_of({0, 0, 0}, {9, 9, 9}).surface().view());
  const kind_info &segment = *find_predicate(cga::catalogue(), "segment_triangle").a,
                  &sphere = *find_predicate(cga::catalogue(), "ball_ball").a;
  const std::vector<float> sticks{1, 1, 1, 3, 3, 3, 3, 3, 3, 4, 8, 2, 5, 5, 5, 6, 6, 6},
      one_out{1, 1, 1, 2, 2, 2, 9, 20, 9, 8, 22, 8};
  const auto inside = shape_of({sticks.data(), 0, 0, nullptr, 3}, segment);
  CHECK(inside->topology().parts.size() == 2);
  CHECK(!inside->topology().open);
  CHECK(relation_in(inside, cube).relation == "a inside b");
  CHECK(relation_in(cube, shape_of({one_out.data(), 0, 0, nullptr, 2}, segment)).relation == "overlapping");
  const std::vector<float> balls{2, 2, 2, 1, 5, 5, 5, 2}, around{4, 4, 4, 100};
  CHECK(relation_in(cube, shape_of({balls.data(), 0, 0, nullptr, 2}, sphere)).relation == "b inside a");
  CHECK(relation_in(cube, shape_of({around.data(), 0, 0, nullptr, 1}, sphere)).relation ==
        "touching"); // a ball is solid
  CHECK(relation_in(inside, shape_of({around.data(), 0, 0, nullptr, 1}, sphere)).relation == "touching");
}

TEST_CASE("bodies lie in one another at the ends of float32, and one step apart") {
  std::mt19937 g(2);
  for (const float scale : {0x1p-149f, 0x1p-130f, 0x1p-40f, 0x1p60f, 0x1p123f}) {
    CAPTURE(scale);
    for (int i = 0; i < 40; ++i) {
      const cells a = drawn_blocks(g), b = drawn_boxes(g);
      CHECK(relation_in(a.surface(identity, &g, scale), b.surface(identity, &g, scale)).relation == relation_of(a, b));
    }
  }
  const float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  const auto cube_of = [](float lo, float hi) {
    triangles t = box_of({0, 0, 0}, {1, 1, 1}).surface();
    for (float &x : t.rows)
      x = x == 0 ? lo : hi;
    return t;
  };
  const triangles all = cube_of(-most, most), dust = cube_of(-least, least);
  CHECK(relation_in(all, dust).relation == "b inside a");
  CHECK(relation_in(dust, all).relation == "a inside b");
  CHECK(relation_in(cube_of(0, most), dust).relation == "touching");
  CHECK(relation_in(cube_of(least, most), cube_of(2 * least, 3 * least)).relation == "b inside a");
  CHECK(relation_in(cube_of(0, 1), cube_of(least, std::nextafter(1.0f, 0.0f))).relation == "b inside a");
  CHECK(relation_in(cube_of(0, 1), cube_of(least, 1)).relation == "touching");
  // The point (1, 1, 1) of a cube beside a plane x + y + z = 3 + 2^-22 of a large tetrahedron: one step below, on, above.
  const float step = 0x1p-22f;
  const auto tetrahedron = [](float far, float d) {
    const std::array<float, 3> o{-far, -far, -far}, x{d + far, -far / 2, -far / 2}, y{-far / 2, d + far, -far / 2},
        z{-far / 2, -far / 2, d + far};
    triangles t;
    for (const auto &face : {std::array{o, y, x}, std::array{o, z, y}, std::array{o, x, z}, std::array{x, y, z}})
      for (const auto &corner : face)
        t.rows.insert(t.rows.end(), corner.begin(), corner.end());
    return t;
  };
  const triangles large = tetrahedron(4, 3); // its face lies in x + y + z = 3
  CHECK(relation_in(large, cube_of(0, 1)).relation == "touching");
  CHECK(relation_in(large, cube_of(0, 1 - step)).relation == "b inside a");
  CHECK(relation_in(large, cube_of(1 + step, 1.5f)).relation == "apart");
}

namespace {

// The winding number of a posed set at a point by solid angles, which are rounded to a whole number.
long winding_by_angles(const element_set &set, const float *point) {
  using point_of = std::array<double, 3>;
  const auto dot = [](const point_of &a, const point_of &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  double sum = 0;
  for (std::size_t i = 0; i < set.elements; ++i) {
    std::array<point_of, 3> v;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        v[c][k] = static_cast<double>(set.rows[9 * i + 3 * c + k]) - static_cast<double>(point[k]);
    const auto &[a, b, c] = v;
    const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
    const double det =
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    sum += 2 * std::atan2(det, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return std::lround(sum / (4 * std::numbers::pi));
}

} // namespace

TEST_CASE("bodies in poses lie in one another as sets that were prepared there do, and as solid angles say") {
  const bodies::mesh ball = bodies::icosphere(3), ring = bodies::torus(40, 20), block = bodies::block(4, 3, 2, 2);
  const bodies::mesh *const meshes[] = {&ball, &ring, &block};
  std::vector<std::shared_ptr<const prepared>> shapes;
  for (const bodies::mesh *const m : meshes)
    shapes.push_back(shape_of(view_of(*m)));
  std::mt19937 g(3);
  int inside = 0, apart = 0;
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i);
    const std::size_t x = g() % 3, y = g() % 3;
    const pose at_a = drawn(g, 0.2), at_b = drawn(g, 1, i % 2 == 0 ? 0.1 : 0.25);
    const auto in_place_a = shape_of(view_of(*meshes[x]), triangle(), at_a),
               in_place_b = shape_of(view_of(*meshes[y]), triangle(), at_b);
    const std::string have = relation_in(shapes[x], shapes[y], at_a, at_b).relation;
    CHECK(have == relation_in(in_place_a, in_place_b).relation);
    if (have == "touching")
      continue;
    const long a_around_b = winding_by_angles(in_place_a->set(), in_place_b->set().rows),
               b_around_a = winding_by_angles(in_place_b->set(), in_place_a->set().rows);
    REQUIRE((b_around_a == 0 && (a_around_b == 0 || a_around_b == 1)));
    CHECK(have == (a_around_b == 1 ? "b inside a" : "apart"));
    ++(a_around_b == 1 ? inside : apart);
  }
  pose mirror = drawn(g, 0.2); // it turns a mesh inside out, which the sign of its winding number tells
  for (const int i : {0, 4, 8})
    mirror.m[i] = -mirror.m[i];
  CHECK(relation_in(shapes[0], shapes[1], mirror, drawn(g, 0, 0.1))
            .why.ends_with(" -1 times, so that its normals point inwards"));
  CHECK(inside > 50);
  CHECK(apart > 50);
}

TEST_CASE("nested bodies are the same for any number of threads, and the first is the least") {
  world w(cga::catalogue());
  std::vector<triangles> cubes;
  for (int i = 0; i < 9; ++i)
    cubes.push_back(box_of({-3 - i, -3 - i, -3 - i}, {3 + i, 3 + i, 3 + i}).surface());
  cubes[4].rows.resize(cubes[4].rows.size() - 9); // open
  for (std::size_t i = 0; i < cubes.size(); ++i)
    w.add(std::to_string(i), shape_of(cubes[i].view()));
  const world_answer one = w.touching(nested_options(1));
  REQUIRE(one.nested.size() == 36);
  CHECK(one.touching.empty());
  for (const nested_bodies &n : one.nested)
    CHECK(n.how == (n.b == 4 ? nesting::unknown : nesting::a_inside_b));
  for (const int threads : {2, 5}) {
    const world_answer more = w.touching(nested_options(threads));
    REQUIRE(more.nested.size() == one.nested.size());
    for (std::size_t i = 0; i < one.nested.size(); ++i) {
      const nested_bodies &x = one.nested[i], &y = more.nested[i];
      CHECK((x.a == y.a && x.b == y.b && x.how == y.how && x.why == y.why));
    }
  }
  world_options first = nested_options(2);
  first.first = true;
  for (const std::uint32_t i : {1, 2, 3})
    w.ignore(0, i);
  const world_answer least = w.touching(first); // 0 in 4 is unknown, 0 in 5 is known
  REQUIRE(least.nested.size() == 2);
  CHECK((least.nested[0].b == 4 && least.nested[0].how == nesting::unknown));
  CHECK((least.nested[1].a == 0 && least.nested[1].b == 5));
  const auto touching = shape_of(box_of({10, 0, 0}, {20, 1, 1}).surface().view());
  w.add("touching", touching);
  CHECK(w.touching(first).nested.empty());
  CHECK(w.touching(first).touching.size() == 1);
}

TEST_CASE("what no nesting is told of is refused, and without the question there is no answer") {
  world solid(cga::catalogue()), surface(cga::catalogue(), "surface");
  const auto cube = shape_of(box_of({0, 0, 0}, {9, 9, 9}).surface().view()),
             small = shape_of(box_of({4, 4, 4}, {5, 5, 5}).surface().view());
  solid.add("cube", cube), solid.add("small", small);
  CHECK(solid.touching().nested.empty());
  CHECK(solid.touching(nested_options()).nested.size() == 1);
  solid.ignore(0, 1);
  CHECK(solid.touching(nested_options()).nested.empty());
  world_options plain = nested_options();
  plain.precision = rung::fp32;
  CHECK_THROWS_WITH(solid.touching(plain), Catch::Contains("exact or certified"));
  CHECK_THROWS_WITH(surface.touching(nested_options()), Catch::Contains("in the mode surface no body has an inside"));
}
