// Where pairs meet: the points of all shapes, and the curves of whole meshes.
#include "meet/io/read.hpp"
#include "tests/catch.hpp"
#include "tests/cgal/contacts_judge.hpp"
#include "tests/runtime/contacts/families.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <filesystem>
#include <meet/core/contacts/contacts.hpp>
#include <meet/core/query/collide.hpp>
#include <meet/core/query/find.hpp>

using namespace meetc::cgal_test;
using meetc::contacts_test::families;
using meetc::contacts_test::pair_rows;

namespace {

const meetc::predicate_info &predicate(int corners) {
  return meetc::find_predicate(cga::catalogue(), corners == 3 ? "triangle_triangle" : "segment_triangle");
}

std::set<fraction_point> our_points(const pair_rows &p, bool &wrong) {
  const std::vector<meetc::index_pair> one{{0, 0}};
  const auto c = meetc::contacts({.data = p.a.data(), .elements = 1}, {.data = p.b.data(), .elements = 1},
                                 predicate(static_cast<int>(p.a.size() / 3)), one);
  std::set<fraction_point> out;
  for (std::size_t n = 0; n < c.nodes(); ++n) {
    const auto x = c.exact(n);
    out.insert({x[0].numerator, x[0].denominator, x[1].numerator, x[1].denominator, x[2].numerator, x[2].denominator});
  }
  wrong = out.size() != c.nodes();
  return out;
}

meetc::io::element_set load(const char *name, double scale = 1) {
  const meetc::catalogue &c = cga::catalogue();
  std::vector<const meetc::kind_info *> kinds;
  for (int i = 0; i < c.kind_count; ++i)
    kinds.push_back(&c.kinds[i]);
  meetc::io::read_options options;
  options.move.scale = scale;
  return meetc::io::read(std::filesystem::path(MEETC_DATA) / name, kinds, options);
}
meetc::view view_of(const meetc::io::element_set &s) {
  return {.data = s.data.data(),
          .vertices = s.vertices,
          .stride_bytes = 12,
          .index = s.index.data(),
          .elements = s.elements};
}

void same_curves(const char *name_a, const char *name_b, double scale, std::size_t pairs) {
  if (!std::filesystem::exists(std::filesystem::path(MEETC_DATA) / name_a) ||
      !std::filesystem::exists(std::filesystem::path(MEETC_DATA) / name_b)) {
    WARN("left out, since the data are not there: " << name_a << ", " << name_b);
    return;
  }
  const auto a = load(name_a), b = load(name_b, scale);
  const meetc::predicate_info &touch = predicate(3);
  const auto found = meetc::collide(meetc::prepare(view_of(a), *touch.a), meetc::prepare(view_of(b), *touch.b), touch,
                                    meetc::rung::certified)
                         .pairs;
  CHECK(found.size() == pairs);
  const auto c = meetc::contacts(view_of(a), view_of(b), touch, found);
  CHECK(c.pieces.size() == pairs); // general position
  const curves by_cgal = curves_of(a.data, a.index, b.data, b.index);
  CHECK(c.nodes() == by_cgal.nodes);
  CHECK(c.polylines.size() == by_cgal.polylines);
  CHECK(static_cast<std::size_t>(std::count(c.closed.begin(), c.closed.end(), 1)) == by_cgal.closed);
}

} // namespace

TEST_CASE("contacts: the points of all pairs with area are those of CGAL") {
  for (const int corners : {3, 2})
    for (const auto &f : families(corners)) {
      CAPTURE(f.name, corners);
      std::mt19937 random(21);
      std::size_t different = 0, compared = 0;
      for (int i = 0; i < 4000; ++i) {
        const pair_rows p = f.pair(random);
        const auto theirs = common_points(p.a.data(), corners, p.b.data());
        if (!theirs)
          continue;
        bool wrong = false;
        different += our_points(p, wrong) != *theirs || wrong;
        ++compared;
      }
      CHECK(different == 0);
      CHECK((compared > 100) == (std::string(f.name) != "without area")); // which CGAL leaves undefined
    }
}

TEST_CASE("contacts: the curves of real meshes are those of CGAL") {
  same_curves("armadillo_345k.ply", "bunny_69k.ply", 700, 4762);
}
