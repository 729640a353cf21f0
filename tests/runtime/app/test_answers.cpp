// The answers of `meet collide` on meshes: counts, files against themselves, polygons, edge cases.
#include "fixture.hpp"

#include <algorithm>

using namespace fixture;
using namespace meetc::bodies;

namespace {

// Ordered pairs of triangles that share a corner, i = j included.
std::size_t sharing(const mesh &m) {
  std::vector<std::vector<unsigned>> at_vertex(m.vertices());
  for (std::size_t i = 0; i < m.index.size(); ++i)
    at_vertex[m.index[i]].push_back(static_cast<unsigned>(i / 3));
  std::set<std::pair<unsigned, unsigned>> pairs;
  for (const auto &around : at_vertex)
    for (const unsigned i : around)
      for (const unsigned j : around)
        pairs.emplace(i, j);
  return pairs.size();
}

const char *two_squares(bool quads) {
  return quads ? "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\n"
                 "f 1 2 3 4\nf 5 6 7 8\n"
               : "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\n"
                 "f 1 2 3\nf 1 3 4\nf 5 6 7\nf 5 7 8\n";
}

} // namespace

TEST_CASE("JSON holds what it promises, and nothing else is printed") {
  put_mesh("ball.ply", icosphere(3));
  put_mesh("ring.ply", torus(48, 24));
  const json j = answer({"ball.ply", "ring.ply"});
  CHECK(j["a"] == json{{"kind", "triangle"}, {"elements", 1280}});
  CHECK(j["b"] == json{{"kind", "triangle"}, {"elements", 2304}});
  CHECK(j["pairs"] > 100);
  CHECK(j["precision"] == "certified");
  CHECK(j["device"] == "cpu");
  CHECK(j["unsure"].size() == 3);
  for (const char *const step : {"read", "prepare", "collide"})
    CHECK(j["seconds"][step] >= 0.0);
  CHECK(j["predicate"] == "triangle_triangle");
  CHECK(j["mode"] == "");
  CHECK(j["instruction_set"].is_string());
  CHECK(j["rounded"].size() == 2);
  CHECK(j.size() == 13);
}

TEST_CASE("the summary can be read") {
  put_mesh("ball.ply", icosphere(3));
  put_mesh("ring.ply", torus(48, 24));
  const said s = run({"collide", "ball.ply", "ring.ply"});
  CHECK(s.code == 0);
  for (const char *const part :
       {"A  ball.ply  1,280 faces", "B  ring.ply  2,304 faces", "box [-1, -1, -1] to [1, 1, 1]",
        "pairs touch: ", " faces of A, ", "triangle_triangle, certified, on the CPU", "rungs used: fp32 (",
        " handed on)", "read 0.", "prepare 0.", "collide 0."})
    CHECK(has(s.out, part));
  CHECK_FALSE(has(s.out, "disjoint"));
  CHECK_FALSE(has(s.out, "surfaces"));
  CHECK_FALSE(has(s.out, "same file"));
  CHECK(s.err.empty());
}

TEST_CASE("a closed mesh against itself: neighbours touch, and nothing else") {
  const mesh bodies[] = {icosphere(3), torus(40, 20), knot(96, 12), block(4, 3, 2, 1)};
  for (const mesh &m : bodies) {
    put_mesh("self.ply", m);
    const json j = answer({"self.ply", "self.ply"});
    CHECK(j["pairs"] == sharing(m));
    CHECK(j["touched_a"] == m.triangles());
    CHECK(j["touched_b"] == m.triangles());
  }
  put_mesh("copy.ply", bodies[0]);
  fs::remove(at("link.ply"));
  put_mesh("self.ply", bodies[0]);
  fs::create_symlink("self.ply", at("link.ply"));
  CHECK(has(run({"collide", "self.ply", "self.ply"}).out, "every ordered pair (i, j) counts, i = j included"));
  CHECK(has(run({"collide", "self.ply", "link.ply"}).out, "same file"));
  CHECK_FALSE(has(run({"collide", "self.ply", "copy.ply"}).out, "same file"));
  CHECK(has(run({"collide", "self.ply", "self.ply", "--scale-b", "2"}).out, "same file, B moved"));
}

TEST_CASE("either order gives the same pairs, turned") {
  put_mesh("ball.ply", icosphere(3));
  put_mesh("ring.ply", torus(48, 24));
  pair_list forth = pairs_of({"ball.ply", "ring.ply"}), back = pairs_of({"ring.ply", "ball.ply"});
  for (auto &p : back)
    std::swap(p.first, p.second);
  std::sort(back.begin(), back.end());
  CHECK(forth == back);
}

