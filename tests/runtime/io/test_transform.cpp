#include "fixture.hpp"

#include "meet/io/text/number.hpp"

#include <cmath>
#include <limits>

using namespace fixture;
using meetc::io::transform;

TEST_CASE("scale, matrix, translation, in this order, rounded once", "[transform]") {
  transform t;
  t.scale = 3;
  t.matrix = {1, 2, 3, 4, 0, 1, 0, 0, 0, 0, -1, 5};
  t.translate = {10, 20, 30};
  const auto p = t.point({1, 2, 3});
  CHECK(p[0] == ((3 + 2.0 * 6) + 3 * 9.0) + 4 + 10);
  CHECK(p[1] == 26);
  CHECK(p[2] == 26);
}

TEST_CASE("the matrix is summed from the left without fused multiply-add", "[transform]") {
  transform t;
  const double e = 0x1p-53;
  t.matrix = {1, 1, 1, 0, 1 + 0x1p-30, 1, 0, 0, 0, 0, 1, 0};
  const auto p = t.point({1, e, e});
  CHECK(p[0] == 1.0); // (1 + e) + e is 1, while 1 + (e + e) is not
  const double x = 1 + 0x1p-30;
  const auto q = t.point({x, -(1 + 0x1p-29), 0});
  CHECK(q[1] == 0.0); // a fused multiply-add would leave 2^-60
}

TEST_CASE("decimals are rounded to float32 before they are moved, and an identity changes no bit", "[transform]") {
  transform t;
  t.scale = 1;
  t.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  t.translate = {0, 0, 0};
  // Beside a boundary of float32, above and below, and where rounding to double and then to float32 goes wrong.
  for (const char *const number : {"1.000000059604644775390625000001", "1.00000005960464477540",
                                   "1.0000000596046447753", "0.1", "16777217.25", "1e-45", "3.4028235e38", "7e-46"}) {
    const std::string text = std::string("x,y,z,r\n") + number + ",0,0,1\n";
    INFO(number);
    CHECK(read("a.csv", text, t).data == read("a.csv", text).data);
    const std::string mesh = std::string("v ") + number + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    CHECK(read("a.obj", mesh, t).data == read("a.obj", mesh).data);
  }
  transform left;
  left.translate = {-16777216, 0, 0};
  CHECK(read("a.csv", "x,y,z,r\n16777217.25,0,0,0.1\n", left).data[0] == 2.0F); // read as 16777218
  // In double, rounded once: 0.1F three times.
  transform three;
  three.scale = 3;
  CHECK(read("a.csv", "x,y,z,r\n0.1,0,0,0\n", three).data[0] == static_cast<float>(3 * static_cast<double>(0.1F)));
}

TEST_CASE("lengths take the scale, and a similarity's", "[transform]") {
  transform t;
  t.scale = 2;
  t.translate = {1, 2, 3};
  const auto set = read("a.csv", "x,y,z,r\n1,1,1,0.25\n", t);
  CHECK(set.data == std::vector<float>{3, 4, 5, 0.5F});
  t.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  CHECK(read("a.csv", "x,y,z,r\n1,1,1,0.25\n", t).data == std::vector<float>{3, 4, 5, 0.5F});
  t.matrix = {0, -3, 0, 0, 3, 0, 0, 0, 0, 0, 3, 1};
  CHECK(read("a.csv", "x,y,z,r\n1,2,1,0.25\n", t).data == std::vector<float>{-11, 8, 10, 1.5F});
  t.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1.0000001, 0};
  CHECK_THAT(complaint("a.csv", "x,y,z,r\n1,1,1,0.25\n", t), contains("a.csv: --matrix-b is no similarity"));
  t.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  CHECK(read("a.csv", "x0,y0,z0,x1,y1,z1\n1,2,3,4,5,6\n", t).data == std::vector<float>{3, 6, 9, 9, 12, 15});
}

TEST_CASE("a field of another role cannot be moved", "[transform]") {
  transform t;
  CHECK(read("h.csv", "nx,ny,nz,d\n0,0,1,2\n", t).elements == 1);
  t.scale = 1;
  CHECK_THAT(complaint("h.csv", "nx,ny,nz,d\n0,0,1,2\n", t), contains("h.csv: a transform cannot move half_spaces"));
}

TEST_CASE("a transform is checked", "[transform]") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double s : {0.0, -1.0, inf, std::nan("")}) {
    transform t;
    t.scale = s;
    CHECK_THROWS_WITH(t.check(), contains("--scale-b: the scale is ") && contains("must be finite and above 0"));
    CHECK_THROWS_AS(meetc::io::read(put("a.csv", "x,y,z,r\n"), kinds, t), meetc::io::error);
  }
  transform m;
  m.matrix = {1, 0, 0, 0, 0, inf, 0, 0, 0, 0, 1, 0};
  CHECK_THROWS_WITH(m.check(), contains("--matrix-b: the matrix holds inf"));
  transform v;
  v.translate = {0, -inf, 0};
  CHECK_THROWS_WITH(v.check(), contains("--translate-b: the translation holds -inf"));
}

