// Contacts of sets of balls: nodes and pieces of segments, exact roots in decimal, witnesses, and refusals.
#include "tests/catch.hpp"
#include "tests/runtime/contacts/meshes.hpp"
#include "tests/runtime/contacts/round_families.hpp"

#include <cga/cga_runtime.hpp>
#include <cmath>
#include <cstring>
#include <gmpxx.h>
#include <meet/core/contacts/contacts.hpp>
#include <meet/core/query/find.hpp>
#include <stdexcept>

using namespace meetc;
using namespace meetc::contacts_test;

namespace {

view view_of(const std::vector<float> &rows, std::size_t fields) {
  return {.data = rows.data(),
          .vertices = rows.size() / fields,
          .stride_bytes = 4 * fields,
          .elements = rows.size() / fields};
}
struct asked_sets {
  std::vector<float> balls, others;
  std::size_t fields; // of the others
  const char *predicate;
};
template <class Real = float> contact_set<Real> contacts_of(const asked_sets &s, int threads = 0) {
  const predicate_info &p = find_predicate(cga::catalogue(), s.predicate);
  const view a = view_of(s.balls, 4), b = view_of(s.others, s.fields);
  contact_options options;
  options.threads = threads;
  return contacts<Real>(a, b, p, collide(prepare(a, *p.a), prepare(b, *p.b), p, rung::certified).pairs, options);
}

// A path into, within and out of a ball, which begins and ends outside.
const std::vector<float> path = {-3, 0, 0, -1, 0, 0, -1, 0, 0, 1, 0.5F, 0, 1, 0.5F, 0, 3, 0, 0};
const std::vector<float> ball = {0, 0, 0, 2};

mpf_class number(const std::string &text) {
  return {text, 1000};
}
mpf_class value_of(const decimal_fraction &x) {
  return mpf_class((number(x.numerator) + number(x.root) * sqrt(number(x.radicand))) / number(x.denominator));
}

} // namespace

TEST_CASE("a path through a ball is a polyline between two roots, whichever way its segments run") {
  for (const bool backwards : {false, true}) {
    asked_sets sets{ball, path, 6, "ball_segment"};
    if (backwards)
      std::swap_ranges(sets.others.begin() + 6, sets.others.begin() + 9, sets.others.begin() + 9);
    const contact_set<float> c = contacts_of(sets);
    CHECK(c.pairs.size() == 3);
    CHECK(c.nodes() == 4);
    CHECK(c.pieces.size() == 3);
    REQUIRE(c.polylines.size() == 1);
    CHECK(c.polylines[0].size() == 4);
    CHECK(c.closed[0] == 0);
    CHECK(c.single_nodes.empty());
    CHECK(c.witness_pairs.empty());
    CHECK(c.points[0] == -2);
    CHECK(c.on_a[0].dimension == 2);
    CHECK(c.on_a[1].dimension == 3);
  }
}
TEST_CASE("the two directions of one segment have the same nodes and one piece") {
  const contact_set<float> c = contacts_of({ball, {-3, 1, 0, 3, 1, 0, 3, 1, 0, -3, 1, 0}, 6, "ball_segment"});
  CHECK(c.pairs.size() == 2);
  CHECK(c.nodes() == 2);
  CHECK(c.pieces.size() == 1);
}
TEST_CASE("a segment meets the surface of a ball in two points that nothing joins") {
  const contact_set<float> c = contacts_of({ball, path, 6, "sphere_segment"});
  CHECK(c.pairs.size() == 2);
  CHECK(c.nodes() == 2);
  CHECK(c.pieces.empty());
  CHECK(c.single_nodes.size() == 2);
  const contact_set<float> through = contacts_of({ball, {-3, 0, 0, 3, 0, 0}, 6, "sphere_segment"});
  CHECK(through.corners[0].size() == 2);
  CHECK(through.pieces.empty());
  CHECK(through.single_nodes.size() == 2);
}

TEST_CASE("exact roots in decimal") {
  const contact_set<float> c = contacts_of({{0, 0, 0, 1}, {-2, 0.5F, 0, 2, 0.5F, 0}, 6, "ball_segment"});
  REQUIRE(c.nodes() == 2);
  for (const std::size_t n : {0, 1}) {
    const auto x = c.exact(n);
    CHECK(x[0].numerator == "0");
    CHECK(x[0].root == (n == 0 ? "-1" : "1"));
    CHECK(x[0].radicand == "3");
    CHECK(x[0].denominator == "2");
    CHECK(x[1].numerator == "1");
    CHECK(x[1].denominator == "2");
    CHECK(x[1].root == "0");
    CHECK(x[2].numerator == "0");
  }
  // A square under the root, and a touched surface: fractions.
  const contact_set<float> square = contacts_of({{0, 0, 0, 5}, {-9, 3, 0, 9, 3, 0}, 6, "ball_segment"});
  CHECK(square.exact(0)[0].numerator == "-4");
  CHECK(square.exact(0)[0].radicand == "0");
  const contact_set<float> tangent = contacts_of({{1, 0, 0, 2}, {-9, 2, 0, 9, 2, 0}, 6, "ball_segment"});
  REQUIRE(tangent.nodes() == 1);
  CHECK(tangent.exact(0)[0].numerator == "1");
  CHECK_THROWS_AS(tangent.exact(1), std::out_of_range);
}

