// The classic traps, as published: arithmetic without a bound falls into them, certified answers do not.
#include "tests/catch.hpp"
#include "tests/extremes/campaign.hpp"
#include "tests/generated/judge/effort.hpp"

#include <algorithm>
#include <numeric>

using namespace meetc::extremes_test;
using meetc::generated_test::effort;

namespace {

// Along a column.
template <class T> T naive_determinant(const integer_rows &m, int j) {
  const int k = (j + 1) % 3, l = (j + 2) % 3;
  const auto at = [&](int row, int column) { return static_cast<T>(m.v[row][column]); };
  const auto minor = [&](int x, int y) { return at(x, k) * at(y, l) - at(y, k) * at(x, l); };
  return at(0, j) * minor(1, 2) + at(1, j) * minor(2, 0) + at(2, j) * minor(0, 1);
}

// Kettner's orientation test, as it is usually written.
template <class T> int naive_turn(T px, T py, T q, T r) {
  const T d = (q - px) * (r - py) - (q - py) * (r - px);
  return (d > 0) - (d < 0);
}

} // namespace

TEST_CASE("bites: the rows of determinant 1") {
  CHECK(naive_determinant<std::int64_t>(known_rows, 0) == 1);
  CHECK(naive_determinant<float>(known_rows, 0) < -1e9F);
  CHECK(naive_determinant<double>(known_rows, 1) < -10);

  // The four points in all orders, and one of them in the plane of the others.
  std::array<std::array<float, 3>, 4> points{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      points[i][k] = static_cast<float>(known_rows.v[i][k]);
  for (const char *name : {"side_triangle_point", "twist_segment_segment"}) {
    const subject &s = subject_named(name);
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    int wrong32 = 0, wrong64 = 0, sum = 0;
    random_numbers random(1);
    do {
      pair_of_rows p;
      for (std::size_t i = 0; i < 4; ++i)
        (i < corners(s.a) ? p.a : p.b)
            .insert((i < corners(s.a) ? p.a : p.b).end(), points[order[i]].begin(), points[order[i]].end());
      INFO(name << ": " << text(p));
      CHECK(check_case(s, p, random).wrong == 0);
      const int truth = s.truth(p.a.data(), p.b.data());
      CHECK(truth != 0);
      sum += truth;
      wrong32 += s.plain32(p.a.data(), p.b.data()) != truth;
      wrong64 += s.plain64(p.a.data(), p.b.data()) != truth;
    } while (std::next_permutation(order.begin(), order.end()));
    CHECK(sum == 0); // half of the orders are odd
    CHECK(wrong32 > 0);
    CHECK(wrong64 > 0);
  }
}

TEST_CASE("bites: plain arithmetic is wrong on every family") {
  for (const family &f : families()) {
    int wrong32 = 0, wrong64 = 0;
    for (const subject &s : subjects()) {
      if (!f.applies(s.a, s.b))
        continue;
      random_numbers random(5);
      // Doubles are rarely wrong in some families, so that a short run goes on until they are.
      for (int i = 0; i < effort(2000) || (wrong64 == 0 && i < 2000); ++i) {
        const pair_of_rows p = f.make(s.a, s.b, random);
        const int truth = s.truth(p.a.data(), p.b.data());
        wrong32 += s.plain32(p.a.data(), p.b.data()) != truth;
        wrong64 += s.plain64(p.a.data(), p.b.data()) != truth;
      }
    }
    INFO(f.name << ": fp32 wrong " << wrong32 << ", fp64 wrong " << wrong64);
    CHECK(wrong32 > effort(300));
    CHECK(wrong64 > 0);
  }
}

TEST_CASE("bites: Kettner's whole grids have 256 zeros") {
  // Inputs are float32, and 1/2 + i 2^-53 is not. Moved by (-1/2, -1/2) the grid is i 2^-53, which is, so the version
  // for doubles can be run against fp64 as well, and steps of 2^-100 against double-double.
  const subject &side = subject_named("side_triangle_point"), &turn = subject_named("point_triangle");
  random_numbers random(2);
  for (std::size_t version = 0; version < std::size(kettner_lines); ++version) {
    const kettner_line &line = kettner_lines[version];
    INFO("steps of " << line.step);
    int zeros = 0, wrong = 0, naive32 = 0, naive64 = 0;
    std::array<int, bounded> unsure{};
    const int stride = effort(100) == 100 ? 1 : 16;
    for (int i = 0; i < 256; i += stride)
      for (int j = 0; j < 256; ++j) {
        const float x = line.base + static_cast<float>(i) * line.step,
                    y = line.base + static_cast<float>(j) * line.step;
        const row p = {x, y, 0}, across = {line.q, line.q, 0, line.r, line.r, 0, line.q, line.q, 8};
        const row within = {-line.r, -line.r, 0, line.r, line.r, 0, line.r, -line.r, 0};
        const int truth = (i > j) - (i < j), found = side.truth(across.data(), p.data());
        zeros += found == 0;
        wrong += (found == 0) != (i == j);
        const outcome o = check_case(side, {across, p}, random);
        wrong += o.wrong != 0;
        for (std::size_t r = 0; r < bounded; ++r)
          unsure[r] += static_cast<int>(o.unsure >> r & 1);
        // The line is an edge of the triangle: on it and on one side is a hit.
        const outcome edge = check_case(turn, {p, within}, random);
        wrong += edge.wrong != 0 || edge.hit != (truth >= 0);
        naive32 += std::abs(naive_turn<float>(x, y, line.q, line.r)) != std::abs(truth);
        naive64 += std::abs(naive_turn<double>(x, y, line.q, line.r)) != std::abs(truth);
      }
    const int cases = 256 * 256 / stride;
    INFO("naive fp32 wrong " << naive32 << ", naive fp64 wrong " << naive64 << ", unsure " << unsure[fp32] << ' '
                             << unsure[fp64] << ' ' << unsure[fp64x2] << " of " << cases);
    CHECK(zeros == 256 / stride);
    CHECK(wrong == 0);
    CHECK(naive32 > cases / 10);
    CHECK((version == 0 || naive64 > cases / 10));
    CHECK((version < 2 || unsure[fp64x2] > cases / 10));
  }
}

TEST_CASE("bites: a third of the tangent spheres is exactly tangent") {
  const subject &ball = subject_named("ball_ball"), &point = subject_named("side_sphere_point");
  random_numbers random(3);
  int zeros = 0;
  const int cases = effort(3000);
  for (int i = 0; i < cases; ++i) {
    const pair_of_rows p = tangent(shape::sphere, shape::point, random);
    zeros += point.truth(p.a.data(), p.b.data()) == 0;
  }
  CHECK(zeros > cases / 4);
  CHECK(zeros < cases / 2);
  // r = k/64 along an axis, r = 3 k/64 along (2, -2, 1)/3, at offsets to 1e5: a ulp of a radius is the
  // answer.
  int wrong = 0;
  for (int i = 0; i < cases; ++i) {
    const auto k = static_cast<float>(random.integer(1, 64)), l = static_cast<float>(random.integer(1, 64));
    const bool oblique = random.one_in(2);
    const float along[3] = {oblique ? 2.0F : 1.0F, oblique ? -2.0F : 0.0F, oblique ? 1.0F : 0.0F};
    pair_of_rows p;
    for (int c = 0; c < 3; ++c) {
      const auto offset = static_cast<float>(random.integer(0, 100000));
      p.a.push_back(offset);
      p.b.push_back(offset + (k + l) * along[c] / 64);
    }
    p.a.push_back(k * (oblique ? 3.0F : 1.0F) / 64);
    p.b.push_back(l * (oblique ? 3.0F : 1.0F) / 64);
    const float radius = p.b[3];
    for (const int step : {-1, 0, 1}) {
      p.b[3] = meetc::generated_test::stepped(radius, step);
      const outcome o = check_case(ball, p, random);
      wrong += o.wrong != 0 || o.hit != (step >= 0);
    }
  }
  CHECK(wrong == 0);
}
