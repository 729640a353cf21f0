// Meshes with themselves: known counts, and every pair against exact convex geometry.
#include "meet/bodies/meshes.hpp"
#include "meet/io/read.hpp"
#include "tests/catch.hpp"
#include "tests/runtime/self/meshes.hpp"

#include <filesystem>
#include <stdexcept>
#include <tuple>

using namespace self_test;

namespace {

mesh joined(const mesh &a, const mesh &b, float dx, float dy, float dz) {
  mesh m = a;
  const auto first = static_cast<std::uint32_t>(a.xyz.size() / 3);
  for (std::size_t i = 0; i < b.xyz.size(); i += 3)
    m.xyz.insert(m.xyz.end(), {b.xyz[i] + dx, b.xyz[i + 1] + dy, b.xyz[i + 2] + dz});
  for (const std::uint32_t v : b.index)
    m.index.push_back(first + v);
  return m;
}

mesh tetrahedron() {
  return {{0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}};
}

mesh of_body(const meetc::bodies::mesh &m) {
  return {m.xyz, m.index};
}

mesh of_file(const std::string &name) {
  std::vector<const meetc::kind_info *> kinds;
  for (int i = 0; i < cga::catalogue().kind_count; ++i)
    kinds.push_back(&cga::catalogue().kinds[i]);
  const meetc::io::element_set set = meetc::io::read(std::filesystem::path(MEETC_DATA) / name, kinds);
  return {set.data, set.index};
}

} // namespace

TEST_CASE("a torus whose tube crosses itself has the known numbers of pairs and faces") {
  for (const auto &[r, around, across, faces, pairs, touched] :
       {std::tuple(.2, 32, 16, 1024, 160, 128), std::tuple(.1, 16, 16, 512, 80, 64)}) {
    const mesh m = eight_torus(r, around, across);
    const pair_list found = pairs_of(self_of(m.view()));
    CHECK(m.faces() == static_cast<std::size_t>(faces));
    CHECK(found.size() == static_cast<std::size_t>(pairs));
    CHECK(faces_in(found) == static_cast<std::size_t>(touched));
  }
}

TEST_CASE("a cube that was slid along a face has the known numbers of pairs and faces") {
  mesh m;
  for (const auto &[x, y] : {std::pair(0.F, 0.F), std::pair(1.F, 3.F)}) {
    const auto first = static_cast<std::uint32_t>(m.xyz.size() / 3);
    for (unsigned corner = 0; corner < 8; ++corner)
      m.xyz.insert(m.xyz.end(),
                   {x + (corner & 1 ? 10.F : 0.F), y + (corner & 2 ? 10.F : 0.F), corner & 4 ? 10.F : 0.F});
    for (const std::uint32_t v :
         {0, 2, 1, 2, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 2, 4, 6, 2, 1, 3, 5, 3, 7, 5})
      m.index.push_back(first + v);
  }
  const pair_list found = pairs_of(self_of(m.view()));
  CHECK(m.faces() == 24);
  CHECK(found.size() == 30);
  CHECK(faces_in(found) == 16);
}

TEST_CASE("bodies that do not cross themselves have no pair") {
  for (const mesh &m : {tetrahedron(), of_body(meetc::bodies::icosphere(3)), of_body(meetc::bodies::torus(24, 12)),
                        of_body(meetc::bodies::knot(48, 6))}) {
    const meetc::self_result r = self_of(m.view());
    CHECK(r.pairs.empty());
    CHECK(r.degenerate.empty());
    CHECK(2 * r.neighbours[1] == 3 * m.faces()); // each face has three neighbours across an edge
    CHECK(r.neighbours[2] == 0);
  }
}

TEST_CASE("corners are one by their coordinates, or by their vertex") {
  const mesh apart{{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, -0.0F, 1, 0, 1, 1, 0}, {0, 1, 2, 3, 5, 4}};
  CHECK(self_of(apart.view()).pairs.empty());
  CHECK(self_of(apart.view(), {.merge = false}).pairs.size() == 1);
  const std::vector<float> rows = apart.rows();
  const meetc::view as_rows{.data = rows.data(), .elements = 2};
  CHECK(self_of(as_rows).pairs.empty());
  CHECK(self_of(as_rows, {.merge = false}).pairs.size() == 1);
}

