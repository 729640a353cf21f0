// In which order a segment meets triangles: the emitted order against exact points of entry, found in rational numbers.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"

#include <array>
#include <cga/cga_runtime.hpp>
#include <cmath>
#include <gmpxx.h>
#include <optional>
#include <random>
#include <string_view>
#include <vector>

using meetc::generated_test::effort;

namespace {

using point = std::array<mpq_class, 3>;
using segment_row = std::array<float, 6>;
using triangle_row = std::array<float, 9>;

point at(const float *row) {
  return {mpq_class(row[0]), mpq_class(row[1]), mpq_class(row[2])};
}
point operator-(const point &x, const point &y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
mpq_class dot(const point &x, const point &y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
point cross(const point &x, const point &y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
bool is_zero(const point &x) {
  return x[0] == 0 && x[1] == 0 && x[2] == 0;
}

bool on_edge(const point &x, const point &u, const point &v) {
  const point d = v - u, e = x - u;
  return is_zero(cross(d, e)) && dot(e, d) >= 0 && dot(e, d) <= dot(d, d) && (!is_zero(d) || is_zero(e));
}
bool in_triangle(const point &x, const std::array<point, 3> &t) {
  const point n = cross(t[1] - t[0], t[2] - t[0]);
  bool on = false, in = dot(n, x - t[0]) == 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const point &u = t[i], &v = t[(i + 1) % 3];
    on = on || on_edge(x, u, v);
    in = in && dot(cross(v - u, x - u), n) >= 0;
  }
  return is_zero(n) ? on : in;
}

// The least number in [0, 1] at which the segment's point is in the triangle; none where the segment is a point or meets
// nothing. The point of entry is an end of the segment, on the triangle's plane, on an edge's line, or a corner.
std::optional<mpq_class> entry(const segment_row &s, const triangle_row &row) {
  const point p = at(s.data()), d = at(s.data() + 3) - p;
  const std::array<point, 3> t{at(row.data()), at(row.data() + 3), at(row.data() + 6)};
  std::vector<mpq_class> candidates{0, 1};
  const auto ratio = [&](const mpq_class &x, const mpq_class &y) {
    if (y != 0)
      candidates.emplace_back(x / y);
  };
  const point n = cross(t[1] - t[0], t[2] - t[0]);
  ratio(dot(n, t[0] - p), dot(n, d));
  for (std::size_t i = 0; i < 3; ++i) {
    const point e = t[(i + 1) % 3] - t[i], from = t[i] - p, numerators = cross(from, e), denominators = cross(d, e);
    for (std::size_t k = 0; k < 3; ++k) {
      ratio(numerators[k], denominators[k]);
      ratio(from[k], d[k]);
    }
  }
  std::optional<mpq_class> least;
  for (const mpq_class &c : candidates) {
    if (c < 0 || c > 1 || (least && *least <= c) || is_zero(d))
      continue;
    const point x{p[0] + c * d[0], p[1] + c * d[1], p[2] + c * d[2]};
    if (in_triangle(x, t))
      least = c;
  }
  return least;
}

const meetc::predicate_info &segments_and_triangles(const meetc::catalogue &all) {
  for (int i = 0; i < all.predicate_count; ++i)
    if (std::string_view(all.predicates[i].name) == "segment_triangle")
      return all.predicates[i];
  throw std::logic_error("no predicate segment_triangle");
}
std::vector<const meetc::catalogue *> tables() {
  std::vector<const meetc::catalogue *> out;
  for (const auto set :
       {meetc::instruction_set::baseline, meetc::instruction_set::avx2, meetc::instruction_set::avx512})
    if (const meetc::catalogue *c = cga::catalogue_for(set))
      out.push_back(c);
  return out;
}

int sign_of(const mpq_class &x) {
  return (x > 0) - (x < 0);
}

// A number of a family: whole ones, which make all degenerate cases; the same scaled to where products underflow or overflow;
// with some last bits changed; of all sizes at once.
float number(int family, std::mt19937 &g) {
  const auto whole = static_cast<float>(static_cast<int>(g() % 5) - 2);
  switch (family) {
  case 1:
    return std::ldexp(whole, -149);
  case 2:
    return std::ldexp(whole, 126);
  case 3:
    return g() % 3 == 0 ? std::nextafter(whole, 9.0F) : whole;
  case 4:
    return std::ldexp(whole, static_cast<int>(g() % 254) - 127);
  default:
    return whole;
  }
}

} // namespace

TEST_CASE("first met: the order of hits is that of their exact points of entry") {
  std::mt19937 g(5);
  int compared = 0, before = 0, together = 0, along = 0;
  const int wanted = effort(4000) / 5; // of each family
  for (int family = 0; family < 5; ++family)
    for (int tries = 0, done = 0; done < wanted && tries < 2000 * wanted; ++tries) {
      segment_row s;
      std::array<triangle_row, 2> t;
      // Whole planes are often common to all, so that a segment lies along its triangles.
      const bool flat = g() % 2 == 0;
      const std::size_t axis = g() % 3;
      const float height = number(family, g);
      const auto fill = [&](auto &row) {
        for (std::size_t i = 0; i < row.size(); ++i)
          row[i] = flat && i % 3 == axis ? height : number(family, g);
      };
      fill(s), fill(t[0]), fill(t[1]);
      const std::optional<mpq_class> x = entry(s, t[0]), y = x ? entry(s, t[1]) : std::nullopt;
      if (!x || !y)
        continue;
      ++done, ++compared, along += flat;
      const int want = sign_of(*x - *y);
      before += want != 0, together += want == 0;
      for (const meetc::catalogue *all : tables()) {
        const meetc::predicate_info &p = segments_and_triangles(*all);
        INFO("family " << family << ", " << name_of(all->compiled_for));
        CHECK(p.first_met(s.data(), t[0].data(), t[1].data()) == want);
        CHECK(p.first_met(s.data(), t[1].data(), t[0].data()) == -want);
      }
    }
  CHECK(compared == 5 * wanted);
  CHECK(before > compared / 5);
  CHECK(together > compared / 10);
  CHECK(along > compared / 5);
}

TEST_CASE("first met: the order is total, of triangles that are not met as well") {
  std::mt19937 g(6);
  const meetc::predicate_info &p = segments_and_triangles(cga::catalogue());
  for (int n = 0; n < effort(3000); ++n) {
    segment_row s;
    std::array<triangle_row, 3> t;
    const int family = n % 5;
    for (float &x : s)
      x = number(family, g);
    for (triangle_row &row : t)
      for (std::size_t i = 0; i < row.size(); ++i)
        row[i] = n % 2 == 0 && i % 3 == 0 ? s[0] : number(family, g);
    if (n % 4 == 0)
      s[3] = s[0]; // in the plane of the triangles
    const auto order = [&](std::size_t i, std::size_t k) { return p.first_met(s.data(), t[i].data(), t[k].data()); };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      CHECK(order(i, i) == 0);
      CHECK(order(i, j) == -order(j, i));
      if (order(i, j) <= 0 && order(j, k) <= 0) {
        CHECK(order(i, k) == std::min(order(i, j), order(j, k)));
      }
    }
  }
}

TEST_CASE("first met: a segment that is a point meets all at once") {
  const meetc::predicate_info &p = segments_and_triangles(cga::catalogue());
  const segment_row s{1, 1, 1, 1, 1, 1};
  const triangle_row t{1, 1, 1, 2, 1, 1, 1, 2, 1}, u{0, 0, 0, 2, 2, 2, 2, 2, 2};
  CHECK(p.first_met(s.data(), t.data(), u.data()) == 0);
}

TEST_CASE("first met: only the predicate that the spec names has an order") {
  const meetc::catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i)
    CHECK((all.predicates[i].first_met != nullptr) == (std::string_view(all.predicates[i].name) == "segment_triangle"));
}