TEST_CASE("a polygon is one face, and each pair counts once") {
  put("quads.obj", two_squares(true));
  put("triangles.obj", two_squares(false));
  put("cut.csv", "x0,y0,z0,x1,y1,z1\n0.25,0.25,-1,0.25,0.25,1\n0.5,0.5,-1,0.5,0.5,1\n5.5,0.5,-1,5.5,0.5,1\n");
  CHECK(pairs_of({"quads.obj", "cut.csv"}) == pair_list{{0, 0}, {0, 1}, {1, 2}});
  CHECK(pairs_of({"cut.csv", "quads.obj"}) == pair_list{{0, 0}, {1, 0}, {2, 1}});
  // All three lie on a diagonal, which belongs to both triangles of a square.
  CHECK(answer({"triangles.obj", "cut.csv"})["pairs"] == 6);
  const json self = answer({"quads.obj", "quads.obj"});
  CHECK(self["a"]["elements"] == 2);
  CHECK(self["pairs"] == 2);
  CHECK(has(run({"collide", "quads.obj", "cut.csv"}).out, "2 faces (4 triangles)"));
}

TEST_CASE("touching counts: corner, edge, coplanar, a gap of one step does not") {
  put("a.csv", "x0,y0,z0,x1,y1,z1,x2,y2,z2\n0,0,0,1,0,0,0,1,0\n");
  const auto pairs_with = [](const std::string &row) {
    put("b.csv", fmt::format("x0,y0,z0,x1,y1,z1,x2,y2,z2\n{}\n", row));
    return answer({"a.csv", "b.csv"})["pairs"];
  };
  CHECK(pairs_with("0,0,0,-1,0,1,0,-1,1") == 1);                 // corner on corner
  CHECK(pairs_with("0.25,0.25,0,1,1,1,2,1,1") == 1);             // corner on face
  CHECK(pairs_with("0,0,0,1,0,0,0,0,1") == 1);                   // shared edge
  CHECK(pairs_with("0.25,0.25,0,2,2,0,3,2,0") == 1);             // coplanar, overlapping
  CHECK(pairs_with("0,0,0,1,0,0,0,1,0") == 1);                   // the same
  CHECK(pairs_with("0.25,0.25,0,0.25,0.25,0,0.25,0.25,0") == 1); // a point on it
  CHECK(pairs_with("0.25,0.25,1e-45,1,1,1,2,1,1") == 0);
  CHECK(pairs_with("1,1,0,2,1,0,1,2,0") == 0); // coplanar, apart
}

TEST_CASE("disjoint boxes, nested meshes, empty meshes") {
  put_mesh("big.ply", icosphere(2));
  mesh small = icosphere(2);
  for (float &c : small.xyz)
    c /= 4;
  put_mesh("small.ply", small);
  const said nested = run({"collide", "small.ply", "big.ply"});
  CHECK(has(nested.out, "Nothing touches"));
  CHECK(has(nested.out, "Meshes are surfaces"));
  CHECK_FALSE(has(nested.out, "disjoint"));
  const said apart = run({"collide", "small.ply", "big.ply", "--translate-b", "9,0,0"});
  CHECK(has(apart.out, "The boxes are disjoint."));
  CHECK_FALSE(has(apart.out, "surfaces"));
  const json j = answer({"small.ply", "big.ply", "--translate-b", "9,0,0"});
  CHECK(j["pairs"] == 0);
  CHECK(j["touched_a"] == 0);

  put("empty.csv", "x0,y0,z0,x1,y1,z1,x2,y2,z2\n");
  put("none.csv", "x,y,z,r\n");
  for (const char *const other : {"big.ply", "empty.csv", "none.csv"}) {
    const json e = answer({"empty.csv", other});
    CHECK(e["pairs"] == 0);
    CHECK(e["a"]["elements"] == 0);
    CHECK(run({"collide", other, "empty.csv"}).code == 0);
  }
  CHECK(has(run({"collide", "empty.csv", "big.ply"}).out, "box empty"));
  CHECK(run({"collide", "empty.csv", "empty.csv", "--color", "colours", "--image", "none.png"}).code == 0);
}

