#include "fixture.hpp"

using namespace fixture;
using namespace std::string_literals;

namespace {
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
using indices = std::vector<std::uint32_t>;
} // namespace

TEST_CASE("OBJ polygons are cut into triangles", "[obj]") {
  const auto set = read("a.obj", square + "f 1 2 3\nf 1 2 3 4\nf 4 3 2\n");
  CHECK(set.kind == &triangle);
  CHECK(set.vertices == 4);
  CHECK(set.items == 3);
  CHECK(set.elements == 4);
  CHECK(set.index == indices{0, 1, 2, 0, 1, 2, 0, 2, 3, 3, 2, 1});
  CHECK(set.owner == indices{0, 1, 1, 2});
  float row[9];
  set.row(2, row);
  CHECK(std::vector<float>(row, row + 9) == std::vector<float>{0, 0, 0, 1, 1, 0, 0, 1, 0});
  CHECK(read("a.obj", square + "f 1 2 3\n").owner.empty());
}

TEST_CASE("all forms of a corner, and statements that carry no face", "[obj]") {
  const auto set = read("a.obj", "# a mesh\r\nmtllib a b.mtl\r\no it\r\n" + square +
                                     "vt 0 0\nvn 0 0 1\ng a\nusemtl m\ns off\n"
                                     "f 1/1 2/1 3/1\nf 1//1 2//1 3//1 # c\nf 1/1/1 2/1/1 +3/1/1\nf -4 -3 -1\n"
                                     "f 1// 2/ 3/1/#c\nl 1 2\np 1\n");
  CHECK(set.index == indices{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 3, 0, 1, 2});
  CHECK(set.notes == std::vector<std::string>{"left out beside the faces: 1 line, 1 point"});
}

TEST_CASE("negative indices count from the last vertex so far", "[obj]") {
  const auto set = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -3 -2 -1\nf 1 2 5\nv 5 5 5\n");
  CHECK(set.index == indices{0, 1, 2, 1, 2, 3, 0, 1, 4});
}

TEST_CASE("a backslash continues a line, but not a comment", "[obj]") {
  const auto set = read("a.obj", "# C:\\meshes\\\nv 0 0 0\nv 1 \\\n 0 \\\r\n 0\nv 0 1 0\nf 1 2 \\\n3\n");
  CHECK(set.vertices == 3);
  CHECK(set.index == indices{0, 1, 2});
  CHECK(complaint("a.obj", square + "f 1 \\\n2 \\\n9\n") == "a.obj:5: face 0: vertex 9 does not exist; the file has 4");
  CHECK_THAT(complaint("a.obj", "v 0 0 \\"), contains("a.obj:1: the file ends after a backslash"));
}

TEST_CASE("weights and colours after a vertex are passed over", "[obj]") {
  CHECK(read("a.obj", "v 1 2 3 1\nv 1 2 3 .1 .2 .3\nv 1 2 3 1 .1 .2 .3\nf 1 2 3").vertices == 3);
}

TEST_CASE("without faces, lines are segments and points are points", "[obj]") {
  const auto lines = read("a.obj", square + "l 1 2 3\nl 4/1 -4\n");
  CHECK(lines.kind == &segment);
  CHECK(lines.index == indices{0, 1, 1, 2, 3, 0});
  CHECK(lines.owner == indices{0, 0, 1});
  CHECK(lines.items == 2);
  CHECK(lines.elements == 3);
  CHECK(read("a.obj", square + "l 1 2\n").owner.empty());
  const auto points = read("a.obj", square + "p 1 3\np -1\n");
  CHECK(points.kind == &point);
  CHECK(points.index == indices{0, 2, 3});
  CHECK(points.items == 3);
  const std::string both = square + "l 1 2\nl 2 3\np 1\n";
  CHECK(complaint("a.obj", both) ==
        "a.obj: it holds 2 lines and 1 point; choose with --kind-b segment or --kind-b point");
  const auto as = [](const std::string &kind) {
    meetc::io::read_options how;
    how.kind = kind;
    return how;
  };
  CHECK(read("a.obj", both, as("segment")).elements == 2);
  CHECK(read("a.obj", both, as("point")).elements == 1);
  CHECK(read("a.obj", both + "f 1 2 3\n", as("segment")).notes ==
        std::vector<std::string>{"left out beside the lines: 1 face, 1 point"});
  CHECK(read("a.obj", both + "f 1 2 3\n").kind == &triangle);
  CHECK(complaint("a.obj", both, as("triangle")) ==
        "a.obj: no faces to collide; it holds 4 vertices, 2 lines, 1 point");
  CHECK_THAT(complaint("a.obj", both, as("sphere")), contains("a.obj: --kind-b 'sphere'"));
  CHECK_THROWS_WITH(read("a.obj", both, as("frob")), contains("--kind-b 'frob': unknown; known: triangle, segment, "));
}

