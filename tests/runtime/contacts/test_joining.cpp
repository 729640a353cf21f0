// Nodes, pieces and polylines of whole meshes: against exact points, and curves whose number is known.
#include "tests/catch.hpp"
#include "tests/runtime/contacts/definition.hpp"
#include "tests/runtime/contacts/meshes.hpp"

#include <cga/cga_runtime.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <meet/core/contacts/contacts.hpp>
#include <meet/core/query/find.hpp>
#include <neighbours/neighbours_runtime.hpp>
#include <random>
#include <set>

using namespace meetc;
using namespace meetc::contacts_test;

namespace {

const predicate_info &predicate_for(const mesh &a) {
  return find_predicate(cga::catalogue(), a.corners == 3 ? "triangle_triangle" : "segment_triangle");
}
std::vector<index_pair> pairs_of(const mesh &a, const mesh &b) {
  const predicate_info &p = predicate_for(a);
  return collide(prepare(a.view(), *p.a), prepare(b.view(), *p.b), p, rung::certified).pairs;
}
template <class Real = float> contact_set<Real> contacts_of(const mesh &a, const mesh &b, int threads = 0) {
  contact_options options;
  options.threads = threads;
  return contacts<Real>(a.view(), b.view(), predicate_for(a), pairs_of(a, b), options);
}

using text_point = std::array<std::string, 6>;
text_point text_of(const exact_point &x) {
  text_point out;
  for (std::size_t k = 0; k < 3; ++k)
    out[2 * k] = x[k].get_num().get_str(), out[2 * k + 1] = x[k].get_den().get_str();
  return out;
}
template <class Real> std::vector<text_point> exact_nodes(const contact_set<Real> &c) {
  std::vector<text_point> out;
  for (std::size_t n = 0; n < c.nodes(); ++n) {
    const auto x = c.exact(n);
    out.push_back(
        {x[0].numerator, x[0].denominator, x[1].numerator, x[1].denominator, x[2].numerator, x[2].denominator});
  }
  return out;
}

// The nodes and segments of all pairs of faces, by the definition.
struct truth {
  std::set<text_point> nodes;
  std::set<std::set<text_point>> segments;     // of pairs that meet in one
  std::set<std::set<text_point>> in_one_plane; // where all such pairs are coplanar
};
truth truth_of(const mesh &a, const mesh &b) {
  truth out;
  for (std::size_t i = 0; i < a.elements(); ++i)
    for (std::size_t j = 0; j < b.elements(); ++j) {
      const std::vector<float> x = a.row(i), y = b.row(j);
      const auto labels = labels_by_definition(x.data(), static_cast<int>(a.corners), y.data(), 3);
      std::set<text_point> at;
      for (const exact_label &l : labels)
        at.insert(text_of(l.at));
      out.nodes.insert(at.begin(), at.end());
      if (at.size() != 2)
        continue;
      const bool flat = a.corners == 3 && is_zero(cross(normal_of(x.data()), normal_of(y.data())));
      (flat ? out.in_one_plane : out.segments).insert(at);
    }
  return out;
}

void check_against_truth(const mesh &a, const mesh &b) {
  const auto c = contacts_of(a, b);
  const truth t = truth_of(a, b);
  const std::vector<text_point> nodes = exact_nodes(c);
  const std::set<text_point> distinct(nodes.begin(), nodes.end());
  CHECK(distinct.size() == nodes.size()); // one to one, as both meshes are embedded
  CHECK(distinct == t.nodes);
  std::set<std::set<text_point>> pieces;
  for (const auto &p : c.pieces)
    pieces.insert({nodes[p[0]], nodes[p[1]]});
  CHECK(pieces.size() == c.pieces.size());
  for (const auto &p : t.segments)
    CHECK(pieces.count(p) == 1);
  for (const auto &p : pieces)
    CHECK((t.segments.count(p) == 1 || t.in_one_plane.count(p) == 1));
  std::size_t joined = 0; // polylines take each piece once
  for (std::size_t i = 0; i < c.polylines.size(); ++i)
    joined += c.polylines[i].size() - (c.closed[i] ? 0 : 1);
  CHECK(joined == c.pieces.size());
}

mesh plane(int n, double (*height)(double u, double v)) {
  return sheet(n, n, [height](double u, double v, float *at) {
    at[0] = static_cast<float>(4 * u - 2), at[1] = static_cast<float>(4 * v - 2);
    at[2] = static_cast<float>(height(u, v));
  });
}

} // namespace