TEST_CASE("option --any says whether there is a pair, not which") {
  put_mesh("ball.ply", icosphere(3));
  put_mesh("ring.ply", torus(48, 24));
  const json yes = answer({"ball.ply", "ring.ply", "--any"});
  CHECK(yes["pairs"] == 1);
  CHECK(yes["touched_a"] == 1);
  CHECK(yes["touched_b"] == 1);
  CHECK(answer({"ball.ply", "ring.ply", "--any", "--translate-b", "9,0,0"})["pairs"] == 0);
  CHECK(has(run({"collide", "ball.ply", "ring.ply", "--any"}).out, "They touch"));
  CHECK(has(run({"collide", "ball.ply", "ring.ply", "--any", "--scale-b", "9"}).out, "Nothing touches."));
}

TEST_CASE("precisions and devices that there are") {
  put_mesh("ball.ply", icosphere(3));
  put_mesh("ring.ply", torus(48, 24));
  const json exact = answer({"ball.ply", "ring.ply", "--precision", "exact", "--device", "auto"});
  CHECK(exact["unsure"] == json::object());
  for (const char *const rung : {"fp32", "fp64", "fp64x2"}) {
    const json j = answer({"ball.ply", "ring.ply", "--precision", rung, "--device", "cpu"});
    CHECK(j["precision"] == rung);
    CHECK(j["unsure"] == json::object());
    CHECK_FALSE(has(run({"collide", "ball.ply", "ring.ply", "--precision", rung}).out, "rungs used"));
    CHECK(std::abs(j["pairs"].get<int>() - exact["pairs"].get<int>()) < 20);
  }
}

TEST_CASE("certified, the default, is exact and says what each rung handed on") {
  // One triangle against others whose corners lie so near its plane that fp32, fp64 or all bounded rungs are unsure,
  // and against one that fp32 decides.
  put("a.csv", "x0,y0,z0,x1,y1,z1,x2,y2,z2\n0,0,0,1,1e-3,0.333,0.777,1,0.6543\n");
  std::string rows = "x0,y0,z0,x1,y1,z1,x2,y2,z2\n0.5,0.3,-9,0.6,0.4,-9,0.6,0.3,9\n";
  for (const int i : {1, 2, 3, 4, 5, 6, 7, 8, 9}) // corners a rounding off its plane
    rows +=
        fmt::format("{0},{1},{2},2,3,9,3,2,9\n", i * 0.0623 + i * i * 0.001, i * 0.05 + 0.0001,
                    (i * 0.0623 + i * i * 0.001) * 0.333 + (i * 0.05 + 0.0001 - 1e-3 * (i * 0.0623 + i * i * 0.001)) *
                                                               (0.6543 - 0.333 * 0.777) / (1 - 1e-3 * 0.777));
  put("b.csv", rows);
  put_mesh("ball.ply", icosphere(3));
  put_mesh("ring.ply", torus(48, 24));
  const struct {
    const char *a, *b;
  } sets[] = {{"a.csv", "b.csv"}, {"b.csv", "a.csv"}, {"ball.ply", "ring.ply"}, {"ring.ply", "ring.ply"}};
  for (const auto &[a, b] : sets) {
    answer({a, b, "--precision", "exact", "--pairs", "exact.csv"});
    const json j = answer({a, b, "--pairs", "certified.csv"});
    CHECK(answer({a, b, "--precision", "certified"})["unsure"] == j["unsure"]);
    CHECK(get(at("certified.csv")) == get(at("exact.csv")));
    CHECK(j["unsure"]["fp32"] >= j["unsure"]["fp64"]);
    CHECK(j["unsure"]["fp64"] >= j["unsure"]["fp64x2"]);
  }
  const said s = run({"collide", "a.csv", "b.csv", "--json"});
  const json unsure = json::parse(s.out)["unsure"];
  CHECK(unsure["fp32"] > 0);
  CHECK(unsure["fp32"] < 10);
  CHECK(has(s.out, fmt::format("\"unsure\":{{\"fp32\":{},\"fp64\":{},\"fp64x2\":{}}},", unsure["fp32"].get<int>(),
                               unsure["fp64"].get<int>(), unsure["fp64x2"].get<int>())));
  CHECK(has(run({"collide", "a.csv", "b.csv"}).out,
            fmt::format("rungs used: fp32 ({} handed on), fp64 (", unsure["fp32"].get<int>())));
  // Where nothing is decided, no rung runs.
  CHECK_FALSE(has(run({"collide", "a.csv", "b.csv", "--translate-b", "99,0,0"}).out, "rungs used"));
}
