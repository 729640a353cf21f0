// The affine filter: its number types, its layouts, and that it rules out no pair that touches.
#include "tests/catch.hpp"

#include <meetc/table_functions.hpp>

#include <cga/segment_triangle.hpp>
#include <cga/triangle_triangle.hpp>

#include <cga/cga_runtime.hpp>
#include <cga/detail/triangle_triangle_rest.hpp>

#include "core/affine_pairs.hpp"
#include "core/find.hpp"

#include <algorithm>
#include <array>
#include <cfenv>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace meetc;

namespace {

using triangles = affine_kernel<cga::triangle_triangle>;
using segments = affine_kernel<cga::segment_triangle>;

using row = std::array<float, 9>;

float between(std::mt19937 &g, float lo, float hi) {
  return lo + (hi - lo) * static_cast<float>(g() >> 8) * 0x1p-24F;
}
row random_triangle(std::mt19937 &g, float place, float size) {
  row t{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float c = between(g, -place, place);
    for (std::size_t p = 0; p < 3; ++p)
      t[3 * p + k] = c + between(g, -size, size);
  }
  return t;
}
// A triangle that touches t in one corner, or nearly so: the corner is a point of t's plane, exact where t's coordinates
// are multiples of a large enough power of two.
row at_plane_of(const row &t, std::mt19937 &g, float size) {
  row r{};
  const auto i = static_cast<float>(g() % 5), j = static_cast<float>(g() % 4);
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = t[k] + (t[3 + k] - t[k]) * (i / 8) + (t[6 + k] - t[k]) * (j / 8);
    r[3 + k] = r[k] + between(g, 0, size), r[6 + k] = r[k] + between(g, 0, size);
  }
  return r;
}
std::vector<float> flat(const std::vector<row> &rows) {
  std::vector<float> out;
  for (const row &r : rows)
    out.insert(out.end(), r.begin(), r.end());
  return out;
}

struct scene {
  std::string name;
  std::vector<row> a, b;
};
std::vector<scene> scenes(std::size_t n) {
  std::mt19937 g(11);
  std::vector<scene> all;
  scene even{"even", {}, {}};
  for (std::size_t i = 0; i < n; ++i)
    even.a.push_back(random_triangle(g, 1, 0.2F)), even.b.push_back(random_triangle(g, 1, 0.05F));
  scene touching{"corners on planes", {}, {}}, far = touching, coplanar = touching;
  far.name = "corners on planes, far from the origin", coplanar.name = "in one oblique plane";
  for (std::size_t i = 0; i < n; ++i) {
    row t{};
    for (float &x : t)
      x = static_cast<float>(8 * (static_cast<int>(g() % 2000) - 1000));
    touching.a.push_back(t), touching.b.push_back(at_plane_of(t, g, 100));
    row moved = t;
    for (float &x : moved)
      x += 0x1p22F;
    far.a.push_back(moved), far.b.push_back(at_plane_of(moved, g, 1000));
    row flat_row{};
    for (std::size_t p = 0; p < 3; ++p) {
      const float x = between(g, -1, 1), y = between(g, -1, 1);
      flat_row[3 * p] = x, flat_row[3 * p + 1] = y, flat_row[3 * p + 2] = 0.3F * x - 0.7F * y;
    }
    (i % 2 ? coplanar.a : coplanar.b).push_back(flat_row);
  }
  all.insert(all.end(), {even, touching, far, coplanar});
  for (const int power : {-125, -100, 100, 115}) { // some coordinates are subnormal, and some nearly overflow
    for (const scene *s : {&even, &touching}) {
      scene scaled = *s;
      scaled.name += " * 2^" + std::to_string(power);
      for (std::vector<row> *rows : {&scaled.a, &scaled.b})
        for (row &r : *rows)
          for (float &x : r)
            x = std::ldexp(x, power - (s == &touching ? 13 : 0));
      all.push_back(std::move(scaled));
    }
  }
  scene mixed{"one huge among small ones", even.a, even.b};
  for (float &x : mixed.b[3])
    x *= 1e30F;
  for (float &x : mixed.a[5])
    x *= 1e-30F;
  // Two edges of a are parallel but for what a corner near the origin adds, so that its normal is little more than roundings.
  scene needles{"needles whose normals cancel", {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    row t{}, u{};
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = std::ldexp(between(g, -1, 1), -45);
      u[k] = t[3 + k] = between(g, -1, 1);
      t[6 + k] = 2 * t[3 + k];
      u[3 + k] = u[k] + between(g, -1, 1), u[6 + k] = u[3 + k] + between(g, -0.1F, 0.1F);
    }
    needles.a.push_back(t), needles.b.push_back(u);
  }
  all.push_back(needles);
  scene points{"without area", even.a, even.b};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      points.b[i][3 + k] = points.b[i][k];
      if (i % 2)
        points.b[i][6 + k] = points.b[i][k], points.a[i][3 + k] = points.a[i][k];
    }
  all.push_back(mixed), all.push_back(points);
  return all;
}

