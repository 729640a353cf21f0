// `meet inspect`: its report on the files, and the scene that it writes.
#include "fixture.hpp"

using namespace fixture;

namespace {

std::string inspected(const std::string &a, const std::string &b) {
  const said s = run({"inspect", a, b});
  INFO(s.err);
  REQUIRE(s.code == 0);
  return s.out;
}

} // namespace

TEST_CASE("counts, boxes and predicates") {
  put_mesh("ball.ply", meetc::bodies::icosphere(2));
  put("balls.csv", "x,y,z,r\n1,0,0,0.5\n9,0,0,1\n");
  const std::string out = inspected("ball.ply", "balls.csv");
  for (const char *const part :
       {"triangle: 320 faces, 162 vertices", "box         [-1, -1, -1] to [1, 1, 1]", "sphere: 2 spheres",
        "degenerate  none", "they overlap", "ball_triangle (--mode solid)", "sphere_triangle (--mode surface)"})
    CHECK(has(out, part));
  put("far.csv", "x,y,z\n9,9,9\n");
  CHECK(has(inspected("ball.ply", "far.csv"), "boxes       disjoint"));
  CHECK(has(inspected("balls.csv", "far.csv"), "none for sphere with point"));
  put("none.csv", "x,y,z\n");
  CHECK(has(inspected("ball.ply", "none.csv"), "one is empty"));
}

TEST_CASE("the grid") {
  put("a.csv", "x,y,z\n0.25,0,0\n3,0,0\n");
  put("b.csv", "x,y,z\n-8,0,0.5\n");
  const std::string out = inspected("a.csv", "b.csv");
  CHECK(has(out, "multiples of 2^-2 below 2^2 (4 bits); differences to 2^4 steps: they fit 26 bits"));
  CHECK(has(out, "multiples of 2^-1 below 2^4 (5 bits)"));
  CHECK(has(out, "multiples of 2^-2 below 2^4 (6 bits); differences to 2^6 steps: they fit 26 bits"));
  put("edge.csv", "x,y,z\n0,0,0\n67108864,0,0\n1,0,0\n");
  CHECK(has(inspected("edge.csv", "edge.csv"), "differences to 2^26 steps: they fit 26 bits"));
  put("over.csv", "x,y,z\n-8,0,0\n67108864,0,0\n1,0,0\n");
  CHECK(has(inspected("over.csv", "over.csv"), "differences to 2^27 steps: more than 26 bits"));
  put("zero.csv", "x,y,z\n0,0,0\n");
  CHECK(has(inspected("zero.csv", "zero.csv"), "all numbers are 0"));
  put("range.csv", "x,y,z\n1e-45,0,0\n3e38,0,0\n");
  CHECK(has(inspected("range.csv", "range.csv"), "more than 26 bits"));
}

TEST_CASE("degeneracies") {
  // The faces are good; the same, rotated; collinear; with two equal corners; nearly flat. Vertex 7 is not used.
  put("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3 1 0\nv 0.5 0 0\nv 1e-30 1e-38 0\nv 9 9 9\nv 0 0 3e38\n"
                  "f 1 2 3\nf 3 2 1\nf 1 5 2\nf 4 4 1\nf 1 2 6\nf 1 8 6\n");
  put("rods.csv", "x0,y0,z0,x1,y1,z1\n0,0,0,1,0,0\n1,0,0,-0,0,0\n2,2,2,2,2,2\n");
  const std::string out = inspected("mesh.obj", "rods.csv");
  CHECK(has(out, "2 faces with zero-area triangles, 1 duplicate face, 1 unused vertex"));
  CHECK(has(out, "1 zero-length segment, 1 duplicate\n"));
  put("balls.csv", "x,y,z,r\n0,0,0,0\n0,0,0,0\n0,0,0,1\n");
  const std::string of_balls = inspected("balls.csv", "rods.csv");
  CHECK(has(of_balls, "2 spheres of radius 0, 1 duplicate\n"));
  CHECK(has(of_balls, "least       radius 1\n"));
  CHECK(has(of_balls, "least       length of a segment 1\n"));
  put("wedge.obj", "v 0 0 0\nv 3e20 0 0\nv 0 4e20 0\nf 1 2 3\n");
  CHECK(has(inspected("wedge.obj", "balls.csv"), "least       height of a triangle 2.4e+20\n"));
  // A polygon counts once, and its own triangles do not repeat each other.
  put("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3 4\n");
  CHECK(has(inspected("quad.obj", "quad.obj"), "degenerate  1 duplicate face\n"));
}

