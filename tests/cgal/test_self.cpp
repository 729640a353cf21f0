// Meshes with themselves: the pairs that meet beyond their common corners, against CGAL's self-intersections, pair for pair.
#include "meet/io/read.hpp"
#include "tests/catch.hpp"
#include "tests/cgal/scenes.hpp"
#include "tests/cgal/self_judge.hpp"
#include "tests/runtime/self/meshes.hpp"

#include <filesystem>
#include <set>

using namespace meetc::cgal_test;
using self_test::mesh;

namespace {

// The pairs of both, by vertices as CGAL takes them, without those of faces that have no area. Returns their number, or nothing
// where the mesh is no manifold.
std::optional<std::size_t> same_pairs_of_self(const std::string &name, const mesh &m) {
  const std::optional<pair_list> want = self_intersections(m.xyz, m.index);
  if (!want)
    return std::nullopt;
  INFO(name);
  const meetc::self_result r = self_test::self_of(m.view(), {.merge = false});
  const std::set<std::uint32_t> flat(r.degenerate.begin(), r.degenerate.end());
  pair_list found;
  for (const auto &p : self_test::pairs_of(r))
    if (!flat.count(p.first) && !flat.count(p.second))
      found.push_back(p);
  CHECK(found == *want);
  return want->size();
}

// A closed body whose corners move to a small lattice: faces cross, fold and lose their area.
mesh on_lattice(const mesh &of, unsigned seed, int size) {
  mesh m = of;
  std::mt19937 random(seed);
  for (float &x : m.xyz)
    x = static_cast<float>(random() % static_cast<unsigned>(size));
  return m;
}

mesh of_body(const meetc::bodies::mesh &m) {
  return {m.xyz, m.index};
}

} // namespace

TEST_CASE("lattice meshes cross themselves where CGAL says so") {
  const mesh tetrahedron{{0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}};
  std::size_t pairs = 0, meshes = 0;
  for (const mesh &of : {tetrahedron, of_body(meetc::bodies::icosphere(0)), of_body(meetc::bodies::icosphere(1))})
    for (unsigned seed = 0; seed < 200; ++seed)
      if (const auto n = same_pairs_of_self("seed " + std::to_string(seed), on_lattice(of, seed, 3 + seed % 5)))
        pairs += *n, ++meshes;
  CHECK(meshes == 600);
  CHECK(pairs > 20000);
}

TEST_CASE("bodies that cross themselves do so where CGAL says") {
  CHECK(same_pairs_of_self("torus", self_test::eight_torus(.2, 32, 16)) == 160);
  CHECK(same_pairs_of_self("torus", self_test::eight_torus(.1, 16, 16)) == 80);
  CHECK(same_pairs_of_self("gear", of_body(meetc::bodies::gear(12, 2))) == 0);
}

TEST_CASE("real meshes cross themselves where CGAL says", "[data]") {
  std::vector<const meetc::kind_info *> kinds;
  for (int i = 0; i < cga::catalogue().kind_count; ++i)
    kinds.push_back(&cga::catalogue().kinds[i]);
  std::error_code none;
  for (const auto &entry : std::filesystem::directory_iterator(MEETC_DATA, none)) {
    if (entry.path().extension() != ".ply")
      continue;
    const meetc::io::element_set set = meetc::io::read(entry.path(), kinds);
    same_pairs_of_self(entry.path().filename().string(), {set.data, set.index}); // where it is a manifold
  }
}
