// Kinds choose the predicate, in either order; modes; spheres at the edge of touching.
#include "fixture.hpp"

#include <algorithm>

using namespace fixture;
using namespace meetc::bodies;

namespace {

void put_rows(const std::string &name, const std::string &header, const std::vector<float> &rows, std::size_t fields) {
  std::ostringstream out;
  out.precision(9);
  out << header << "\n";
  for (std::size_t i = 0; i < rows.size(); ++i)
    out << rows[i] << (i % fields == fields - 1 ? "\n" : ",");
  put(name, out.str());
}

void put_files() {
  put_mesh("ring.ply", torus(48, 24));
  put_rows("balls.csv", "x,y,z,r", sphere_cloud(300, 1, 0.02, 0.2), 4);
  put_rows("rods.csv", "x0,y0,z0,x1,y1,z1", segment_cloud(300, 2, 0.5), 6);
  put("points.csv", "x,y,z\n1.375,0,0\n0,0,0\n");
}

std::string predicate(const std::string &a, const std::string &b, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {a, b});
  return answer(more)["predicate"];
}

} // namespace

TEST_CASE("kinds choose the predicate in either order, and pairs stay (of A, of B)") {
  put_files();
  const struct {
    const char *a, *b, *solid, *surface;
  } cases[] = {{"ring.ply", "ring.ply", "triangle_triangle", "triangle_triangle"},
               {"rods.csv", "rods.csv", "segment_segment", "segment_segment"},
               {"rods.csv", "ring.ply", "segment_triangle", "segment_triangle"},
               {"points.csv", "ring.ply", "point_triangle", "point_triangle"},
               {"balls.csv", "balls.csv", "ball_ball", "sphere_sphere"},
               {"balls.csv", "rods.csv", "ball_segment", "sphere_segment"},
               {"balls.csv", "ring.ply", "ball_triangle", "sphere_triangle"}};
  for (const auto &c : cases) {
    INFO(c.solid);
    CHECK(predicate(c.a, c.b) == c.solid);
    CHECK(predicate(c.b, c.a) == c.solid);
    CHECK(predicate(c.b, c.a, {"--mode", "solid"}) == c.solid);
    CHECK(predicate(c.a, c.b, {"--mode", "surface"}) == c.surface);
    CHECK(predicate(c.b, c.a, {"--predicate", c.surface}) == c.surface);
    CHECK(predicate(c.a, c.b, {"--predicate", c.solid}) == c.solid);
    const pair_list forth = pairs_of({c.a, c.b});
    pair_list back = pairs_of({c.b, c.a});
    CHECK_FALSE(forth.empty());
    for (auto &p : back)
      std::swap(p.first, p.second);
    std::sort(back.begin(), back.end());
    CHECK(forth == back);
    const pair_list surface = pairs_of({c.a, c.b, "--mode", "surface"});
    CHECK(std::includes(forth.begin(), forth.end(), surface.begin(), surface.end()));
  }
  CHECK(answer({"ring.ply", "balls.csv"})["mode"] == "solid");
  CHECK(answer({"ring.ply", "balls.csv"})["a"]["kind"] == "triangle");
  CHECK(answer({"ring.ply", "balls.csv"})["b"]["kind"] == "sphere");
  CHECK(has(run({"collide", "balls.csv", "rods.csv"}).out, "ball_segment (solid), certified"));
}

