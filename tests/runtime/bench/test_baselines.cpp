// The classic tests against our exact answers.
//
// They must agree wherever no determinant is near zero and, where they neither divide nor round (small integers), on
// everything. Where rounding matters, their errors are counted and printed, not asserted; the assertion there is that
// our own answers do not change when a scene is shrunk exactly.
#include "tests/catch.hpp"

#include "meet/bench/baselines/baselines.hpp"

#include <cga/cga_runtime.hpp>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <functional>
#include <random>
#include <string_view>
#include <vector>

namespace {

using triangle = std::array<float, 9>;
using segment = std::array<float, 6>;
using ball = std::array<float, 4>;

bool exact(std::string_view predicate, const float *a, const float *b) {
  const meetc::catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i)
    if (all.predicates[i].name == predicate) {
      const meetc::index_pair pair{0, 0};
      meetc::answer out{};
      all.predicates[i].decide[static_cast<int>(meetc::rung::exact)](a, b, &pair, 1, &out);
      return out == meetc::answer::yes;
    }
  throw std::logic_error("no such predicate");
}

template <class T, std::size_t N> std::array<T, N> as(const std::array<float, N> &row) {
  std::array<T, N> out;
  std::copy(row.begin(), row.end(), out.begin());
  return out;
}

using on_triangles = std::function<bool(const triangle &, const triangle &)>;
template <class T> on_triangles moller(double epsilon) {
  return [epsilon](const triangle &a, const triangle &b) {
    return meetc::baselines::moller(as<T>(a).data(), as<T>(b).data(), static_cast<T>(epsilon));
  };
}
template <class T> on_triangles guigue_devillers() {
  return [](const triangle &a, const triangle &b) {
    return meetc::baselines::guigue_devillers(as<T>(a).data(), as<T>(b).data());
  };
}

struct named {
  const char *name;
  on_triangles test;
};
const std::vector<named> &triangle_tests() {
  static const std::vector<named> all{{"Moeller float, epsilon 1e-6", moller<float>(meetc::baselines::moller_epsilon)},
                                      {"Moeller float, epsilon 0", moller<float>(0)},
                                      {"Moeller double, epsilon 0", moller<double>(0)},
                                      {"Guigue-Devillers float", guigue_devillers<float>()},
                                      {"Guigue-Devillers double", guigue_devillers<double>()}};
  return all;
}

double determinant(const float *a, const float *b, const float *c, const float *d) {
  const std::array<double, 3> p{a[0], a[1], a[2]};
  std::array<std::array<double, 3>, 3> m{};
  const std::array<const float *, 3> rows{b, c, d};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      m[i][k] = static_cast<double>(rows[i][k]) - p[k];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// The smallest |determinant| of any four of the points.
double least_determinant(const std::vector<const float *> &points) {
  double least = 1e300;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k)
        for (std::size_t l = k + 1; l < n; ++l)
          least = std::min(least, std::abs(determinant(points[i], points[j], points[k], points[l])));
  return least;
}
template <std::size_t N, std::size_t M>
double least_determinant(const std::array<float, N> &a, const std::array<float, M> &b) {
  std::vector<const float *> points;
  for (std::size_t i = 0; i < N; i += 3)
    points.push_back(a.data() + i);
  for (std::size_t i = 0; i < M; i += 3)
    points.push_back(b.data() + i);
  return least_determinant(points);
}

template <std::size_t N> std::array<float, N> random_row(std::mt19937 &random) {
  std::uniform_real_distribution<float> place(-1, 1);
  std::array<float, N> row;
  std::generate(row.begin(), row.end(), [&] { return place(random); });
  return row;
}
// Whole numbers from 0 to `most`: every determinant is then exact in float.
template <std::size_t N> std::array<float, N> lattice_row(std::mt19937 &random, int most) {
  std::uniform_int_distribution<int> place(0, most);
  std::array<float, N> row;
  std::generate(row.begin(), row.end(), [&] { return static_cast<float>(place(random)); });
  return row;
}
bool has_area(const triangle &t) {
  const auto n = cross(meetc::baselines::corner(t.data(), 1) - meetc::baselines::corner(t.data(), 0),
                       meetc::baselines::corner(t.data(), 2) - meetc::baselines::corner(t.data(), 0));
  return n.x != 0 || n.y != 0 || n.z != 0;
}

