#include "fixture.hpp"

using namespace fixture;

namespace {
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
using indices = std::vector<std::uint32_t>;
} // namespace

TEST_CASE("OBJ polygons are fanned from their first corner", "[obj]") {
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
                                     "l 1 2\np 1\n");
  CHECK(set.index == indices{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 3});
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
  CHECK(read("a.obj", "v 1 2 3 1\nv 1 2 3 .1 .2 .3\nv 1 2 3 1 .1 .2 .3").vertices == 3);
}

TEST_CASE("an empty mesh is one", "[obj]") {
  const auto set = read("a.obj", "# nothing\n");
  CHECK(set.elements == 0);
  CHECK(set.items == 0);
  CHECK(set.vertices == 0);
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
  for (const char *const corner : {"0", "a", "1.5", "3/", "3/x", "3/1/", "3//", "/1", "3/0", "3/1/1/1", "3//1/"}) {
    INFO(corner);
    CHECK_THAT(line(std::string("f 1 2 ") + corner), contains("a.obj:5: face 0: "));
  }
  CHECK_THAT(line("v 1 2"), contains("a.obj:5: vertex 4: 2 numbers"));
  CHECK_THAT(line("v 1 2 3 4 5"), contains("a.obj:5: vertex 4: 5 numbers"));
  CHECK_THAT(line("v 1 2 3 4 5 6 7 8"), contains("more than 7 numbers"));
  CHECK(line("v 1 2 3f") == "a.obj:5: vertex 4: '3f' is not a number");
  CHECK(line("v 1 nan 3") == "a.obj:5: vertex 4: y is nan, not finite");
  CHECK(line("v 1 2 1e99") == "a.obj:5: vertex 4: z is inf, not finite in float32 (read as 1e+99)");
  CHECK(line("cstype bezier") == "a.obj:5: unknown or unsupported statement 'cstype'");
  CHECK(line("F 1 2 3") == "a.obj:5: unknown or unsupported statement 'F'");
  CHECK_THAT(complaint("a.obj", "\x89PNG\r\n\x1a\n"), contains("a.obj:1: unknown or unsupported statement '\\x89PNG'"));
}