TEST_CASE("a face that is folded onto its neighbour, or there twice, is found") {
  const mesh folded{{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, {0, 1, 2, 0, 2, 3}};
  CHECK(pairs_of(self_of(folded.view())) == pair_list{{0, 1}});
  const mesh twice{{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 1, 1, 2, 0}};
  const meetc::self_result r = self_of(twice.view());
  CHECK(pairs_of(r) == pair_list{{0, 1}, {0, 2}, {1, 2}});
  CHECK(r.neighbours[2] == 3);
}

TEST_CASE("faces without area count as what they are, and are listed") {
  // A face on edge with its neighbour, one that sticks out of it, and a point inside another face.
  const mesh m{{0, 0, 0, 4, 0, 0, 0, 4, 0, 2, 0, 0, 6, 0, 0, 1, 1, 0}, {0, 1, 2, 0, 3, 1, 0, 1, 4, 5, 5, 5}};
  const meetc::self_result r = self_of(m.view());
  CHECK(r.degenerate == std::vector<std::uint32_t>{1, 2, 3});
  CHECK(pairs_of(r) == truth(m, true));
  CHECK(pairs_of(r) == pair_list{{0, 3}});
}

TEST_CASE("pairs of triangles of one item do not count") {
  const mesh folded{{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 0.25F, 0.25F, -1}, {0, 1, 2, 0, 2, 3, 2, 4, 5}};
  const std::vector<std::uint32_t> owner = {0, 0, 1};
  const pair_list all = pairs_of(self_of(folded.view()));
  CHECK(all == truth(folded, true));
  pair_list without;
  for (const auto &p : all)
    if (owner[p.first] != owner[p.second])
      without.push_back(p);
  CHECK(without.size() + 1 == all.size());
  CHECK(pairs_of(self_of(folded.view(), {.owner = owner})) == without);
}

TEST_CASE("every pair of lattice meshes is as exact geometry says, on any number of threads") {
  std::size_t hits = 0, degenerate = 0, found_neighbours[3] = {};
  for (unsigned seed = 0; seed < 240; ++seed) {
    const mesh m = lattice_mesh(seed, 5 + static_cast<int>(seed % 9), 8 + static_cast<int>(seed % 7), 2 + seed % 4);
    for (const bool merge : {true, false}) {
      INFO("seed " << seed << ", merge " << merge);
      const pair_list want = truth(m, merge);
      const meetc::self_result r = self_of(m.view(), {.threads = 1, .merge = merge});
      CHECK(pairs_of(r) == want);
      CHECK(pairs_of(self_of(m.view(), {.threads = 3, .merge = merge})) == want);
      hits += want.size(), degenerate += r.degenerate.size();
      for (int k = 0; k < 3; ++k)
        found_neighbours[k] += r.neighbours[k];
    }
  }
  CHECK(hits > 4000);
  CHECK(degenerate > 200);
  for (const std::size_t n : found_neighbours)
    CHECK(n > 100);
}

TEST_CASE("scaling and translation that are exact change nothing") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const mesh m = lattice_mesh(seed, 9, 12, 4);
    const pair_list want = truth(m, true);
    for (const double scale : {0x1p-120, 0x1p-30, 0x1p90}) {
      meetc::pose at;
      for (const int k : {0, 5, 10})
        at.m[k] = scale;
      CHECK(pairs_of(self_of(m.view(), {}, at)) == want);
    }
    meetc::pose away;
    away.m[3] = 0x1p20, away.m[7] = -0x1p18, away.m[11] = 12345;
    CHECK(pairs_of(self_of(m.view(), {}, away)) == want);
  }
}

TEST_CASE("crossing bodies in one mesh give the pairs of the bodies, and the same bytes on any number of threads") {
  const mesh ball = of_body(meetc::bodies::icosphere(3));
  const mesh both = joined(ball, ball, 0.3F, 0.2F, 0.1F);
  const meetc::prepared a = meetc::prepare(both.view(), *predicates().apart.a);
  pair_list want;
  const auto half = static_cast<std::uint32_t>(ball.faces());
  for (const meetc::index_pair p : meetc::collide(a, a, predicates().apart, meetc::rung::certified).pairs)
    if (p.a < half && p.b >= half)
      want.emplace_back(p.a, p.b);
  CHECK(want.size() > 100);
  for (const int threads : {1, 2, 5}) {
    const meetc::self_result r = self_of(both.view(), {.threads = threads});
    CHECK(pairs_of(r) == want);
    CHECK(r.candidates == self_of(both.view(), {.threads = 1}).candidates);
  }
}

TEST_CASE("bad input is an error") {
  const mesh m = tetrahedron(), other = of_body(meetc::bodies::icosphere(1));
  const meetc::prepared set = meetc::prepare(m.view(), *predicates().apart.a);
  CHECK_THROWS_AS(meetc::self_pairs(set, other.view(), predicates()), std::invalid_argument);
  const std::vector<std::uint32_t> owner = {0, 1};
  CHECK_THROWS_AS(meetc::self_pairs(set, m.view(), predicates(), {.owner = owner}), std::invalid_argument);
  const meetc::self_predicates balls{meetc::find_predicate(cga::catalogue(), "ball_ball"), predicates().one_common,
                                     predicates().two_common};
  CHECK_THROWS_AS(meetc::self_pairs(set, m.view(), balls), std::invalid_argument);
  mesh wrong = m;
  wrong.index[5] = 9;
  CHECK_THROWS_AS(meetc::self_pairs(set, wrong.view(), predicates()), std::out_of_range);
  const meetc::prepared ball = meetc::prepare(other.view(), *predicates().apart.a);
  const meetc::prepared part = meetc::prepare(m.view(), *predicates().apart.a, {}, 0, &ball);
  CHECK_THROWS_AS(meetc::self_pairs(part, m.view(), predicates()), std::invalid_argument);
  const mesh none;
  CHECK(self_of(none.view()).pairs.empty());
}

TEST_CASE("real meshes do not cross themselves", "[data]") {
  for (const auto &[file, one, two] :
       {std::tuple("bunny_69k.ply", 317061, 104065), std::tuple("armadillo_345k.ply", 1601556, 518916)}) {
    if (!std::filesystem::exists(std::filesystem::path(MEETC_DATA) / file))
      continue;
    const mesh m = of_file(file);
    const meetc::self_result r = self_of(m.view());
    CHECK(r.pairs.empty());
    CHECK(r.neighbours[0] == static_cast<std::uint64_t>(one));
    CHECK(r.neighbours[1] == static_cast<std::uint64_t>(two));
  }
}
