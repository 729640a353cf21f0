// The files that `meet` reads: polygons of every shape, lines and points, numbers that rounding moves, standard input; and the
// notes on them.
#include "fixture.hpp"

using namespace fixture;

namespace {

const char *const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

void put_segments(const std::string &name, const std::vector<std::pair<double, double>> &through) {
  std::string rows = "x0,y0,z0,x1,y1,z1\n";
  for (const auto &[x, y] : through)
    rows += fmt::format("{0},{1},-1,{0},{1},1\n", x, y);
  put(name, rows);
}

std::vector<unsigned> rows_that_touch(const std::string &mesh, const std::string &segments) {
  std::vector<unsigned> out;
  for (const auto &[a, b] : pairs_of({mesh, segments})) {
    CHECK(a == 0);
    out.push_back(b);
  }
  return out;
}

std::string summary_of(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "collide");
  const said s = run(arguments);
  INFO(s.err);
  REQUIRE(s.code == 0);
  return s.out;
}

} // namespace

TEST_CASE("a segment through the notch or the hole of a polygon does not touch it") {
  put("dart.obj", "v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nf 1 2 3 4\n");
  put_segments("dart.csv", {{2, 0.5}, {2, 1}, {2, 2}, {1, 0.5}, {1, 0.25}});
  CHECK(rows_that_touch("dart.obj", "dart.csv") == std::vector<unsigned>{1, 2, 3});
  put("L.obj", "v 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\nv 0 0 0\nv 4 0 0\nf 1 2 3 4 5 6\n");
  put_segments("L.csv", {{2, 2}, {0.5, 3}, {3, 0.5}, {1, 1}});
  CHECK(rows_that_touch("L.obj", "L.csv") == std::vector<unsigned>{1, 2, 3});
  // One polygon with a bridge to its hole, in either direction and from each corner.
  const std::string vertices = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 3 3 0\nv 3 7 0\nv 7 7 0\nv 7 3 0\n";
  std::vector<int> corners{1, 2, 3, 4, 1, 5, 6, 7, 8, 5};
  put_segments("hole.csv", {{5, 5}, {1, 1}, {5, 1}, {9, 5}, {1, 8}, {5, 9}, {3, 5}, {2, 2}});
  for (std::size_t turn = 0; turn < 2 * corners.size(); ++turn) {
    if (turn == corners.size())
      std::reverse(corners.begin(), corners.end());
    std::string face = "f";
    for (const int c : corners)
      face += fmt::format(" {}", c);
    put("hole.obj", vertices + face + "\n");
    CHECK(answer({"hole.obj", "hole.csv"})["touched_b"] == 7);
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
  CHECK(rows_that_touch("hole.obj", "hole.csv") == std::vector<unsigned>{1, 2, 3, 4, 5, 6, 7});
  CHECK(has(summary_of({"hole.obj", "hole.csv"}), "1 face (8 triangles)"));
  // The coloured mesh has the polygon as it was.
  answer({"dart.obj", "dart.csv", "--color", "painted"});
  CHECK(has(get(at("painted/a.ply")), std::string("\4\0\0\0\0\1\0\0\0\2\0\0\0\3\0\0\0", 17)));
  CHECK(rows_that_touch("painted/a.ply", "dart.csv") == std::vector<unsigned>{1, 2, 3});
}

TEST_CASE("polygons that are not planar or cross themselves are told") {
  put("odd.obj",
      "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 5 0 0\nv 7 2 0\nv 7 0 0\nv 5 2 0\nf 1 2 3 4\nf 5 6 7 8\nf 1 2 4\n");
  put_segments("cut.csv", {{0.25, 0.25}});
  for (const std::string &text : {run({"inspect", "odd.obj"}).out, summary_of({"odd.obj", "cut.csv"})}) {
    CHECK(has(text, "1 of 2 polygons is not planar: a corner is 0.408 from the plane through the first one at most; "
                    "more than 2^-20 of the longest side: face 0"));
    CHECK(has(text, "1 polygon crosses itself: the rest, of which no corner can be cut off, is fanned: face 1"));
  }
  CHECK(answer({"odd.obj", "cut.csv"})["notes"].size() == 2);
}

TEST_CASE("the numbers that rounding to float32 moves are told") {
  put("utm.csv", "x,y,z\n433832.18,0.1,1\n433832.2,4649776.22,0\n");
  put("near.csv", "x0,y0,z0,x1,y1,z1\n0,0,0,16777217,1,1\n");
  const json j = answer({"near.csv", "near.csv"});
  CHECK(j["rounded"] == json{{"numbers", 1}, {"largest", 1.0}});
  CHECK(answer({"near.csv", "near.csv", "--translate-b", "0,0,0"})["rounded"]["numbers"] == 2);
  CHECK(has(summary_of({"near.csv", "near.csv"}), "Rounded to float32: 1 number of A moved, by 1 at most.\n"));
  CHECK(has(run({"inspect", "utm.csv"}).out, "rounded     2 numbers moved, by 0.22 at most"));
  put("exact.csv", "x,y,z,r\n0.1,0.25,3,1\n");
  CHECK(answer({"exact.csv", "exact.csv"})["rounded"] == json{{"numbers", 0}, {"largest", 0.0}});
  CHECK_FALSE(has(summary_of({"exact.csv", "exact.csv"}), "Rounded"));
  CHECK(has(run({"inspect", "exact.csv"}).out, "rounded     float32 holds all numbers"));
}

TEST_CASE("lines and points of files without faces") {
  put("wire.obj", "v 0 0 -1\nv 0 0 1\nv 5 5 5\nl 1 2 3\nl 3 1\n");
  put("floor.obj", std::string(square) + "f 1 2 3\n");
  put("dots.obj", "v 0.5 0.25 0\nv 3 3 3\nv 1 0 0\np 1 2\np 3\n");
  put("dots.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
                  "end_header\n0.5 0.25 0\n9 9 9\n");
  CHECK(pairs_of({"wire.obj", "floor.obj"}) == pair_list{{0, 0}, {1, 0}});
  CHECK(pairs_of({"dots.obj", "floor.obj"}) == pair_list{{0, 0}, {2, 0}});
  CHECK(pairs_of({"floor.obj", "dots.ply"}) == pair_list{{0, 0}});
  CHECK(has(summary_of({"wire.obj", "floor.obj", "--image", "wire.png"}), "2 lines (3 segments)"));
  CHECK(has(summary_of({"dots.obj", "floor.obj", "--image", "dots.png"}), "3 points"));
  put("both.obj", std::string(square) + "l 1 2\np 1\n");
  CHECK(complaint({"collide", "both.obj", "floor.obj"}) ==
        "both.obj: it holds 1 line and 1 point; choose with --kind-a segment or --kind-a point");
  CHECK(answer({"floor.obj", "both.obj", "--kind-b", "point"})["b"]["kind"] == "point");
  CHECK(answer({"both.obj", "both.obj", "--kind-a", "segment", "--kind-b", "segment"})["pairs"] == 1);
  put("beside.obj", std::string(square) + "f 1 2 3\nl 1 2\nl 3 4 1\np 2\n");
  CHECK(has(summary_of({"beside.obj", "floor.obj"}), "A: left out beside the faces: 2 lines, 1 point\n"));
  put("none.obj", "# nothing\n");
  CHECK(complaint({"collide", "none.obj", "floor.obj"}) ==
        "none.obj: no faces, lines or points to collide; it holds nothing");
}

TEST_CASE("A is moved like B, and an identity changes nothing") {
  put("a.csv", "x,y,z,r\n1,0,0,1\n");
  put("b.csv", "x,y,z,r\n10,0,0,1\n");
  CHECK(answer({"a.csv", "b.csv"})["pairs"] == 0);
  CHECK(answer({"a.csv", "b.csv", "--translate-a", "7,0,0"})["pairs"] == 1);
  CHECK(answer({"a.csv", "b.csv", "--scale-a", "2", "--translate-a", "5,0,0"})["pairs"] == 1);
  CHECK(answer({"a.csv", "b.csv", "--matrix-a", "1,0,0,7,0,1,0,0,0,0,1,0"})["pairs"] == 1);
  CHECK(answer({"a.csv", "b.csv", "--matrix-a", "1,0,0,7,0,1,0,0,0,0,1,0,0,0,0,1"})["pairs"] == 1);
  CHECK(answer({"a.csv", "b.csv", "--matrix-b", "1,0,0,-7,0,1,0,0,0,0,1,0,0,0,0,1"})["pairs"] == 1);
  CHECK(complaint({"collide", "a.csv", "b.csv", "--matrix-a", "1,0,0,7,0,1,0,0,0,0,1,0,0,0,0,2"}) ==
        "--matrix-a: the last row of the 4x4 matrix is 0,0,0,2, not 0,0,0,1");
  CHECK(complaint({"collide", "a.csv", "b.csv", "--matrix-a", "1,2,3"}) ==
        "--matrix-a: 12 numbers expected, or 16, with commas between them, 3 given");
  CHECK(complaint({"collide", "a.csv", "b.csv", "--scale-a", "0"}) ==
        "--scale-a: the scale is 0; it must be finite and above 0");
  CHECK(has(complaint({"collide", "a.csv", "b.csv", "--scale-a", "1e39"}), "not finite in float32 after --scale-a"));
  CHECK(has(summary_of({"a.csv", "a.csv", "--translate-a", "1,0,0"}), "A and B are the same file, A moved."));
  // The decimal is rounded before it is moved: to 1, and not to the float32 above it.
  put("tie.csv", "x,y,z\n1.00000005960464477540,0,0\n");
  put("box.obj", "v 1.0000001 0 0\nv 1.0000001 0 1\nv 1.0000001 1 0\nf 1 2 3\n");
  for (const std::vector<std::string> &more :
       {std::vector<std::string>{}, {"--translate-a", "0,0,0"}, {"--scale-a", "1"}, {"--translate-b", "0,0,0"}}) {
    std::vector<std::string> arguments{"tie.csv", "box.obj"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    CHECK(answer(arguments)["pairs"] == 1);
  }
}

TEST_CASE("standard input, and formats by name") {
  put("floor.obj", std::string(square) + "f 1 2 3\n");
  put_mesh("ball.ply", meetc::bodies::icosphere(1));
  const auto from = [](const std::string &file, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "collide");
    arguments.emplace_back("--json");
    const said s = run(arguments, "<'" + at(file) + "'");
    INFO(s.err);
    return s.code == 0 ? json::parse(s.out)["pairs"].get<int>() : -1;
  };
  const int want = answer({"ball.ply", "floor.obj"})["pairs"];
  REQUIRE(want > 0);
  CHECK(from("ball.ply", {"-", "floor.obj"}) == want);
  CHECK(from("ball.ply", {"/dev/stdin", "floor.obj"}) == want);
  CHECK(from("floor.obj", {"ball.ply", "-", "--format-b", "obj"}) == want);
  CHECK(from("floor.obj", {"ball.ply", "-"}) == -1);
  const said none = run({"collide", "ball.ply", "-"}, "<'" + at("floor.obj") + "'");
  CHECK(none.err ==
        "meet: standard input: its first bytes tell no format; name it with --format-b ply, obj, off, stl, csv\n");
  CHECK(run({"collide", "-", "-"}, "</dev/null").err == "meet: only one of A and B can be standard input\n");
  // Through a pipe, which cannot be mapped.
  const std::string command =
      fmt::format("cd '{0}' && cat ball.ply | '{1}' collide - floor.obj --json >piped.txt && cat ball.ply "
                  "| '{1}' collide /dev/stdin floor.obj --json >>piped.txt",
                  folder().string(), MEETC_MEET);
  REQUIRE(std::system(command.c_str()) == 0);
  std::istringstream piped(get(at("piped.txt")));
  for (std::string line; std::getline(piped, line);)
    CHECK(json::parse(line)["pairs"] == want);
  CHECK(run({"inspect", "-"}, "<'" + at("ball.ply") + "'").code == 0);
  // A name need not tell the format.
  fs::copy_file(at("floor.obj"), at("floor.dat"), fs::copy_options::overwrite_existing);
  CHECK(answer({"ball.ply", "floor.dat", "--format-b", "obj"})["pairs"] == want);
  CHECK(complaint({"collide", "ball.ply", "floor.dat", "--format-b", "step"}) ==
        "--format-b 'step': unknown; known: ply, obj, off, stl, csv");
}

TEST_CASE("one file is enough to inspect") {
  put("floor.obj", std::string(square) + "f 1 2 3\n");
  const said s = run({"inspect", "floor.obj"});
  CHECK(s.code == 0);
  CHECK(has(s.out, "A  floor.obj\n   kind        triangle: 1 face, 4 vertices\n"));
  CHECK_FALSE(has(s.out, "B  "));
  CHECK(has(complaint({"inspect", "floor.obj", "--scene", "s.toml"}), "--scene needs two files"));
}

TEST_CASE("a tolerance that makes nearly everything touch is told before the work") {
  put_mesh("ball.ply", meetc::bodies::icosphere(5));
  put_mesh("ring.ply", meetc::bodies::torus(96, 48));
  const said s = run({"collide", "ball.ply", "ring.ply", "--tolerance", "8", "--json"});
  CHECK(s.code == 0);
  CHECK(has(s.err,
            "meet: warning: --tolerance 8 rounds numbers to multiples of 2^2, where more than 100,000,000 pairs have a "
            "corner in common; finding them all takes long\n"));
  CHECK(run({"collide", "ball.ply", "ring.ply", "--tolerance", "0.001"}).err.empty());
}

TEST_CASE("the small files that people had trouble with, where they are") {
  const fs::path cases = fs::path(MEETC_DATA) / ".." / "cases";
  if (!fs::exists(cases))
    return;
  const auto path = [&](const std::string &name) { return (cases / name).string(); };
  const struct {
    const char *name;
    int pairs;
  } meshes[] = {{"01-coplanar-a", 1}, {"01-coplanar-b", 1},    {"02-axom152", 1},   {"03-contours1", 0},
                {"05-cgal2319", 1},   {"06-cgal6384", 1},      {"08-bvh543", 1},    {"08-bvh655", 0},
                {"08-bvh762-far", 0}, {"08-bvh762-inside", 0}, {"08-bvh762-on", 1}, {"11-open3d5117", 0},
                {"17-jgt10", 1},      {"54-georef", 1},        {"56-utm", 0}};
  for (const auto &[name, pairs] : meshes) {
    INFO(name);
    CHECK(answer({path(fmt::format("collide/{}/a.obj", name)), path(fmt::format("collide/{}/b.obj", name))})["pairs"] ==
          pairs);
  }
  for (const char *const told : {"54-georef", "56-utm"})
    CHECK(answer({path(fmt::format("collide/{}/a.obj", told)),
                  path(fmt::format("collide/{}/b.obj", told))})["rounded"]["numbers"] > 0);
  for (const char *const flat : {"46-falcor435", "71-geometri15"})
    CHECK(answer({path(fmt::format("collide/{}/a.csv", flat)), path(fmt::format("collide/{}/b.csv", flat))})["pairs"] ==
          1);
  for (const char *const dart : {"dart.obj", "dart.ply"})
    for (const char *const other : {"s.csv", "p.csv"})
      CHECK(answer({path(fmt::format("collide/20-concave/{}", dart)),
                    path(fmt::format("collide/20-concave/{}", other))})["pairs"] == 0);
  CHECK(pairs_of({path("collide/20-concave/L.obj"), path("collide/20-concave/notch.csv")}) ==
        pair_list{{0, 1}, {0, 2}});
  CHECK(pairs_of({path("collide/20-concave/hole.obj"), path("collide/20-concave/q.csv")}) ==
        pair_list{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}});

  // Each file of read/ holds the triangle of ok.obj, spheres, or what its name says; or it is refused.
  const std::set<std::string> refused{"s_nohead.csv",  "s_nan.csv",  "s_neg.csv",     "comma.obj",    "over.obj",
                                      "nanunused.obj", "ind.obj",    "4v.stl",        "binshort.stl", "binnanv.stl",
                                      "noend.stl",     "b_swap.csv", "strip.ply",     "floatidx.ply", "gz.obj.gz",
                                      "noext",         "nul.obj",    "bincount0.stl", "binffff.stl",  "nogeo.obj"};
  const std::map<std::string, std::string> kinds{
      {"wire.obj", "segment: 1 segment"}, {"pts.ply", "point: 1 point"}, {"pts2.ply", "point: 1 point"}};
  const std::map<std::string, std::string> notes{
      {"lines.obj", "left out beside the faces: 1 line, 1 point"},
      {"free.obj", "free-form curves and surfaces are left out: 'cstype' (line 4, once), 'deg' (line 5, once)"},
      {"call.obj", "statements that are no geometry are skipped: 'call' (line 1, once)"},
      {"unk.obj", "statements that are no geometry are skipped: 'xyzzy' (line 4, once)"},
      {"bintrail.stl", "left out: 5 bytes after the last facet"},
      {"s_extra.csv", "left out: the columns 'id'"}};
  std::size_t seen = 0;
  for (const auto &entry : fs::directory_iterator(cases / "read")) {
    const std::string name = entry.path().filename().string();
    INFO(name);
    ++seen;
    if (refused.contains(name)) {
      CHECK(has(complaint({"inspect", entry.path().string()}), name));
      continue;
    }
    const said s = run({"inspect", entry.path().string(), path("read/ok.obj")});
    INFO(s.err);
    CHECK(s.code == 0);
    const bool sphere = name.ends_with(".csv");
    const auto kind = kinds.find(name);
    CHECK(has(s.out, kind != kinds.end() ? kind->second : sphere ? "sphere: 1 sphere" : "triangle: "));
    if (const auto note = notes.find(name); note != notes.end())
      CHECK(has(s.out, note->second));
    if (sphere)
      CHECK(has(s.out, "box         [-0.30000004, -0.30000004, -1e-45] to [0.70000005, 0.70000005, 1.0000001]"));
  }
  CHECK(seen > 70);
}

TEST_CASE("bench read: each format beside the least that its file takes") {
  put_mesh("ball.ply", meetc::bodies::icosphere(4));
  const said s = run({"bench", "read", "--mesh", "ball.ply", "--repetitions", "3", "--json"});
  INFO(s.err);
  REQUIRE(s.code == 0);
  const json all = json::parse(s.out);
  std::set<std::string> files;
  for (const json &row : table(all, "read")) {
    files.insert(row["file"].get<std::string>());
    CHECK(row["reader"] > 0.0);
    CHECK(row["least"] > 0.0);
    CHECK(row["ratio"] > 0.0);
  }
  CHECK(files == std::set<std::string>{"mesh.obj", "rows.csv", "ascii.ply", "ascii.stl", "binary.ply", "binary.stl"});
}