TEST_CASE("nodes are the exact points of embedded meshes, and pieces their segments") {
  const mesh cube = cuboid(0, 0, 0, 2, 2, 2);
  std::mt19937 random(1);
  check_against_truth(cube, cuboid(1, 1, 1, 3, 3, 3));
  check_against_truth(cube, cuboid(2, 0, 0, 4, 2, 2)); // face to face
  check_against_truth(cube, cuboid(2, 1, 1, 4, 3, 3));
  check_against_truth(cube, cuboid(2, 2, 0, 3, 3, 2)); // along an edge
  check_against_truth(cube, cuboid(2, 2, 2, 3, 3, 3)); // at a corner
  check_against_truth(cube, cuboid(0, 0, 0, 1, 1, 1)); // inside, with three faces in common
  for (int i = 0; i < 12; ++i) {
    const auto number = [&random](int n) { return static_cast<float>(random() % static_cast<unsigned>(n)); };
    const float x = number(4) - 1, y = number(4) - 1, z = number(4) - 1;
    check_against_truth(cube, cuboid(x, y, z, x + 1 + number(2), y + 1 + number(2), z + 1 + number(2)));
    check_against_truth(sphere(4, 5, 2, 0.25 * number(4)), cuboid(x, y, z, x + 1.5F, y + 1.25F, z + 1));
  }
}

TEST_CASE("segments and a mesh") {
  mesh edges;
  edges.corners = 2;
  edges.points = {-1, 1, 1, 3, 1, 1, 0, 0, -1, 0, 0, 3, 1, 2, 0.5F, 1, 2, 1.5F, 5, 5, 5, 5, 5, 5, 2, 2, 2, 2, 2, 2};
  edges.index = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  check_against_truth(edges, cuboid(0, 0, 0, 2, 2, 2));
}

TEST_CASE("a sphere and a plane meet in one closed curve") {
  const mesh ball = sphere(30, 30, 1);
  const mesh level = plane(7, [](double, double) { return 0.5; });
  for (const auto &c : {contacts_of(ball, level), contacts_of(level, ball)}) {
    CHECK(c.polylines.size() == 1);
    CHECK(c.closed == std::vector<std::uint8_t>{1});
    CHECK(c.single_nodes.empty());
    for (std::size_t n = 0; n < c.nodes(); ++n) {
      const double x = c.points[3 * n], y = c.points[3 * n + 1];
      CHECK(c.points[3 * n + 2] == 0.5F);
      CHECK(x * x + y * y <= 0.75 + 1e-6);
      CHECK(x * x + y * y >= 0.75 * std::pow(std::cos(3.15 / 30), 2) - 0.01);
    }
  }
}

TEST_CASE("three planes and one across meet in three curves") {
  mesh three = plane(3, [](double, double) { return -1.0; });
  append(three, plane(3, [](double, double) { return 0.0; }));
  append(three, plane(4, [](double, double) { return 1.0; }));
  const mesh across = sheet(5, 5, [](double u, double v, float *at) {
    at[0] = static_cast<float>(u - 0.4), at[1] = static_cast<float>(2 * u - 1);
    at[2] = static_cast<float>(4 * v - 2.1);
  });
  const auto c = contacts_of(three, across);
  CHECK(c.polylines.size() == 3);
  CHECK(c.closed == std::vector<std::uint8_t>(3, 0));
}

TEST_CASE("in general position each pair is a piece, along the cross product of the normals") {
  const mesh a = sphere(40, 60, 1), b = sphere(50, 41, 0.9, 0.71, 0.133, 0.1);
  const auto c = contacts_of(a, b);
  CHECK(c.pairs.size() > 200);
  CHECK(c.pieces.size() == c.pairs.size());
  CHECK(c.nodes() == c.pairs.size());
  CHECK(c.polylines.size() == 1);
  CHECK(c.closed == std::vector<std::uint8_t>{1});
  // The polyline runs as the pieces do.
  const auto line = c.polylines[0];
  std::set<std::array<std::uint32_t, 2>> steps(c.pieces.begin(), c.pieces.end());
  for (std::size_t i = 0; i < line.size(); ++i)
    CHECK(steps.count({line[i], line[(i + 1) % line.size()]}) == 1);
}

TEST_CASE("faces of two boxes in one plane overlap in patches, whose outline is a polyline") {
  const auto c = contacts_of(cuboid(0, 0, 0, 2, 2, 2), cuboid(0.5F, 0.5F, 2, 1.5F, 1.5F, 3));
  double area = 0;
  for (std::size_t i = 0; i < c.patches.size(); ++i) {
    const auto p = c.patches[i];
    CHECK(contact_code(c.codes[c.patch_pairs[i]]).in_one_plane());
    CHECK(!contact_code(c.codes[c.patch_pairs[i]]).normals_agree());
    for (std::size_t k = 0; k < p.size(); ++k) {
      const float *x = &c.points[std::size_t{3} * p[k]], *y = &c.points[std::size_t{3} * p[(k + 1) % p.size()]];
      area += (x[0] * y[1] - x[1] * y[0]) / 2; // counter-clockwise: the normal of A's face is +z
    }
  }
  CHECK(area == 1);
  CHECK(c.polylines.size() >= 1);
}

