// `meet collide --contacts`: where pairs meet, in four formats, and its refusals.
#include "fixture.hpp"

using namespace fixture;

namespace {

// The unit square at height 0 as one face of four corners, and a triangle that stands across it along x = 0.25.
void put_square_and_blade() {
  put("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  put("blade.obj", "v 0.25 -1 1\nv 0.25 2 1\nv 0.25 0.5 -1\nf 1 2 3\n");
}

} // namespace

TEST_CASE("contacts as a table name faces, triangles and what each corner lies on") {
  put_square_and_blade();
  const json j = answer({"square.obj", "blade.obj", "--contacts", "c.csv", "--pairs", "pairs.csv"});
  CHECK(j["pairs"] == 1); // of faces
  CHECK(get(at("pairs.csv")) == "a,b\n0,0\n");
  CHECK(j["contacts"]["nodes"] == 3); // both ends, and the middle of the square's diagonal
  CHECK(j["contacts"]["pieces"] == 2);
  CHECK(j["contacts"]["polylines"] == 1);
  CHECK(j["contacts"]["closed"] == 0);
  CHECK(j["contacts"]["embedded"] == "unchecked");
  CHECK(j["seconds"]["contacts"].is_number());
  const std::string text = get(at("c.csv"));
  CHECK(text.starts_with("a,b,triangle_a,node,x,y,z,on_a,on_b\n0,0,0,"));
  CHECK_THAT(text, meetc::test::contains(",0.25,0,0,edge 0 1,face 0\n"));
  CHECK(std::count(text.begin(), text.end(), '\n') == 5);
}

TEST_CASE("contacts as lines, patches and points") {
  put_square_and_blade();
  const said s = run({"collide", "square.obj", "blade.obj", "--contacts", "c.obj"});
  CHECK(s.code == 0);
  CHECK_THAT(s.out, meetc::test::contains("contacts: 3 nodes, 2 pieces, 1 polyline (0 closed); "));
  CHECK_THAT(s.out, meetc::test::contains("wrote c.obj\n"));
  const std::string lines = get(at("c.obj"));
  CHECK(std::count(lines.begin(), lines.end(), 'v') == 3);
  CHECK(std::count(lines.begin(), lines.end(), 'l') == 1);
  // The square, its half in the same plane, and a triangle that meets it in its corner alone.
  put("half.obj", "v 0.5 0 0\nv 1.5 0 0\nv 1.5 1 0\nv 0.5 1 0\nf 1 2 3\nf 1 3 4\n");
  const json flat = answer({"square.obj", "half.obj", "--contacts", "c.obj"});
  CHECK(flat["contacts"]["patches"] >= 2);
  CHECK_THAT(get(at("c.obj")), meetc::test::contains("\nf "));
  put("tip.obj", "v 1 1 0\nv 2 1 1\nv 1 2 1\nf 1 2 3\n");
  const json point = answer({"square.obj", "tip.obj", "--contacts", "c.obj"});
  CHECK(point["contacts"]["single_nodes"] == 1);
  CHECK(get(at("c.obj")) == "v 1 1 0\np 1\n");
  CHECK(answer({"square.obj", "blade.obj", "--contacts", "c.ply"})["contacts"]["nodes"] == 3);
  CHECK(get(at("c.ply")).starts_with("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"));
  CHECK_THAT(get(at("c.ply")), meetc::test::contains("element edge 2\n"));
}

TEST_CASE("contacts as JSON have everything, and coordinates in float64 on request") {
  put("edge.csv", "x0,y0,z0,x1,y1,z1\n0,0,-1,1,1,2\n");
  put_square_and_blade();
  for (const bool swapped : {false, true}) {
    std::vector<std::string> files{"edge.csv", "square.obj"};
    if (swapped)
      std::swap(files[0], files[1]);
    files.insert(files.end(), {"--contacts", "c.json", "--contacts-float64"});
    CHECK(answer(files)["pairs"] == 1);
    const json j = json::parse(get(at("c.json")));
    CHECK(j["coordinates"] == "float64");
    CHECK(j["embedded"] == "unchecked");
    REQUIRE(j["nodes"].size() == 1); // on the diagonal of the square, which both its triangles have
    CHECK(j["nodes"][0]["at"] == json({1.0 / 3, 1.0 / 3, 0.0}));
    CHECK(j["nodes"][0][swapped ? "on_b" : "on_a"] == json({"edge", 0, 1}));
    CHECK(j["pairs"].size() == 2); // of triangles
    CHECK(j["single_nodes"] == json({0}));
  }
}

TEST_CASE("contacts tell on request whether both meshes are embedded") {
  put_square_and_blade();
  const json j = answer({"square.obj", "blade.obj", "--contacts", "c.json", "--contacts-embedded"});
  CHECK(j["contacts"]["embedded"] == "yes");
  CHECK(json::parse(get(at("c.json")))["embedded"] == "yes");
  put("double.obj", "v 0.25 -1 1\nv 0.25 2 1\nv 0.25 0.5 -1\nf 1 2 3\nf 2 1 3\n");
  CHECK(answer({"double.obj", "square.obj", "--contacts", "c.obj", "--contacts-embedded"})["contacts"]["embedded"] ==
        "no");
  const said s = run({"collide", "square.obj", "double.obj", "--contacts", "c.obj", "--contacts-embedded"});
  CHECK_THAT(s.out, meetc::test::contains("; a mesh is not embedded (--self lists why), so that several nodes"));
  CHECK_THAT(complaint({"collide", "square.obj", "blade.obj", "--contacts-embedded"}),
             meetc::test::contains("write --contacts out.obj as well"));
  put("edge.csv", "x0,y0,z0,x1,y1,z1\n0,0,-1,1,1,2\n");
  CHECK_THAT(complaint({"collide", "square.obj", "edge.csv", "--contacts", "c.obj", "--contacts-embedded"}),
             meetc::test::contains("--contacts-embedded goes with two meshes; here are triangles and segments"));
}

TEST_CASE("contacts of spheres and segments, in either order") {
  put("spheres.csv", "x,y,z,r\n5,5,5,1\n0,0,0,1\n");
  put("lines.csv", "x0,y0,z0,x1,y1,z1\n0,0,0,2,2,0\n");
  const json j = answer({"spheres.csv", "lines.csv", "--contacts", "c.csv"});
  CHECK(j["contacts"]["nodes"] == 2);
  CHECK(j["contacts"]["pieces"] == 1);
  CHECK(j["contacts"]["witnesses"] == 0);
  CHECK(get(at("c.csv")) == "a,b,node,x,y,z,on_a,on_b\n1,0,0,0,0,0,inside 1,vertex 0\n"
                            "1,0,1,0.70710677,0.70710677,0,surface 1,edge 0 1\n");
  CHECK(answer({"lines.csv", "spheres.csv", "--contacts", "c.csv"})["contacts"]["nodes"] == 2);
  CHECK_THAT(get(at("c.csv")), meetc::test::contains("0,1,1,0.70710677,0.70710677,0,edge 0 1,surface 1\n"));
  CHECK(answer({"spheres.csv", "lines.csv", "--mode", "surface", "--contacts", "c.obj"})["contacts"]["pieces"] == 0);
  CHECK(get(at("c.obj")) == "v 0.70710677 0.70710677 0\np 1\n");
}

TEST_CASE("witnesses of spheres say that they are") {
  put("ball.csv", "x,y,z,r\n0,0,0,1\n");
  put("face.obj", "v 0.5 0 0\nv 2 1 0\nv 2 -1 0\nf 1 2 3\n");
  const said s = run({"collide", "ball.csv", "face.obj", "--contacts", "c.csv"});
  CHECK(s.code == 0);
  CHECK_THAT(s.out, meetc::test::contains("contacts: 1 witness, one of each pair; "));
  CHECK(get(at("c.csv")) == "a,b,node,x,y,z,on_a,on_b\n0,0,,0.5,0,0,witness,witness\n");
  CHECK(answer({"ball.csv", "face.obj", "--contacts", "c.obj"})["contacts"]["witnesses"] == 1);
  CHECK(get(at("c.obj")) == "# each point is a witness, one of its pair\nv 0.5 0 0\np 1\n");
  CHECK(answer({"ball.csv", "face.obj", "--contacts", "c.ply"})["contacts"]["nodes"] == 0);
  CHECK_THAT(get(at("c.ply")),
             meetc::test::contains("comment each point is a witness, one of its pair\nelement vertex 1\n"));
  CHECK(answer({"ball.csv", "face.obj", "--contacts", "c.json"})["pairs"] == 1);
  const json j = json::parse(get(at("c.json")));
  CHECK(j["witnesses"] == json::parse("[{\"pair\":0,\"at\":[0.5,0,0]}]"));
  CHECK(j["nodes"].empty());
  // One surface inside the other touches it in one point, beyond the greatest float32.
  put("outer.csv", "x,y,z,r\n1.7014118e38,0,0,2.5521178e38\n");
  put("inner.csv", "x,y,z,r\n2.5521178e38,0,0,1.7014118e38\n");
  const said beyond = run({"collide", "inner.csv", "outer.csv", "--mode", "surface", "--contacts", "e.csv"});
  CHECK(beyond.code != 0);
  CHECK_THAT(beyond.err, meetc::test::contains("meet beyond the range of float32; write --contacts-float64 as well"));
  CHECK(answer({"inner.csv", "outer.csv", "--mode", "surface", "--contacts", "e.csv", "--contacts-float64"})["pairs"] ==
        1);
}

TEST_CASE("contacts that cannot be") {
  put_square_and_blade();
  put("edges.csv", "x0,y0,z0,x1,y1,z1\n0,0,0,2,2,0\n");
  const auto refused = [](std::vector<std::string> arguments, const char *message) {
    arguments.insert(arguments.begin(), "collide");
    const said s = run(arguments);
    CHECK(s.code != 0);
    CHECK(s.out.empty());
    CHECK_THAT(s.err, meetc::test::contains(message));
    CHECK(std::count(s.err.begin(), s.err.end(), '\n') == 1);
  };
  refused({"square.obj", "blade.obj", "--contacts", "c.txt"}, "--contacts c.txt: contacts are written as .csv, .obj");
  refused({"square.obj", "blade.obj", "--contacts", "c.obj", "--any"}, "--any stops at the first pair");
  refused({"square.obj", "blade.obj", "--contacts", "c.obj", "--tolerance", "0.1"}, "go with no --tolerance");
  refused({"square.obj", "blade.obj", "--contacts-float64"}, "the file is missing");
  refused({"square.obj", "blade.obj", "--contacts", "square.obj"}, "is an input and would be overwritten");
  refused({"edges.csv", "edges.csv", "--contacts", "c.obj"}, "segment_segment has no contacts");
  CHECK_FALSE(fs::exists(at("c.txt")));
}