TEST_CASE("exact roots lie on the segment's line and on the surface") {
  for (const round_family &f : round_families(6)) {
    CAPTURE(f.name);
    std::mt19937 random(23);
    asked_sets sets{{}, {}, 6, "ball_segment"};
    std::vector<index_pair> pairs;
    for (std::uint32_t i = 0; i < 40; ++i) {
      const round_rows p = f.pair(random);
      sets.balls.insert(sets.balls.end(), p.ball.begin(), p.ball.end());
      sets.others.insert(sets.others.end(), p.other.begin(), p.other.end());
      pairs.push_back({i, i});
    }
    const contact_set<double> c = contacts<double>(view_of(sets.balls, 4), view_of(sets.others, 6),
                                                   find_predicate(cga::catalogue(), sets.predicate), pairs);
    std::size_t wrong = 0;
    for (std::size_t n = 0; n < c.nodes(); ++n) {
      const auto x = c.exact(n);
      const float *const b = c.rows_a.rows.data() + std::size_t{4} * c.sources[n].a, *const s = c.rows_b.rows.data() +
                                                                                                std::size_t{6} *
                                                                                                    c.sources[n].b;
      mpf_class at[3], power(0, 1000), size(0, 1000);
      for (std::size_t k = 0; k < 3; ++k) {
        at[k] = value_of(x[k]);
        const mpf_class w = at[k] - b[k];
        power += w * w, size += w * w;
      }
      power -= mpf_class(b[3], 1000) * b[3];
      if (c.on_a[n].carrier >= 2) // a root
        wrong += abs(power) > size * mpf_class("1e-150", 1000);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3;
        const mpf_class x_side = (at[k] - s[k]) * (mpf_class(s[3 + i], 1000) - s[i]),
                        y_side = (at[i] - s[i]) * (mpf_class(s[3 + k], 1000) - s[k]);
        wrong += abs(x_side - y_side) > (abs(x_side) + abs(y_side)) * mpf_class("1e-100", 1000);
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("witnesses have a place of their own, one for each pair that touches") {
  const std::vector<float> triangles = {-1, -1, 0.5F, 2, -1, 0.5F, 0, 2, 0.5F, 9, 9, 9, 10, 9, 9, 9, 10, 9};
  for (const bool surface : {false, true}) {
    const char *const name = surface ? "sphere_triangle" : "ball_triangle";
    const asked_sets sets{{0, 0, 0, 1}, triangles, 9, name};
    const contact_set<float> c = contacts_of(sets);
    REQUIRE(c.witness_pairs.size() == 1);
    CHECK(c.witnesses.size() == 3);
    CHECK(c.witnesses[2] == 0.5F);
    CHECK((std::abs(c.witnesses[0]) + std::abs(c.witnesses[1]) < 0x1p-40F) == !surface);
    CHECK(c.nodes() == 0);
    CHECK(c.corners.size() == 1);
    CHECK(c.polylines.size() == 0);
    // Pairs that were not found by the predicate have none if they are apart.
    const std::vector<index_pair> both = {{0, 0}, {0, 1}};
    const contact_set<float> all =
        contacts(view_of(sets.balls, 4), view_of(triangles, 9), find_predicate(cga::catalogue(), name), both);
    CHECK(all.witness_pairs == std::vector<std::uint32_t>{0});
  }
  const contact_set<double> balls = contacts_of<double>({{0, 0, 0, 2, 7, 0, 0, 1}, {3, 0, 0, 1}, 4, "ball_ball"});
  CHECK(balls.witnesses == std::vector<double>{2, 0, 0});
}

TEST_CASE("contacts of balls do not depend on the number of threads") {
  std::mt19937 random(29);
  for (const char *const name :
       {"ball_segment", "sphere_segment", "ball_triangle", "sphere_triangle", "sphere_sphere"}) {
    const predicate_info &p = find_predicate(cga::catalogue(), name);
    asked_sets sets{{}, {}, static_cast<std::size_t>(p.b->fields), name};
    for (const round_family &f : round_families(sets.fields))
      for (int i = 0; i < 20; ++i) {
        const round_rows rows = f.pair(random);
        sets.balls.insert(sets.balls.end(), rows.ball.begin(), rows.ball.end());
        sets.others.insert(sets.others.end(), rows.other.begin(), rows.other.end());
      }
    const contact_set<double> one = contacts_of<double>(sets, 1), many = contacts_of<double>(sets, 7);
    CHECK(one.codes == many.codes);
    CHECK(one.corners.nodes == many.corners.nodes);
    CHECK(one.pieces == many.pieces);
    REQUIRE(one.points.size() == many.points.size());
    CHECK((one.points.empty() || std::memcmp(one.points.data(), many.points.data(), 8 * one.points.size()) == 0));
    REQUIRE(one.witnesses.size() == many.witnesses.size());
    CHECK((one.witnesses.empty() ||
           std::memcmp(one.witnesses.data(), many.witnesses.data(), 8 * one.witnesses.size()) == 0));
    CHECK(one.nodes() + one.witness_pairs.size() > 100);
  }
}

TEST_CASE("a predicate without contacts is refused") {
  const std::vector<float> box = {0, 0, 0, 1, 1, 1};
  CHECK_THROWS_AS(contacts(view_of(box, 6), view_of(box, 6), find_predicate(cga::catalogue(), "box_box"), {}),
                  std::invalid_argument);
}