struct outcome {
  std::size_t wrong = 0, ruled_out = 0, pairs = 0, hits = 0;
};
// The rows of a: triangles, or their first edges.
template <class P> std::vector<float> rows_a(const scene &s) {
  std::vector<float> out;
  for (const row &r : s.a)
    out.insert(out.end(), r.begin(), r.begin() + P::inputs_a);
  return out;
}
// `left(i, near)` writes the tiles that row i of a leaves, as affine_filter::near. The judge decides by integers alone.
template <class P, class Left> outcome compare(const scene &s, const Left &left) {
  const std::vector<float> a = rows_a<P>(s), b = flat(s.b);
  std::vector<near_tile> near(s.b.size() / filter_tile + 1);
  outcome o;
  for (std::size_t i = 0; i < s.a.size(); ++i) {
    std::vector<bool> kept(s.b.size() + filter_tile);
    for (const near_tile *t = near.data(), *const end = left(i, near.data()); t < end; ++t)
      for (std::size_t k = 0; k < filter_tile; ++k)
        kept[t->index * filter_tile + k] = t->elements >> k & 1;
    for (std::size_t j = 0; j < s.b.size(); ++j) {
      const bool hit = decide<P>(integer_signs<P>(a.data() + i * P::inputs_a, b.data() + j * P::inputs_b));
      o.hits += hit;
      o.ruled_out += !kept[j];
      o.wrong += !kept[j] && hit;
    }
  }
  o.pairs = s.a.size() * s.b.size();
  return o;
}
field_ranges ranges_of(const std::vector<float> &rows, std::size_t fields) {
  field_ranges r{};
  for (std::size_t k = 0; k < fields; ++k)
    r.lo[k] = HUGE_VAL, r.hi[k] = -HUGE_VAL;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto x = static_cast<double>(rows[i]);
    r.lo[i % fields] = std::min(r.lo[i % fields], x), r.hi[i % fields] = std::max(r.hi[i % fields], x);
  }
  return r;
}
// By this compilation's kernel, with other factors in its bound.
template <class P, int Bound, int Errors> outcome by_kernel(const scene &s) {
  using kernel = affine_kernel<P, Bound, Errors>;
  const std::vector<float> a = rows_a<P>(s), b = flat(s.b);
  const field_ranges of_a = ranges_of(a, P::inputs_a), of_b = ranges_of(b, P::inputs_b);
  std::vector<float> singles(s.a.size() * kernel::single_floats), tiles((s.b.size() + 16) * kernel::tile_floats);
  REQUIRE(kernel::singles(of_a, of_b, a.data(), s.a.size(), singles.data()));
  REQUIRE(kernel::tiles(of_a, of_b, b.data(), s.b.size(), tiles.data()));
  return compare<P>(s, [&](std::size_t i, near_tile *out) {
    return affine_finder<P, kernel>(singles.data() + i * kernel::single_floats, tiles.data(), out)
        .look((s.b.size() + filter_tile - 1) / filter_tile);
  });
}
// By the functions of a catalogue.
template <class P> outcome by_table(const catalogue &of, const char *name, const scene &s) {
  const std::vector<float> a = rows_a<P>(s), b = flat(s.b);
  const affine_pairs filter(find_predicate(of, name), a.data(), s.a.size(), b.data(), s.b.size(), 2);
  return compare<P>(s, [&](std::size_t i, near_tile *out) {
    return filter.near(i, 0, (s.b.size() + filter_tile - 1) / filter_tile, out);
  });
}

} // namespace