TEST_CASE("overflow by a transform names the place", "[transform]") {
  transform t;
  t.scale = 1e30;
  CHECK(complaint("a.csv", "x,y,z,r\n1,1,1,1\n1,1e20,1,1\n", t) ==
        "a.csv:3: sphere 1: y is inf, not finite in float32 after --scale-b (read as 1e+20)");
  t.side = 'a';
  CHECK(complaint("a.csv", "x,y,z,r\n1,1,1,1e20\n", t) ==
        "a.csv:2: sphere 0: r is inf, not finite in float32 after --scale-a (read as 1e+20)");
  CHECK(complaint("a.stl",
                  "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 0 0 1e9\nvertex 0 0 0\nendloop\n"
                  "endfacet\nendsolid\n",
                  t) ==
        "a.stl:5: facet 0: corner 1: z is inf, not finite in float32 after --scale-a (read as 1000000000)");
  CHECK(complaint("a.off", "OFF\n1 0 0\n#\n0 1e9 0\n", t) ==
        "a.off:4: vertex 0: y is inf, not finite in float32 after --scale-a (read as 1000000000)");
  t.side = 'b';
  CHECK(complaint("a.csv", "x,y,z,r\n1,1e39,1,1\n") ==
        "a.csv:2: sphere 0: y is inf, not finite in float32 (read as 1e+39)");
  t.scale = 1e300;
  CHECK_THAT(complaint("a.csv", "x,y,z,r\n1,1,-1e20,1\n", t), contains("a.csv:2: sphere 0: "));
  CHECK_THAT(complaint("m.obj", "v 0 0 0\nv 0 0 -1e9\np 1\n", t),
             contains("m.obj:2: vertex 1: z is -inf, not finite in float32 after --scale-b (read as -1000000000)"));
}

TEST_CASE("which matrices are similarities, and their scale", "[transform]") {
  using matrix = std::array<double, 12>;
  using meetc::io::similarity_scale;
  const auto scaled = [](matrix m, double s) {
    for (double &v : m)
      v *= s;
    return m;
  };
  const matrix identity{1, 0, 0, 9, 0, 1, 0, -9, 0, 0, 1, 1e300};
  CHECK(similarity_scale(identity) == 1.0);
  CHECK(similarity_scale({0, 0, -2, 0, 2, 0, 0, 0, 0, 2, 0, 0}) == 2.0); // a permutation, mirrored
  CHECK(similarity_scale({0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3}) == std::nullopt);
  // Rotations about all axes, computed in double and multiplied, which are off by some units in the last place.
  std::size_t seen = 0;
  for (double x = 0.1; x < 6.3; x += 0.37)
    for (double y = 0.2; y < 6.3; y += 0.41) {
      const double a = std::cos(x), b = std::sin(x), c = std::cos(y), d = std::sin(y);
      const matrix turn{c * a, -c * b, d, 1, b, a, 0, 2, -d * a, d * b, c, 3};
      for (const double s : {1.0, 1e-3, 1e300, 1e-300, 0x1p-1060}) {
        const std::optional<double> k = similarity_scale(scaled(turn, s));
        // Near the least double the entries themselves are coarse, so this is no longer a similarity.
        REQUIRE(k.has_value() == (s > 0x1p-1000));
        if (k)
          CHECK(std::abs(*k / s - 1) < 0x1p-50);
        ++seen;
      }
      // One entry that is off by 2^-40 of the length is noticed wherever it is, and so are two swapped lengths of
      // columns.
      for (std::size_t i = 0; i < 12; ++i) {
        matrix off = turn;
        off[i] += 0x1p-40;
        CHECK(similarity_scale(off).has_value() == (i % 4 == 3));
      }
    }
  CHECK(seen > 1000);
  CHECK(similarity_scale({1, 0x1p-40, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}) == std::nullopt); // sheared
  CHECK(similarity_scale({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}) == std::nullopt);       // flattened
  // Six decimals are too few for a similarity.
  CHECK(similarity_scale({0.866025, -0.5, 0, 0, 0.5, 0.866025, 0, 0, 0, 0, 1, 0}) == std::nullopt);
  CHECK(similarity_scale({0.8660254037844386, -0.5, 0, 0, 0.5, 0.8660254037844386, 0, 0, 0, 0, 1, 0}).has_value());
}