TEST_CASE("an answer does not depend on threads, and its coordinates in both types are those of the fractions") {
  const mesh a = sphere(20, 31, 1), b = sphere(25, 21, 0.9, 0.71, 0.133, 0.217);
  const auto one = contacts_of(a, b, 1), two = contacts_of(a, b, 2);
  CHECK(one.points == two.points);
  CHECK(one.codes == two.codes);
  CHECK(one.polylines.nodes == two.polylines.nodes);
  const auto wide = contacts_of<double>(a, b);
  REQUIRE(wide.nodes() == one.nodes());
  for (std::size_t n = 0; n < wide.nodes(); ++n) {
    const auto x = wide.exact(n);
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class q(x[k].numerator + "/" + x[k].denominator);
      CHECK(abs(q - mpq_class(wide.points[3 * n + k])) <= abs(q) * mpq_class(0x1p-53));
      CHECK(abs(q - mpq_class(one.points[3 * n + k])) <= abs(q) * mpq_class(0x1p-24));
    }
  }
}

TEST_CASE("bad calls are refused") {
  const mesh a = cuboid(0, 0, 0, 1, 1, 1);
  const predicate_info &p = predicate_for(a), &other = find_predicate(cga::catalogue(), "segment_segment");
  const std::vector<index_pair> beyond{{0, 12}}, none;
  CHECK_THROWS_AS(contacts(a.view(), a.view(), p, beyond), std::out_of_range);
  CHECK_THROWS_AS(contacts(a.view(), a.view(), other, none), std::invalid_argument);
  meetc::view bad = a.view();
  bad.data = nullptr;
  CHECK_THROWS_AS(contacts(bad, a.view(), p, none), std::invalid_argument);
  mesh nan = a;
  nan.points[3] = NAN;
  const std::vector<index_pair> some{{0, 0}};
  CHECK_THROWS_AS(contacts(nan.view(), a.view(), p, some), input_error);
  CHECK_THROWS_AS(contacts(a.view(), a.view(), p, some).exact(1000), std::out_of_range);
  CHECK(contacts(a.view(), a.view(), p, none).nodes() == 0);
}

TEST_CASE("embedded meshes are told from others, where it is asked") {
  const self_predicates by{find_predicate(cga::catalogue(), "triangle_triangle"),
                           find_predicate(neighbours::catalogue(), "beyond_corner"),
                           find_predicate(neighbours::catalogue(), "beyond_edge")};
  const auto embedded = [&by](const mesh &a, const mesh &b, const pose &at = {}) {
    contact_options options;
    options.embedded_by = &by;
    options.at_a = at;
    const auto &p = predicate_for(a);
    const auto pairs = collide(prepare(a.view(), *p.a, at), prepare(b.view(), *p.b), p, rung::certified).pairs;
    const auto c = contacts<float>(a.view(), b.view(), p, pairs, options);
    options.embedded_by = nullptr;
    const auto plain = contacts<float>(a.view(), b.view(), p, pairs, options);
    CHECK(plain.embedded == embedding::unchecked);
    CHECK(plain.points == c.points);
    return c.embedded;
  };
  const mesh cube = cuboid(0, 0, 0, 2, 2, 2), other = cuboid(1, 1, 1, 3, 3, 3);
  CHECK(embedded(cube, other) == embedding::embedded);
  CHECK(embedded(cube, cube) == embedding::embedded);
  mesh twice = other; // a face that is there twice
  twice.index.insert(twice.index.end(), {other.index[0], other.index[1], other.index[2]});
  CHECK(embedded(cube, twice) == embedding::not_embedded);
  CHECK(embedded(twice, cube) == embedding::not_embedded);
  mesh thin = other; // a face without area
  thin.index.insert(thin.index.end(), {other.index[0], other.index[1], other.index[1]});
  CHECK(embedded(cube, thin) == embedding::not_embedded);
  mesh crossing = cube;
  append(crossing, other);
  CHECK(embedded(crossing, other) == embedding::not_embedded);
  pose flat; // in which the cube has faces without area
  flat.m[10] = 0;
  CHECK(embedded(cube, other, flat) == embedding::not_embedded);
  CHECK(embedded(cuboid(9, 9, 9, 10, 10, 10), twice) == embedding::not_embedded); // though nothing touches
  mesh edges;
  edges.corners = 2;
  edges.points = {-1, 1, 1, 3, 1, 1};
  edges.index = {0, 1};
  CHECK_THROWS_AS(embedded(edges, cube), std::invalid_argument);
}