TEST_CASE("boxes: closed, in float32 as read, and never turned") {
  put("one.csv", "low_x,low_y,low_z,high_x,high_y,high_z\n0,0,0,1,1,1\n");
  const auto pairs_with = [](const std::string &row) {
    put("other.csv", "low_x,low_y,low_z,high_x,high_y,high_z\n" + row + "\n");
    return answer({"one.csv", "other.csv"})["pairs"];
  };
  CHECK(pairs_with("1,0,0,2,1,1") == 1);                // a face in common
  CHECK(pairs_with("1,1,1,2,2,2") == 1);                // a corner
  CHECK(pairs_with("1.0000001,0,0,2,1,1") == 0);        // one step off
  CHECK(pairs_with("0.25,0.25,0.25,0.5,0.5,0.5") == 1); // within
  CHECK(pairs_with("-1,0.5,0.5,2,0.5,0.5") == 1);       // a segment through it
  CHECK(pairs_with("0.5,-1,-2,0.5,3,-0.0000001") == 0);
  CHECK(answer({"one.csv", "one.csv"})["predicate"] == "box_box");
  put("many.csv", "low_x,low_y,low_z,high_x,high_y,high_z\n0,0,0,1,1,1\n2,2,2,3,3,3\n");
  const said s = run({"collide", "one.csv", "many.csv", "--image", "boxes.png"});
  CHECK(s.code == 0);
  CHECK(has(s.out, "2 boxes"));
  CHECK(answer({"one.csv", "many.csv", "--scale-b", "0.5", "--translate-b", "-1,0,0"})["pairs"] == 1);
  CHECK(answer({"one.csv", "many.csv", "--matrix-b", "2,0,0,0,0,1,0,0,0,0,1,-1"})["pairs"] == 1);
  for (const char *const matrix : {"0,-1,0,0,1,0,0,0,0,0,1,0", "-1,0,0,0,0,1,0,0,0,0,1,0", "1,0.5,0,0,0,1,0,0,0,0,1,0"})
    CHECK(has(complaint({"collide", "one.csv", "many.csv", "--matrix-b", matrix}),
              "many.csv: --matrix-b does more than move and scale along the axes, and boxes have their edges there"));
  put("upside.csv", "low_x,low_y,low_z,high_x,high_y,high_z\n0,0,0,1,1,1\n0,0,2,1,1,1\n");
  CHECK(has(complaint({"collide", "one.csv", "upside.csv"}), "low <= high"));
  put_mesh("ring.ply", torus(48, 24));
  CHECK(has(complaint({"collide", "one.csv", "ring.ply"}), "box"));
}

TEST_CASE("spheres: tangent is a hit, nested depends on the mode, radius 0 is a point") {
  put("one.csv", "x,y,z,r\n0,0,0,1\n");
  const auto pairs_with = [](const std::string &row, const std::string &mode) {
    put("other.csv", fmt::format("x,y,z,r\n{}\n", row));
    return answer({"one.csv", "other.csv", "--mode", mode})["pairs"];
  };
  const struct {
    const char *row;
    int solid, surface;
  } cases[] = {
      {"3,0,0,2", 1, 1},         {"3.0000002,0,0,2", 0, 0}, // tangent from outside; one step off
      {"1,0,0,2", 1, 1},         {"0.5,0,0,2", 1, 0},       // tangent from inside; nested
      {"0,0,0,1", 1, 1},         {"0,0,0,0.5", 1, 0},       // identical; concentric
      {"1,0,0,0", 1, 1},         {"0,0,0,0", 1, 0},         // a point on it; in it
      {"0,1.0000001,0,0", 0, 0},                            // a point outside
  };
  for (const auto &c : cases) {
    INFO(c.row);
    CHECK(pairs_with(c.row, "solid") == c.solid);
    CHECK(pairs_with(c.row, "surface") == c.surface);
  }
  put("points.csv", "x,y,z,r\n1,2,3,0\n1,2,3,0\n4,5,6,0\n");
  CHECK(answer({"points.csv", "points.csv"})["pairs"] == 5);
}

TEST_CASE("a mesh against spheres: the hint that meshes are surfaces comes where it helps") {
  put_mesh("shell.ply", icosphere(3));
  put("inside.csv", "x,y,z,r\n0,0,0,0.25\n");
  put("around.csv", "x,y,z,r\n0,0,0,4\n");
  CHECK(has(run({"collide", "shell.ply", "inside.csv"}).out, "Meshes are surfaces"));
  CHECK(answer({"inside.csv", "shell.ply"})["pairs"] == 0);
  CHECK(answer({"around.csv", "shell.ply"})["pairs"] == 1280);
  CHECK(answer({"around.csv", "shell.ply", "--mode", "surface"})["pairs"] == 0);
}
