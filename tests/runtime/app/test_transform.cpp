// How B is moved: float32 numbers in double, by scale, matrix and translation, rounded once.
#include "fixture.hpp"

using namespace fixture;

namespace {

// Whether the sphere B, after this move, still touches the expected one. With surfaces, a wrong radius about the same
// centre does not.
bool becomes(const std::string &b, const std::vector<std::string> &how, const std::string &expected) {
  put("b.csv", fmt::format("x,y,z,r\n{}\n", b));
  put("expected.csv", fmt::format("x,y,z,r\n{}\n", expected));
  std::vector<std::string> arguments{"expected.csv", "b.csv", "--mode", "surface"};
  arguments.insert(arguments.end(), how.begin(), how.end());
  return answer(arguments)["pairs"] == 1;
}
// Whether the point B, after this move, is exactly the expected one.
bool point_becomes(const std::string &b, const std::vector<std::string> &how, const std::string &expected) {
  put("b.csv", fmt::format("x0,y0,z0,x1,y1,z1\n{0},{0}\n", b));
  put("expected.csv", fmt::format("x0,y0,z0,x1,y1,z1\n{0},{0}\n", expected));
  std::vector<std::string> arguments{"expected.csv", "b.csv"};
  arguments.insert(arguments.end(), how.begin(), how.end());
  return answer(arguments)["pairs"] == 1;
}

} // namespace

TEST_CASE("scale, then matrix, then translation, whatever their order on the line") {
  const std::vector<std::string> all{
      "--translate-b", "100,200,300", "--matrix-b", "0,1,0,10,0,0,1,20,1,0,0,30", "--scale-b", "2"};
  CHECK(point_becomes("1,2,3", all, "114,226,332"));
  CHECK_FALSE(point_becomes("1,2,3", all, "114,226,332.0001"));
  CHECK(point_becomes("1,2,3", {"--translate-b=-1,-.5,0"}, "0,1.5,3"));
  CHECK(point_becomes("1,2,3", {"--translate-b", "-1,-.5,1e1"}, "0,1.5,13"));
  CHECK(point_becomes("1,2,3", {"--translate-b", "-1 -.5 1e1"}, "0,1.5,13"));
}

TEST_CASE("decimals are rounded to float32, and moved numbers once more at the end") {
  // 3 times the float32 of 0.1, in double, rounds to one step more than 0.3.
  CHECK(point_becomes("0.1,0,0", {"--scale-b", "3"}, "0.30000001192092896,0,0"));
  CHECK_FALSE(point_becomes("0.1,0,0", {"--scale-b", "3"}, "0.29999998211860657,0,0"));
  CHECK(point_becomes("16777217,0,0", {"--translate-b", "-16777216,0,0"}, "0,0,0"));
  // A half of a step and the step that a translation takes away again, in double.
  CHECK(point_becomes("1,0,0", {"--translate-b", "0.000000059604644775390625,0,0", "--scale-b", "1"}, "1,0,0"));
  CHECK(point_becomes("1.00000017881393432617187499,0,0", {}, "1.00000011920929,0,0"));
}

TEST_CASE("radii take the scale") {
  CHECK(becomes("1,0,0,1", {"--scale-b", "2"}, "2,0,0,2"));
  CHECK_FALSE(becomes("1,0,0,1", {"--scale-b", "2"}, "2,0,0,1"));
  CHECK(becomes("1,0,0,1", {"--scale-b", "2", "--translate-b", "0,5,0"}, "2,5,0,2"));
  // A matrix is allowed only if it is a similarity; this one rotates about z by atan(4/3) and scales by 5, and is then
  // mirrored.
  CHECK(becomes("1,0,0,1", {"--matrix-b", "3,-4,0,0,4,3,0,0,0,0,5,7"}, "3,4,7,5"));
  CHECK_FALSE(becomes("1,0,0,1", {"--matrix-b", "3,-4,0,0,4,3,0,0,0,0,5,7"}, "3,4,7,1"));
  CHECK(becomes("1,0,0,1", {"--matrix-b", "3,4,0,0,4,-3,0,0,0,0,5,0", "--scale-b", "2"}, "6,8,0,10"));
  put("b.csv", "x,y,z,r\n1,0,0,1\n");
  CHECK(complaint({"collide", "b.csv", "b.csv", "--matrix-b", "1,0,0,0,0,2,0,0,0,0,1,0"}) ==
        "b.csv: --matrix-b is no similarity (columns equally long and at right angles), so the spheres have no "
        "radius under it");
}

TEST_CASE("the same pairs under exact scaling and translation") {
  put_mesh("ball.ply", meetc::bodies::icosphere(3));
  meetc::bodies::mesh ring = meetc::bodies::torus(48, 24);
  put_mesh("ring.ply", ring);
  const pair_list pairs = pairs_of({"ball.ply", "ring.ply"});
  meetc::bodies::mesh ball = meetc::bodies::icosphere(3);
  for (float &c : ball.xyz)
    c *= 0x1p-60f;
  put_mesh("tiny.ply", ball);
  CHECK(pairs_of({"tiny.ply", "ring.ply", "--scale-b", "8.673617379884035e-19"}) == pairs);
}

TEST_CASE("a motor of any length moves as its matrix does") {
  // 1 - e12 turns by a quarter about z, x to y; 1 - d/2 e01 moves by d along x. The numbers are doubles.
  CHECK(point_becomes("1,2,3", {"--motor-b", "3,0,0,-3,0,0,0,0"}, "-2,1,3"));
  CHECK(point_becomes("1,2,3", {"--motor-b", "2,0,0,0,-5,0,0,0"}, "6,2,3"));
  CHECK(point_becomes("1,2,3", {"--motor-b", "1,0,0,0,0,-1,2,0"}, "1,4,-1"));
  CHECK_FALSE(point_becomes("1,2,3", {"--motor-b", "1,0,0,0,0,-1,2,0"}, "1,4,-1.0001"));
  CHECK(
      point_becomes("1,2,3", {"--scale-b", "2", "--motor-b", "1,0,0,-1,0,0,0,0", "--translate-b", "0,0,1"}, "-4,2,7"));
  CHECK(becomes("1,0,0,1", {"--motor-b", "0.8,0,0,-0.6,0,0,0,0"}, "0.28,0.96,0,1"));
  put("b.csv", "x,y,z,r\n1,0,0,1\n");
  const auto fails = [](const char *motor) { return complaint({"collide", "b.csv", "b.csv", "--motor-b", motor}); };
  CHECK(fails("1,2,3") == "--motor-b: 8 numbers expected, with commas between them, 3 given");
  CHECK(fails("0,0,0,0,1,2,3,4") == "--motor-b: the scalar and the rotation are 0, so this is no motion");
  CHECK(has(
      complaint({"collide", "b.csv", "b.csv", "--motor-b", "1,0,0,0,0,0,0,0", "--matrix-b", "1,0,0,0,0,1,0,0,0,0,1,0"}),
      "excludes"));
}