TEST_CASE("the scene that the files require") {
  put_mesh("ball.ply", meetc::bodies::icosphere(1));
  put("balls.csv", "x,y,z,r\n1,0,0,0.5\n");
  const said s = run({"inspect", "balls.csv", "ball.ply", "--scene", "robot-cell.toml", "--algebra", MEETC_ALGEBRA});
  INFO(s.err);
  REQUIRE(s.code == 0);
  CHECK(has(s.out, "wrote robot-cell.toml"));
  const std::string scene = get(at("robot-cell.toml"));
  CHECK(has(scene, "[scene]\n"));
  CHECK(has(scene, "namespace = 'robot_cell'"));
  CHECK(has(scene, "rungs     = ['certified']"));
  CHECK(has(s.out, "The gain from the lines of the scene, by queries of ball_triangle"));
  CHECK(has(s.out, "   box         "));
  CHECK_FALSE(has(s.out, "   tolerance   "));
  CHECK(has(scene,
            "\nbox       = 1\n")); // the mesh reaches to 1, the sphere's centre to 1, its radius is below 2
  CHECK(has(scene, "kernels   = ['ball_triangle', 'sphere_triangle']"));
  const std::size_t from = scene.find("algebra   = '") + 13, to = scene.find('\'', from);
  const fs::path algebra = scene.substr(from, to - from);
  CHECK(algebra.is_relative());
  CHECK(fs::equivalent(folder() / algebra, MEETC_ALGEBRA));
  if (std::string_view(MEETC_PROGRAM).size() > 0) {
    const std::string command = fmt::format("'{}' generate '{}' -o '{}' >/dev/null 2>&1", MEETC_PROGRAM,
                                            at("robot-cell.toml"), at("generated"));
    CHECK(std::system(command.c_str()) == 0);
    CHECK(fs::exists(at("generated/robot_cell/ball_triangle.hpp")));
  }
  // With a tolerance the scene asks for what keeps it; a surface around a triangle keeps none.
  const said t = run({"inspect", "balls.csv", "ball.ply", "--scene", "coarse.toml", "--tolerance", "1e-3"});
  INFO(t.err);
  REQUIRE(t.code == 0);
  CHECK(has(t.out, "   tolerance   "));
  CHECK(has(get(at("coarse.toml")), "tolerance = 0.001\n"));
  CHECK_FALSE(has(get(at("coarse.toml")), "rungs"));
  CHECK(has(get(at("coarse.toml")), "kernels   = ['ball_triangle']"));
  if (std::string_view(MEETC_PROGRAM).size() > 0)
    CHECK(std::system(fmt::format("'{}' plan '{}' >/dev/null 2>&1", MEETC_PROGRAM, at("coarse.toml")).c_str()) == 0);
  // Without --algebra the program finds the algebra that comes with it.
  CHECK(run({"inspect", "ball.ply", "ball.ply", "--scene", "7 meshes.toml"}).code == 0);
  CHECK(has(get(at("7 meshes.toml")), "namespace = 'scene_7_meshes'"));
  CHECK(has(get(at("7 meshes.toml")), "cga3.toml'"));
  // The namespace meetc is taken by the kernel headers; meet is free.
  CHECK(run({"inspect", "ball.ply", "ball.ply", "--scene", "meetc.toml"}).code == 0);
  CHECK(has(get(at("meetc.toml")), "namespace = 'meetc_scene'"));
  CHECK(run({"inspect", "ball.ply", "ball.ply", "--scene", "meet.toml"}).code == 0);
  CHECK(has(get(at("meet.toml")), "namespace = 'meet'"));
}