// Below this a rounded determinant of numbers up to 1 might have the wrong sign, or be less than Möller's epsilon.
constexpr double clear = 1e-3;

} // namespace

TEST_CASE("triangles in general position: every test gives the exact answer") {
  std::mt19937 random(1);
  int pairs = 0, hits = 0;
  while (pairs < 20000) {
    const triangle a = random_row<9>(random), b = random_row<9>(random);
    if (least_determinant(a, b) < clear)
      continue;
    ++pairs;
    const bool truth = exact("triangle_triangle", a.data(), b.data());
    hits += truth;
    for (const named &n : triangle_tests()) {
      INFO(n.name);
      REQUIRE(n.test(a, b) == truth);
    }
  }
  CHECK(hits > pairs / 20); // both answers are there
  CHECK(hits < pairs / 2);
}

TEST_CASE("triangles on a small lattice: tests that do not round give the exact answer, whatever touches") {
  std::mt19937 random(2);
  std::vector<int> wrong(triangle_tests().size());
  int pairs = 0, degenerate = 0;
  while (pairs < 60000) {
    const triangle a = lattice_row<9>(random, 3), b = lattice_row<9>(random, 3);
    if (!has_area(a) || !has_area(b))
      continue;
    ++pairs;
    degenerate += least_determinant(a, b) == 0;
    const bool truth = exact("triangle_triangle", a.data(), b.data());
    REQUIRE(guigue_devillers<float>()(a, b) == truth);
    REQUIRE(guigue_devillers<double>()(a, b) == truth);
    for (std::size_t i = 0; i < wrong.size(); ++i)
      wrong[i] += triangle_tests()[i].test(a, b) != truth;
  }
  CHECK(degenerate > pairs / 4);
  for (std::size_t i = 0; i < wrong.size(); ++i)
    WARN(fmt::format("lattice, {} pairs: {} wrong: {}", pairs, triangle_tests()[i].name, wrong[i]));
}

TEST_CASE("triangles in one plane of the lattice: every test gives the exact answer") {
  std::mt19937 random(3);
  int pairs = 0, hits = 0;
  while (pairs < 30000) {
    triangle a = lattice_row<9>(random, 4), b = lattice_row<9>(random, 4);
    const int axis = pairs % 4; // the fourth plane leans: x + y + z = const
    for (std::size_t i = 0; i < 9; i += 3)
      for (triangle *const t : {&a, &b})
        if (axis < 3)
          (*t)[i + static_cast<std::size_t>(axis)] = 2;
        else
          (*t)[i + 2] = 8 - (*t)[i] - (*t)[i + 1];
    if (!has_area(a) || !has_area(b))
      continue;
    ++pairs;
    const bool truth = exact("triangle_triangle", a.data(), b.data());
    hits += truth;
    for (const named &n : triangle_tests()) {
      INFO(n.name << " " << fmt::format("{} {}", fmt::join(a, ","), fmt::join(b, ",")));
      REQUIRE(n.test(a, b) == truth);
    }
  }
  CHECK(hits > pairs / 4);
  CHECK(hits < pairs - pairs / 20);
}

TEST_CASE("segments in general position: Moeller-Trumbore gives the exact answer") {
  std::mt19937 random(4);
  int pairs = 0, hits = 0;
  while (pairs < 20000) {
    const segment a = random_row<6>(random);
    const triangle b = random_row<9>(random);
    if (least_determinant(a, b) < clear)
      continue;
    ++pairs;
    const bool truth = exact("segment_triangle", a.data(), b.data());
    hits += truth;
    REQUIRE(meetc::baselines::moller_trumbore(a.data(), b.data(), 1e-6F) == truth);
    REQUIRE(meetc::baselines::moller_trumbore(a.data(), b.data(), 0.0F) == truth);
    REQUIRE(meetc::baselines::moller_trumbore(as<double>(a).data(), as<double>(b).data(), 0.0) == truth);
  }
  CHECK(hits > pairs / 50);
  CHECK(hits < pairs / 2);
}

