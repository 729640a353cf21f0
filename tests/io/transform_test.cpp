#include "fixture.hpp"

#include "io/number.hpp"

#include <cmath>
#include <limits>

using namespace fixture;
using meet::io::transform;

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

TEST_CASE("with a transform decimals are read as double", "[transform]") {
  transform t;
  t.scale = 1;
  const std::string text = "x,y,z,r\n1.000000059604644775390625000001,0,0,1\n";
  CHECK(read("a.csv", text).data[0] == 0x1.000002p0F);
  CHECK(read("a.csv", text, t).data[0] == 1.0F);
  t.scale.reset();
  t.translate = {-16777216, 0, 0};
  CHECK(read("a.csv", "x,y,z,r\n16777217.25,0,0,0.1\n", t).data[0] == 1.25F);
}

TEST_CASE("lengths take the scale only", "[transform]") {
  transform t;
  t.scale = 2;
  t.translate = {1, 2, 3};
  const auto set = read("a.csv", "x,y,z,r\n1,1,1,0.25\n", t);
  CHECK(set.data == std::vector<float>{3, 4, 5, 0.5F});
  t.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  CHECK(complaint("a.csv", "x,y,z,r\n1,1,1,0.25\n", t) ==
        "a.csv: a matrix cannot move spheres: their radius has no meaning under it; use --scale-b and "
        "--translate-b");
  CHECK(read("a.csv", "x0,y0,z0,x1,y1,z1\n1,2,3,4,5,6\n", t).data == std::vector<float>{3, 6, 9, 9, 12, 15});
}

TEST_CASE("a field of another role cannot be moved", "[transform]") {
  transform t;
  CHECK(read("h.csv", "nx,ny,nz,d\n0,0,1,2\n", t).elements == 1);
  t.scale = 1;
  CHECK_THAT(complaint("h.csv", "nx,ny,nz,d\n0,0,1,2\n", t),
             contains("h.csv: a transform cannot move half_spaces"));
}

TEST_CASE("a transform is checked", "[transform]") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double s : {0.0, -1.0, inf, std::nan("")}) {
    transform t;
    t.scale = s;
    CHECK_THROWS_WITH(t.check(), contains("the scale is ") && contains("must be finite and above 0"));
    CHECK_THROWS_AS(meet::io::read(put("a.csv", "x,y,z,r\n"), kinds, t), meet::io::error);
  }
  transform m;
  m.matrix = {1, 0, 0, 0, 0, inf, 0, 0, 0, 0, 1, 0};
  CHECK_THROWS_WITH(m.check(), contains("the matrix holds inf"));
  transform v;
  v.translate = {0, -inf, 0};
  CHECK_THROWS_WITH(v.check(), contains("the translation holds -inf"));
}

TEST_CASE("overflow by a transform names the place", "[transform]") {
  transform t;
  t.scale = 1e30;
  CHECK(complaint("a.csv", "x,y,z,r\n1,1,1,1\n1,1e20,1,1\n", t) ==
        "a.csv:3: sphere 1: y is inf, not finite in float32 (read as 1e+20)");
  t.scale = 1e300;
  CHECK_THAT(complaint("a.csv", "x,y,z,r\n1,1,-1e200,1\n", t), contains("a.csv:2: sphere 0: "));
  CHECK_THAT(complaint("m.obj", "v 0 0 0\nv 0 0 -1e9\n", t),
             contains("m.obj:2: vertex 1: z is -inf, not finite in float32 (read as -1000000000"));
}