TEST_CASE("affine forms over a finite field") {
  using form = field_form<2>;
  form x, y;
  x.c[0] = y.c[1] = 1;
  const form f = (x + form(3)) * form(-2) - form(5) * y;
  CHECK(f.affine);
  CHECK(f.c[0] == field_prime - 2);
  CHECK(f.c[1] == field_prime - 5);
  CHECK(f.c[2] == field_prime - 6);
  CHECK_FALSE((x * y).affine);
  CHECK_FALSE((x * x + y).affine);
  CHECK((x - x).is_constant());
}

TEST_CASE("which signs are affine is found in the emitted programs") {
  for (const auto &[signs, coefficients, columns] :
       {std::array{triangles::in_a.signs, triangles::in_a.coefficients, triangles::in_a.columns},
        std::array{triangles::in_b.signs, triangles::in_b.coefficients, triangles::in_b.columns}}) {
    CHECK(signs == 3);        // the sides of three corners
    CHECK(coefficients == 4); // of one plane
    CHECK(columns == 9);
  }
  CHECK(triangles::by_sides);
  CHECK(segments::in_a.signs == 2);
  CHECK(segments::in_a.coefficients == 4);
  CHECK(segments::in_a.columns == 6);
  CHECK(segments::in_b.signs == 0); // degree 3 in the triangle
  const catalogue &all = cga::catalogue();
  CHECK(find_predicate(all, "triangle_triangle").affine);
  CHECK(find_predicate(all, "segment_triangle").affine);
  CHECK_FALSE(find_predicate(all, "ball_ball").affine); // it has no reject stage
}

