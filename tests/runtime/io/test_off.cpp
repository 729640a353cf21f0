#include "fixture.hpp"

using namespace fixture;

namespace {
using indices = std::vector<std::uint32_t>;
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
} // namespace

TEST_CASE("OFF and COFF", "[off]") {
  const std::string faces = "3 0 1 2\n4 0 1 2 3\n";
  for (const std::string &text :
       {"OFF\n4 2 0\n" + square + faces, "OFF 4 2 5\n" + square + faces,
        "OFF # a square\n\n# 4 2\n4 2\n" + square + faces,
        std::string("\xef\xbb\xbfOFF\r\n4 2 0\r\n0 0 0\r\n1 0 0 # c\r\n\r\n#\r\n 1 1 0\r\n0 1 0\r\n3 0 1 2 # c\r\n4 0 "
                    "1 2 3\r\n"),
        std::string("COFF\n4 2 0\n0 0 0 255 0 0 255\n1 0 0 1 0 0\n1 1 0 .5 .5 .5\n0 1 0 0 0 0 0\n"
                    "3 0 1 2 255 0 0\n4 0 1 2 3 1 0.5 0 1\n")}) {
    const auto set = read("a.off", text);
    CHECK(set.kind == &triangle);
    CHECK(set.data == std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    CHECK(set.index == indices{0, 1, 2, 0, 1, 2, 0, 2, 3});
    CHECK(set.items == 2);
  }
  CHECK(read("a.OFF", "OFF\n4 0 0\n" + square).kind == &point);
}

TEST_CASE("bad OFF", "[off]") {
  const auto what = [](const std::string &text) { return complaint("a.off", text); };
  for (const char *const kind : {"STOFF", "NOFF", "4OFF", "nOFF", "CNOFF", "STCN4OFF"})
    CHECK(what(std::string(kind) + "\n3 1 0\n") ==
          "a.off:1: '" + std::string(kind) + "': this kind of OFF is not supported; OFF and COFF in ascii are");
  CHECK(what("OFF BINARY\n") == "a.off:1: 'OFF BINARY': this kind of OFF is not supported; OFF and COFF in ascii are");
  CHECK(what("8 6 0\n") == "a.off:1: the first word is '8', not OFF or COFF");
  CHECK(what("# x\n") == "a.off:1: an OFF file begins with OFF or COFF");
  CHECK(what("OFF\n") == "a.off:1: the file ends before the numbers of vertices and faces");
  CHECK(what("OFF\n4\n") == "a.off:2: the number of faces is '', not a count");
  CHECK(what("OFF\n4 -1\n") == "a.off:2: the number of faces is '-1', not a count");
  CHECK(what("OFF\n4 1 0 7\n") == "a.off:2: '7' after the numbers of vertices, faces and edges");
  const std::string start = "OFF\n4 1 0\n" + square;
  CHECK(what(start + "3 0 1 4\n") == "a.off:7: face 0: vertex 4 does not exist; the file has 4, counted from 0");
  CHECK(what(start + "2 0 1\n") == "a.off:7: face 0: 2 corners; a face has at least 3");
  CHECK(what(start + "3 0 1\n") == "a.off:7: face 0: the line has too few values");
  CHECK(what(start + "3 0 1 2 red\n") == "a.off:7: face 0: 'red' is not a number");
  CHECK(what(start + "3 0 1 2\n3 0 1 2\n") == "a.off:8: '3 0 1 2' after the last element");
  CHECK(what(start) == "a.off:6: 1 rows of element 'face' take at least 2 bytes each, but 0 bytes are left");
  CHECK(what("OFF\n1 0 0\n0 0\n") == "a.off:3: vertex 0: the line has too few values");
  CHECK(what("OFF\n1 0 0\n0 0 0 1\n") ==
        "a.off:3: vertex 0: 4 numbers; x y z, and perhaps a colour of 3 or 4, were expected");
  CHECK(what("OFF\n1 0 0\n0 nan 0\n") == "a.off:3: vertex 0: y is nan, not finite");
  CHECK(what("OFF\n0 0 0\n") == "a.off: no faces, lines or points to collide; it holds nothing");
}