TEST_CASE("an OBJ with nothing to collide is an error that says what it holds", "[obj]") {
  CHECK(complaint("a.obj", "# nothing\n") == "a.obj: no faces, lines or points to collide; it holds nothing");
  CHECK(complaint("a.obj", "v 1 2 3\n") == "a.obj: no faces, lines or points to collide; it holds 1 vertex");
  CHECK(complaint("a.obj", "\x89PNG\r\n\x1a\n") ==
        "a.obj: no faces, lines or points to collide; it holds nothing; statements that are no geometry are skipped: "
        "'\\x89PNG' (line 1, once)");
}

TEST_CASE("statements without geometry are skipped with a note", "[obj]") {
  const auto set =
      read("a.obj", "call other.obj\n" + square + "xyzzy 1\ncstype bezier\nxyzzy 2\ndeg 3\nF 1 2 3\nf 1 2 3\n\x1a");
  CHECK(set.elements == 1);
  CHECK(set.notes ==
        std::vector<std::string>{
            "free-form curves and surfaces are left out: 'cstype' (line 7, once), 'deg' (line 9, once)",
            "statements that are no geometry are skipped: 'call' (line 1, once), 'xyzzy' (line 6, 2 times), "
            "'F' (line 10, once)"});
  CHECK(complaint("a.obj", square + "f 1 2 3\n\0"s) == "a.obj:6: a NUL byte, which no OBJ holds");
  CHECK(complaint("a.obj", square + "\x01 1\nf 1 2 3\n") == "a.obj:5: unknown or unsupported statement '\\x01'");
}

TEST_CASE("many skipped statements are counted the same in any number of pieces", "[obj]") {
  std::string text = square + "f 1 2 3\n";
  for (int round = 0; round < 3; ++round)
    for (int i = 0; i < 100; ++i)
      text += "k" + std::to_string(i) + " 1\n";
  for (const std::size_t bytes : {std::size_t{1} << 30, std::size_t{64}, std::size_t{500}}) {
    const auto set = read("many.obj", text, meetc::io::read_options{.threads = 2, .piece_bytes = bytes});
    REQUIRE(set.notes.size() == 1);
    CHECK_THAT(set.notes[0], contains("'k0' (line 6, 3 times)") && contains("'k7' (line 13, 3 times) and 276 others"));
  }
}

TEST_CASE("a carriage return alone ends a line", "[obj]") {
  CHECK(read("a.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").index == indices{0, 1, 2});
  CHECK(complaint("a.obj", "v 0 0 0\rv 1 0 0\r\nv 0 x 0\rf 1 2 3\r") == "a.obj:3: vertex 2: 'x' is not a number");
}

TEST_CASE("bad OBJ lines name their line", "[obj]") {
  const auto line = [](const std::string &text) { return complaint("a.obj", square + text + "\n"); };
  CHECK(line("f 1 2") == "a.obj:5: face 0: 2 corners; a face has at least 3");
  CHECK(line("f") == "a.obj:5: face 0: 0 corners; a face has at least 3");
  CHECK(line("f 1 2 3\nf 1 2 5\nf 1 2 3") == "a.obj:6: face 1: vertex 5 does not exist; the file has 4");
  CHECK(line("f 1 2 -5") == "a.obj:5: face 0: vertex -5 does not exist; the file has 4 so far");
  CHECK_THAT(line("f 1 2 9999999999"), contains("a.obj:5: face 0: vertex 9999999999 does not exist"));
  CHECK_THAT(line("f 1 2 4294967295"), contains("a.obj:5: face 0: vertex 4294967295 does not exist"));
  CHECK_THAT(line("f 1 2 99999999999999999999"), contains("is not a corner"));
  for (const char *const corner : {"0", "a", "1.5", "3/x", "/1", "3/0", "3/1/1/1", "3//1/", "3///", "//"}) {
    INFO(corner);
    CHECK_THAT(line(std::string("f 1 2 ") + corner), contains("a.obj:5: face 0: "));
  }
  CHECK_THAT(line("v 1 2"), contains("a.obj:5: vertex 4: 2 numbers"));
  CHECK_THAT(line("v 1 2 3 4 5"), contains("a.obj:5: vertex 4: 5 numbers"));
  CHECK_THAT(line("v 1 2 3 4 5 6 7 8"), contains("more than 7 numbers"));
  CHECK(line("v 1 2 3f") == "a.obj:5: vertex 4: '3f' is not a number");
  CHECK(line("v 1 nan 3") == "a.obj:5: vertex 4: y is nan, not finite");
  CHECK(line("v 1 2 1e99") == "a.obj:5: vertex 4: z is inf, not finite in float32 (read as 1e+99)");
  CHECK(line("l 1") == "a.obj:5: line 0: 1 corners; a line has at least 2");
  CHECK(line("p") == "a.obj:5: point 0: 0 vertices; a point has at least 1");
  CHECK(line("l 1 7") == "a.obj:5: line 0: vertex 7 does not exist; the file has 4");
}
