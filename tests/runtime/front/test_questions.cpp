// The questions of the front door give the answers of collide(), whichever order the predicate takes the kinds in.
#include "tests/catch.hpp"

#include <meet/meet.hpp>

#include <random>

namespace {

struct scene {
  std::vector<std::array<float, 9>> faces;
  std::vector<std::array<float, 6>> sticks;
  std::vector<std::array<float, 4>> balls;
};

scene random_scene() {
  std::mt19937 engine(42);
  const auto number = [&](int n) { return static_cast<float>(engine() % static_cast<unsigned>(n)) / 4; };
  scene s;
  s.faces.resize(60), s.sticks.resize(50), s.balls.resize(40);
  for (auto &f : s.faces) {
    const std::array<float, 3> around = {number(24), number(24), number(24)};
    for (std::size_t k = 0; k < 9; ++k)
      f[k] = around[k % 3] + number(8);
  }
  for (auto &f : s.sticks)
    for (float &x : f)
      x = number(24);
  for (auto &b : s.balls)
    b = {number(24), number(24), number(24), number(24)};
  return s;
}

template <class Pairs> std::vector<std::pair<std::uint32_t, std::uint32_t>> as_list(const Pairs &pairs) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  for (const auto &[a, b] : pairs)
    out.emplace_back(a, b);
  return out;
}

} // namespace

TEST_CASE("front: each question answers as collide() does") {
  const scene s = random_scene();
  const meet::prepared sticks = meet::prepare(meet::segments(s.sticks)),
                       faces = meet::prepare(meet::triangles(s.faces));
  const meetc::predicate_info &p = meetc::find_predicate(cga::catalogue(), "segment_triangle");
  const auto asked = [&](meetc::answer_kind want, bool first = false) {
    return meetc::collide(sticks, faces, p, meetc::rung::certified, {.want = want, .first_met = first});
  };
  const auto pairs = meet::pairs(sticks, faces);
  REQUIRE(pairs.size() > 20);
  CHECK(as_list(pairs) == as_list(asked(meetc::answer_kind::pairs).pairs));
  CHECK(meet::count(sticks, faces) == pairs.size());
  CHECK(meet::counts(sticks, faces).a == asked(meetc::answer_kind::counts).counts.a);
  CHECK(meet::counts(sticks, faces).b == asked(meetc::answer_kind::counts).counts.b);
  CHECK(meet::flags(sticks, faces).b == asked(meetc::answer_kind::flags).flags.b);
  CHECK(meet::any(sticks, faces));
  CHECK(meet::first_met(sticks, faces) == asked(meetc::answer_kind::none, true).first_met);

  // The other way round: the same pairs, turned and sorted.
  auto turned = as_list(meet::pairs(faces, sticks));
  CHECK(std::is_sorted(turned.begin(), turned.end()));
  for (auto &[a, b] : turned)
    std::swap(a, b);
  std::sort(turned.begin(), turned.end());
  CHECK(turned == as_list(pairs));
  CHECK(meet::counts(faces, sticks).a == meet::counts(sticks, faces).b);
  CHECK(meet::flags(faces, sticks).b == meet::flags(sticks, faces).a);
  CHECK_THROWS_WITH(meet::first_met(faces, sticks),
                    "segment_triangle tells what a segment meets first, not a triangle");
}

TEST_CASE("front: mode, predicate, precision and options") {
  const scene s = random_scene();
  const meet::prepared balls = meet::prepare(meet::spheres(s.balls)), faces = meet::prepare(meet::triangles(s.faces));
  const std::uint64_t solid = meet::count(balls, faces), surface = meet::count(faces, balls, {.mode = "surface"});
  CHECK(surface < solid);
  CHECK(meet::count(balls, faces, {.predicate = "sphere_triangle"}) == surface);
  CHECK(meet::count(balls, faces, {.precision = meet::rung::exact, .with = {.threads = 1}}) == solid);

  // Items of the first set stay items of the first set where the predicate takes it second.
  std::vector<std::uint32_t> one_item(s.faces.size(), 0);
  const auto by_item = meet::pairs(faces, balls, {.with = {.owner_a = one_item}});
  std::size_t touched = 0;
  for (const std::uint8_t hit : meet::flags(faces, balls).b)
    touched += hit;
  REQUIRE(touched > 0);
  CHECK(by_item.size() == touched);
  for (const auto &[item, ball] : by_item)
    CHECK(item == 0);
}

TEST_CASE("front: a question that no predicate answers is misuse") {
  const std::vector<std::array<float, 6>> boxes = {{0, 0, 0, 1, 1, 1}};
  const std::vector<std::array<float, 4>> balls = {{0, 0, 0, 1}};
  const meet::prepared a = meet::prepare(meet::boxes(boxes)), b = meet::prepare(meet::spheres(balls));
  CHECK(meet::any(a, a));
  CHECK_THROWS_AS(meet::any(a, b), meet::usage_error);
  CHECK_THROWS_WITH(meet::any(a, a, {.mode = "surfaces"}), "no mode 'surfaces'; there are: solid, surface");
  CHECK_THROWS_WITH(meet::any(a, b),
                    Catch::Contains("no predicate in cga takes a box and a sphere, mode 'solid'; there "
                                    "are: segment_segment, point_triangle"));
  CHECK_THROWS_WITH(meet::any(b, b, {.predicate = "box_box"}),
                    Catch::Contains("no predicate 'box_box' in cga takes a sphere and a sphere"));
  CHECK_THROWS_AS(meet::first_met(b, b), meet::usage_error);
}

TEST_CASE("front: a set whose points move goes where a prepared one does") {
  std::vector<std::array<float, 3>> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 1, 2}};
  const float segment[] = {0.25F, 0.25F, -1, 0.25F, 0.25F, 1};
  const meet::prepared through = meet::prepare(meet::segments(segment));
  meet::moving_set cloth = meet::moving(meet::triangles(points, faces), {}, 1);
  CHECK(meet::count(cloth, through) == 1);
  for (auto &p : points)
    p[2] += 2;
  CHECK(meet::any(through, cloth));
  cloth.update(meet::triangles(points, faces));
  CHECK_FALSE(meet::any(cloth, through));
  cloth.reorder(meet::triangles(points, faces), {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -2}});
  CHECK(meet::pairs(through, cloth).size() == 1);
}

TEST_CASE("front: a set as it was read") {
  meetc::io::element_set file;
  file.kind = &meetc::find_kind(cga::catalogue(), "triangle");
  file.data = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  file.index = {0, 1, 2};
  file.elements = 1;
  const meet::prepared mesh = meet::prepare(meet::elements_of(file));
  CHECK(meet::count(mesh, mesh) == 1);
}
