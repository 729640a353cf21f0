// `meet collide --self`: where a mesh crosses itself.
#include "fixture.hpp"

using namespace fixture;

namespace {

// Two faces fold onto each other, one is apart, one has no area and lies in the first.
const char *const folded = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 0.25 0.25 0\n"
                           "f 1 2 3\nf 1 3 4\nf 5 6 7\nf 8 8 8\n";
const char *const edge_by_position = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n";

} // namespace

TEST_CASE("the pairs of one mesh with itself, in words, as JSON and as a table") {
  put("folded.obj", folded);
  const json j = answer({"--self", "folded.obj", "--pairs", "pairs.csv", "--color", "painted"});
  CHECK(j["pairs"] == 3);
  CHECK(j["touched_a"] == 3);
  CHECK(j["without_area"] == json::array({3}));
  CHECK(j["neighbours"] == json::array({0, 1, 0}));
  CHECK(j["precision"] == "certified");
  CHECK(get(at("pairs.csv")) == "a,b\n0,1\n0,3\n1,3\n");
  CHECK(fs::exists(at("painted/a.ply")));
  const said s = run({"collide", "--self", "folded.obj", "--image", "self.png"});
  INFO(s.err);
  CHECK(s.code == 0);
  CHECK(has(s.out, "3 pairs of faces meet beyond their common corners: 3 faces."));
  CHECK(has(s.out, "1 face has no area (face 3) and is the segment or point that it is."));
  CHECK(fs::exists(at("self.png")));
}

TEST_CASE("corners are merged by their coordinates unless --no-merge is given") {
  put("edge.obj", edge_by_position);
  CHECK(answer({"--self", "edge.obj"})["pairs"] == 0);
  CHECK(answer({"--self", "edge.obj", "--no-merge"})["pairs"] == 1);
  CHECK(has(run({"collide", "--self", "edge.obj"}).out, "No two faces meet beyond their common corners: 0 pairs."));
}

TEST_CASE("polygons are named with their triangles, and pairs within one do not count") {
  put("quads.obj",
      "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 -1\nv 2 1 1\nv 1 2 1\nv 1.2 1.2 1\nf 1 2 3 4\nf 5 6 8 7\n");
  const json j = answer({"--self", "quads.obj", "--pairs", "pairs.csv"});
  CHECK(j["pairs"] == 1);
  CHECK(j["triangle_pairs"].get<int>() >= 1);
  const std::string table = get(at("pairs.csv"));
  CHECK(table.starts_with("a,b,triangle_a,triangle_b\n0,1,"));
}

TEST_CASE("the option --self takes one mesh and what can be said of it") {
  put("folded.obj", folded);
  put("balls.csv", "x,y,z,r\n1,0,0,0.5\n");
  const auto refused = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"collide", "--self"});
    return complaint(more);
  };
  CHECK(has(refused({"folded.obj", "folded.obj"}), "--self is about A alone; leave out folded.obj, or --self"));
  CHECK(has(refused({"folded.obj", "--translate-b", "1,0,0"}), "--translate-b: with --self there is no B"));
  CHECK(has(refused({"folded.obj", "--any"}), "--any goes with two sets, and --self with one"));
  CHECK(has(refused({"folded.obj", "--precision", "fp32"}), "--precision fp32: the answer of --self is certified"));
  CHECK(has(refused({"folded.obj", "--device", "cuda", "--devices", "2"}), "--devices: one device answers --self"));
  CHECK(has(refused({"balls.csv"}), "--self needs a mesh, whose faces may cross each other; balls.csv holds spheres"));
  CHECK(has(refused({}), "A is required"));
  CHECK(has(complaint({"collide", "folded.obj", "folded.obj", "--no-merge"}), "--no-merge goes with --self"));
}