TEST_CASE("balls: the Euclidean test gives the exact answer, also for whole numbers that touch") {
  std::mt19937 random(5);
  int pairs = 0, hits = 0, tangent = 0;
  while (pairs < 20000) {
    ball a = random_row<4>(random), b = random_row<4>(random);
    if (pairs % 2)
      a = lattice_row<4>(random, 4), b = lattice_row<4>(random, 4);
    a[3] = std::abs(a[3]), b[3] = std::abs(b[3]);
    double gap = -std::pow(double(a[3]) + b[3], 2);
    for (std::size_t k = 0; k < 3; ++k)
      gap += std::pow(double(a[k]) - b[k], 2);
    if (pairs % 2 == 0 && std::abs(gap) < clear)
      continue;
    ++pairs;
    tangent += gap == 0;
    const bool truth = exact("ball_ball", a.data(), b.data());
    hits += truth;
    REQUIRE(meetc::baselines::balls(a.data(), b.data()) == truth);
    REQUIRE(meetc::baselines::balls(as<double>(a).data(), as<double>(b).data()) == truth);
  }
  CHECK(tangent > pairs / 200);
  CHECK(hits > pairs / 10);
  CHECK(hits < pairs - pairs / 10);
}

TEST_CASE("a scene shrunk exactly: the classic tests' errors are counted, ours keep their answers") {
  std::mt19937 random(7);
  std::vector<int> wrong(triangle_tests().size());
  constexpr int pairs = 20000;
  for (int n = 0; n < pairs; ++n) {
    triangle a = random_row<9>(random), b = random_row<9>(random);
    const bool truth = exact("triangle_triangle", a.data(), b.data());
    for (triangle *const t : {&a, &b})
      for (float &x : *t)
        x *= 0x1p-20F;
    REQUIRE(exact("triangle_triangle", a.data(), b.data()) == truth);
    for (std::size_t i = 0; i < wrong.size(); ++i)
      wrong[i] += triangle_tests()[i].test(a, b) != truth;
  }
  for (std::size_t i = 0; i < wrong.size(); ++i)
    WARN(fmt::format("{} random pairs, shrunk by 2^20: {} wrong: {}", pairs, triangle_tests()[i].name, wrong[i]));
}

TEST_CASE("degenerate families: the classic tests' errors are counted, ours keep their answers") {
  std::mt19937 random(6);
  // Pairs that share an edge or a corner, or touch with a corner on the midpoint of an edge; then shrunk exactly.
  std::vector<std::array<triangle, 2>> pairs;
  while (pairs.size() < 20000) {
    triangle a = random_row<9>(random), b = random_row<9>(random);
    for (float &x : a) // ten bits, so that middles are exact
      x = static_cast<float>(static_cast<int>(x * 1024)) / 1024;
    for (float &x : b)
      x = static_cast<float>(static_cast<int>(x * 1024)) / 1024;
    const std::size_t family = pairs.size() % 3;
    if (family < 2)
      std::copy_n(a.begin(), family == 0 ? 6 : 3, b.begin());
    else
      for (std::size_t k = 0; k < 3; ++k)
        b[k] = (a[k] + a[k + 3]) / 2;
    if (has_area(a) && has_area(b))
      pairs.push_back({a, b});
  }
  const auto shrunk = [](triangle t, float by) {
    for (float &x : t)
      x *= by;
    return t;
  };
  for (const float scale : {1.0F, 0x1p-20F}) {
    std::vector<int> wrong(triangle_tests().size());
    for (const auto &[a, b] : pairs) {
      const triangle u = shrunk(a, scale), v = shrunk(b, scale);
      REQUIRE(exact("triangle_triangle", u.data(), v.data())); // they share a point
      for (std::size_t i = 0; i < wrong.size(); ++i)
        wrong[i] += !triangle_tests()[i].test(u, v);
    }
    for (std::size_t i = 0; i < wrong.size(); ++i)
      WARN(fmt::format("{} pairs that share a point, scale {}: {} wrong: {}", pairs.size(), scale,
                       triangle_tests()[i].name, wrong[i]));
  }
}