TEST_CASE("the scene's box is the least power of two that holds both files") {
  const auto box_of = [](const std::string &a, const std::string &b) {
    put("a.csv", "x,y,z,r\n" + a + "\n");
    put("b.csv", "x,y,z,r\n" + b + "\n");
    REQUIRE(run({"inspect", "a.csv", "b.csv", "--scene", "boxed.toml", "--algebra", MEETC_ALGEBRA}).code == 0);
    const std::string scene = get(at("boxed.toml"));
    const std::size_t from = scene.find("box       = ");
    return from == std::string::npos ? 0.0 : std::stod(scene.substr(from + 12));
  };
  CHECK(box_of("0,0,0,1", "0,0.25,0,0.1") == 0.5);
  CHECK(box_of("0,0,-0.75,1", "0,0.25,0,2") == 1);
  CHECK(box_of("0,0,-0.75,1", "0,0.25,0,2.0000002") == 2);
  CHECK(box_of("1.0000001,0,0,0", "0,0,0,0") == 2);
  CHECK(box_of("1e-45,0,0,0", "0,0,0,0") == 0x1p-149);
  CHECK(box_of("1e30,0,0,0", "1,0,0,0") == 0x1p100);
  CHECK(box_of("1.7e38,0,0,0", "1,0,0,0") == 0x1p127);
  CHECK(box_of("1.8e38,0,0,0", "1,0,0,0") == 0); // 2^128 is no float32
  CHECK(box_of("0,0,0,0", "0,0,0,0") == 0);
}

TEST_CASE("errors of inspect") {
  put_mesh("ball.ply", meetc::bodies::icosphere(1));
  put("balls.csv", "x,y,z,r\n1,0,0,0.5\n");
  put("points.csv", "x,y,z\n1,0,0\n");
  CHECK(has(complaint({"inspect", "missing.ply", "ball.ply"}), "missing.ply: "));
  CHECK(has(complaint({"inspect", "ball.ply", "ball.ply", "--scene", "s.toml", "--algebra", "nowhere.toml"}),
            "nowhere.toml: no such file"));
  CHECK(has(complaint({"inspect", "ball.ply", "ball.ply", "--algebra", MEETC_ALGEBRA}), "it goes with --scene"));
  CHECK(has(complaint({"inspect", "ball.ply", "ball.ply", "--tolerance", "1"}), "it goes with --scene"));
  CHECK(has(complaint({"inspect", "ball.ply", "ball.ply", "--scene", "s.toml", "--tolerance", "-1"}),
            "is not a finite length of 0 or more"));
  CHECK(has(complaint({"inspect", "ball.ply", "ball.ply", "--scene", "s.toml", "--tolerance", "1e-60"}),
            "no predicate for triangle with triangle keeps it"));
  // A refusal names a tolerance that fits, and half of which does not.
  const std::string fine = complaint({"inspect", "ball.ply", "ball.ply", "--scene", "s.toml", "--tolerance", "1e-30"});
  CHECK(has(fine, "the scene would need integers of more than 128 bits"));
  const std::size_t from = fine.find("at least ") + 9;
  const std::string least = fine.substr(from, fine.find(' ', from) - from);
  INFO(least);
  const std::string half = fmt::format("{}", std::stod(least) / 2);
  CHECK(has(complaint({"inspect", "ball.ply", "ball.ply", "--scene", "s.toml", "--tolerance", half}), "128 bits"));
  CHECK_FALSE(fs::exists(at("s.toml")));
  REQUIRE(run({"inspect", "ball.ply", "ball.ply", "--scene", "fine.toml", "--tolerance", least}).code == 0);
  if (std::string_view(MEETC_PROGRAM).size() > 0)
    CHECK(std::system(fmt::format("'{}' plan '{}' >/dev/null 2>&1", MEETC_PROGRAM, at("fine.toml")).c_str()) == 0);
  CHECK(has(complaint({"inspect", "balls.csv", "points.csv", "--scene", "s.toml"}),
            "no predicate for sphere with point"));
  CHECK(has(complaint({"inspect", "ball.ply", "balls.csv", "--scene", "ball.ply"}), "is an input"));
  CHECK(has(complaint({"inspect", "ball.ply", "balls.csv", "--scene", "no/s.toml"}), "cannot be written"));
  CHECK_FALSE(fs::exists(at("s.toml")));
}