TEST_CASE("errors of tracked coefficients hold the true ones") {
  std::mt19937 g(5);
  double largest = 0;
  int too_little = 0;
  for (int n = 0; n < 20'000; ++n) {
    // Integers for which 2^53 is far too little, so that products round.
    std::int64_t x[6];
    for (std::int64_t &v : x)
      v = (static_cast<std::int64_t>(g()) << 20 | static_cast<std::int64_t>(g() >> 12)) - (std::int64_t{1} << 51);
    tracked t[6];
    for (int k = 0; k < 6; ++k)
      t[k] = tracked(static_cast<double>(x[k]));
    const auto volume = [](const auto *y) { return (y[0] - y[1]) * (y[2] - y[3]) - (y[4] + y[5]) * y[0]; };
    const tracked found = volume(t);
    tracked_number<double, -57> less[6]; // a 64th of the roundings
    for (int k = 0; k < 6; ++k)
      less[k] = tracked_number<double, -57>(static_cast<double>(x[k]));
    const int128 exact = static_cast<int128>(x[0] - x[1]) * (x[2] - x[3]) - static_cast<int128>(x[4] + x[5]) * x[0];
    const int128 off = exact - static_cast<int128>(found.v);
    const auto error = static_cast<double>(off < 0 ? -off : off);
    REQUIRE(error <= found.e);
    too_little += error > volume(less).e;
    largest = std::max(largest, error / found.e);
  }
  CHECK(largest > 0.05); // and are of their size
  CHECK(too_little > 0);
  CHECK(tracked(5'000'000'029).v == 5'000'000'029.0);
  const lane_mask same = tracked_number<wide_lanes>(5'000'000'029).v == wide_lanes(5'000'000'029.0);
  CHECK((same & 1) != 0);
  tracked_form<1> y, z;
  y.c[0] = tracked(3.0), y.c[1] = tracked(1.0), z.c[0] = tracked(-2.0), z.c[1] = tracked(5.0);
  const tracked_form<1> p = y * z; // (3 y + 1) (5 - 2 y): the square of y is an error of at most 6
  CHECK(p.c[0].v == 13);
  CHECK(p.c[1].v == 5);
  CHECK(p.c[1].e >= 6);
}

// Triangles of whole numbers, so large that doubles round, of which the second's corners lie near the first's plane.
TEST_CASE("errors of counted roundings hold the true ones, and a 1024th of them does not") {
  using P = cga::triangle_triangle;
  using stage = P::reject_stage;
  std::mt19937_64 g(6);
  double largest = 0;
  int too_little = 0;
  for (int n = 0; n < 20'000; ++n) {
    std::int64_t x[18];
    for (std::int64_t &v : x)
      v = static_cast<std::int64_t>(g() >> 25) - (std::int64_t{1} << 38);
    for (std::size_t k = 9; k < 18; ++k) { // a point of the plane, rounded to whole numbers
      const std::int64_t i = static_cast<std::int64_t>(g() % 8), j = static_cast<std::int64_t>(g() % 8);
      x[k] = x[k % 3] + (x[3 + k % 3] - x[k % 3]) * i / 8 + (x[6 + k % 3] - x[k % 3]) * j / 8;
    }
    int128 whole_a[9], whole_b[9], truth[stage::atoms];
    wide_lanes a[9], b[9], v[stage::atoms], error[stage::atoms], less[stage::atoms];
    for (std::size_t k = 0; k < 9; ++k) {
      whole_a[k] = x[k], whole_b[k] = x[9 + k];
      a[k] = wide_lanes(static_cast<double>(x[k])), b[k] = wide_lanes(static_cast<double>(x[9 + k]));
    }
    stage_values<stage>(whole_a, whole_b, truth);
    stage_values<stage>(a, b, v);
    const wide_lanes extent = extent_of<P>(a, b);
    power_errors<P, stage, counted_roundings<P>>(extent, error);
    power_errors<P, stage, counted_roundings<P, -61>>(extent, less);
    for (int i = 0; i < stage::atoms; ++i) {
      double found = 0, bound = 0, small = 0;
      std::memcpy(&found, &v[i], sizeof found);
      std::memcpy(&bound, &error[i], sizeof bound);
      std::memcpy(&small, &less[i], sizeof small);
      const int128 off = truth[i] - static_cast<int128>(found);
      const auto is_off = static_cast<double>(off < 0 ? -off : off);
      REQUIRE(is_off <= bound);
      too_little += is_off > small;
      largest = std::max(largest, is_off / bound);
    }
  }
  INFO(largest);
  CHECK(too_little > 0);
  constexpr rounding_counts<P, stage> counts; // a product of three differences, and two sums of such
  CHECK(counts.of[0] >= 5);
  CHECK(counts.of[0] < 20);
}

TEST_CASE("margins prove what sets of signs prove") {
  std::mt19937 g(7);
  const auto agree = [](truth_margin m, truth t, int lane) {
    if (proved(m) >> lane & 1)
      CHECK_FALSE(can_be_false(t));
    return (proved(m) >> lane & 1) != 0;
  };
  int proofs = 0;
  for (int n = 0; n < 2000; ++n) {
    float v[4][lane_count];
    margin s[4];
    for (int i = 0; i < 4; ++i) {
      for (float &x : v[i])
        x = between(g, -3, 3);
      s[i] = {lanes::from(v[i]), g() % 8 != 0, g() % 2 != 0};
    }
    for (int lane = 0; lane < lane_count; ++lane) {
      sign_set of[4];
      for (int i = 0; i < 4; ++i) {
        const float x = s[i].turned ? -v[i][lane] : v[i][lane];
        of[i] =
            !s[i].known || std::fabs(x) <= 1 ? sign_set::all() : sign_set::of(x > 0 ? sign::positive : sign::negative);
      }
      proofs += agree(both(above_zero(s[0]), below_zero(s[1]), above_zero(s[2])),
                      both(above_zero(of[0]), below_zero(of[1]), above_zero(of[2])), lane);
      proofs +=
          agree(either(both(above_zero(s[0]), above_zero(s[1])), both(below_zero(s[2]), below_zero(s[3]))),
                either(both(above_zero(of[0]), above_zero(of[1])), both(below_zero(of[2]), below_zero(of[3]))), lane);
      proofs += agree(above_zero(s[0] * s[1]), above_zero(of[0] * of[1]), lane);
      proofs += agree(below_zero(s[0] * -s[1]), below_zero(of[0] * -of[1]), lane);
      proofs += agree(either(at_most_zero(s[0]), at_least_zero(s[1])),
                      either(at_most_zero(of[0]), at_least_zero(of[1])), lane);
      proofs +=
          agree(both(not_zero(s[0]), above_zero(square(s[1]))), both(not_zero(of[0]), above_zero(square(of[1]))), lane);
      CHECK_FALSE(agree(is_zero(s[0]), is_zero(of[0]), lane));
      CHECK_FALSE(agree(negate(above_zero(s[0])), negate(above_zero(of[0])), lane));
      proofs += agree(both(above_zero(s[0]), true), both(above_zero(of[0]), true), lane);
      CHECK_FALSE(agree(both(above_zero(s[0]), false), both(above_zero(of[0]), false), lane));
    }
  }
  CHECK(proofs > 5000);
}

TEST_CASE("the affine filter rules out no pair that touches, on each instruction set") {
  for (const instruction_set set : {instruction_set::baseline, instruction_set::avx2, instruction_set::avx512}) {
    const catalogue *of = cga::catalogue_for(set);
    if (!of)
      continue;
    for (const scene &s : scenes(90)) {
      CAPTURE(name_of(set), s.name);
      const outcome t = by_table<cga::triangle_triangle>(*of, "triangle_triangle", s),
                    e = by_table<cga::segment_triangle>(*of, "segment_triangle", s);
      CHECK(t.wrong == 0);
      CHECK(e.wrong == 0);
      if (s.name == "even" || s.name == "corners on planes") {
        CHECK(10 * t.ruled_out > 8 * t.pairs);
        CHECK(10 * e.ruled_out > 4 * e.pairs);
      }
      if (s.name.starts_with("corners on planes"))
        CHECK(t.hits > 60);
    }
  }
}

TEST_CASE("less than what a sum's roundings can be is wrong, and so is leaving out the coefficients' errors") {
  outcome right, less, without;
  const auto add = [](outcome &to, const outcome &o) { to.wrong += o.wrong; };
  for (const scene &s : scenes(200)) {
    add(right, by_kernel<cga::triangle_triangle, -18, 2>(s));
    add(less, by_kernel<cga::triangle_triangle, -26, 2>(s));
    add(without, by_kernel<cga::triangle_triangle, -18, 0>(s));
  }
  CHECK(right.wrong == 0);
  CHECK(less.wrong > 0);
  CHECK(without.wrong > 0);
}

TEST_CASE("rows out of their ranges, numbers that are not finite and other environments rule out nothing") {
  const scene s = scenes(20).front();
  const std::vector<float> a = rows_a<cga::triangle_triangle>(s);
  field_ranges narrow{};
  for (std::size_t k = 0; k < 9; ++k)
    narrow.lo[k] = -0.01, narrow.hi[k] = 0.01;
  const field_ranges right = ranges_of(a, 9);
  std::vector<float> out((s.a.size() + 16) * triangles::tile_floats);
  CHECK_FALSE(triangles::singles(narrow, right, a.data(), s.a.size(), out.data()));
  CHECK_FALSE(triangles::tiles(right, narrow, a.data(), s.a.size(), out.data()));
  CHECK(triangles::singles(right, right, a.data(), s.a.size(), out.data()));
  std::fesetround(FE_UPWARD);
  const bool singles = triangles::singles(right, right, a.data(), s.a.size(), out.data()),
             tiles = triangles::tiles(right, right, a.data(), s.a.size(), out.data());
  std::fesetround(FE_TONEAREST);
  CHECK_FALSE(singles);
  CHECK_FALSE(tiles);
  for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    std::vector<float> b = a;
    b[13] = bad;
    const affine_pairs filter(find_predicate(cga::catalogue(), "triangle_triangle"), a.data(), s.a.size(), b.data(),
                              s.a.size(), 1);
    near_tile near[2];
    REQUIRE(filter.near(0, 0, 2, near) == near + 2);
    CHECK(near[0].elements == 0xffff);
    CHECK(near[1].elements == 0xffff);
  }
}
