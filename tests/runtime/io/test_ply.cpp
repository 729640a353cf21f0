#include "fixture.hpp"

#include <algorithm>

using namespace fixture;

namespace {

using indices = std::vector<std::uint32_t>;

const std::string vertex_lines = "property float x\nproperty float y\nproperty float z\n";
const std::string face_line = "property list uchar int vertex_indices\n";

std::string mesh(const std::string &vertices, const std::string &faces, const std::string &body) {
  return "ply\nformat ascii 1.0\nelement vertex " + vertices + "\n" + vertex_lines + "element face " + faces + "\n" +
         face_line + "end_header\n" + body;
}
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string header_complaint(const std::string &lines) {
  return complaint("a.ply", "ply\n" + lines);
}

} // namespace

TEST_CASE("ascii PLY, with polygons", "[ply]") {
  const auto set = read("a.ply", mesh("4", "3", square + "3 0 1 2\n4 0 1 2 3\n3 3 2 1"));
  CHECK(set.kind == &triangle);
  CHECK(set.vertices == 4);
  CHECK(set.items == 3);
  CHECK(set.elements == 4);
  CHECK(set.data == std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  CHECK(set.index == indices{0, 1, 2, 0, 1, 2, 0, 2, 3, 3, 2, 1});
  CHECK(set.owner == indices{0, 1, 1, 2});
}

TEST_CASE("other contents of a PLY", "[ply]") {
  const auto set =
      read("a.PLY", "ply\r\ncomment first\r\nformat ascii 1.0\r\nobj_info made by hand\r\n"
                    "element before 1\r\nproperty list uint8 float32 many\r\nproperty int n\r\n"
                    "element face 1\r\nproperty uchar red\r\nproperty list uint8 uint32 vertex_index\r\n"
                    "property list char short more\r\n"
                    "element nothing 4000000000\r\n"
                    "element vertex 3\r\nproperty float z\r\nproperty list uchar double spare\r\n"
                    "property double y\r\nproperty short x\r\nproperty float nx\r\n"
                    "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\nend_header\r\n"
                    "2 1.5 2.5 7\r\n255 3 2 1 0 0\r\n\r\n3 0 2 1 nan\r\n6 1 9.5 5 4 x\r\n9 0 8 7 0\r\n1 2\r\n\r\n");
  CHECK(set.data == std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(set.index == indices{2, 1, 0});
  CHECK(set.owner.empty());
}

TEST_CASE("decimals of a double property round once too", "[ply]") {
  const auto set = read("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
                                 "property double z\nelement face 0\nend_header\n"
                                 "1.000000059604644775390625000001 1e-46 0.1\n");
  CHECK(set.data == std::vector<float>{0x1.000002p0F, 0, 0.1F});
  CHECK(set.elements == 1);
}

TEST_CASE("a PLY without faces is points, and one without vertices an error", "[ply]") {
  const auto set = read("a.ply", mesh("4", "0", square));
  CHECK(set.kind == &point);
  CHECK(set.elements == 4);
  CHECK(set.items == 4);
  CHECK(set.index.empty());
  CHECK(set.data == std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 1\n" + vertex_lines;
  CHECK(read("a.ply", header + "end_header\n1 2 3\n").kind == &point);
  CHECK(read("a.ply", header + "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n1 2 3\n0 0\n")
            .notes == std::vector<std::string>{"left out: 1 edge"});
  CHECK(complaint("a.ply", mesh("0", "0", "")) == "a.ply: no faces, lines or points to collide; it holds nothing");
  meetc::io::read_options how;
  how.kind = "point";
  CHECK(read("a.ply", mesh("4", "1", square + "3 0 1 2\n"), how).elements == 4);
}

TEST_CASE("a PLY with carriage returns alone", "[ply]") {
  std::string text = mesh("4", "1", square + "3 0 1 2\n");
  std::ranges::replace(text, '\n', '\r');
  CHECK(read("a.ply", text).elements == 1);
}

TEST_CASE("bad PLY headers", "[ply]") {
  const std::string begin = "format ascii 1.0\n";
  CHECK(complaint("a.ply", "plx\n") == "a.ply:1: the first line is 'plx', not 'ply'");
  CHECK_THAT(complaint("a.ply", std::string("\0\1\2", 3)), contains("the first line is '\\x00\\x01\\x02'"));
  CHECK(header_complaint("format ascii 2.0\n") == "a.ply:2: unknown version '2.0'; supported: 1.0");
  CHECK_THAT(header_complaint("format binary 1.0\n"), contains("a.ply:2: unknown format 'binary'; supported: ascii"));
  CHECK(header_complaint("format ascii\n") == "a.ply:2: the format's version is missing");
  CHECK(header_complaint(begin + begin) == "a.ply:3: a second format line");
  CHECK(header_complaint("end_header\n") == "a.ply:2: the header has no format line");
  CHECK(header_complaint(begin + "element vertex 3\n") == "a.ply:3: the header has no end_header");
  CHECK(header_complaint(begin + "elements vertex 3\n") == "a.ply:3: unknown header line 'elements'");
  CHECK(header_complaint(begin + "element vertex -3\n") ==
        "a.ply:3: the count of element 'vertex' is '-3', not a count");
  CHECK_THAT(header_complaint(begin + "element vertex 99999999999999999999\n"), contains("not a count"));
  CHECK(header_complaint(begin + "element vertex\n") == "a.ply:3: the element's count is missing");
  CHECK(header_complaint(begin + "element vertex 1 2\n") == "a.ply:3: '2' after the end of the header line");
  CHECK(header_complaint(begin + "element vertex 1\nelement vertex 1\n") == "a.ply:4: a second element vertex");
  CHECK(header_complaint(begin + "property float x\n") == "a.ply:3: a property before the first element");
  CHECK(header_complaint(begin + "element face 1\nproperty list float int vertex_indices\n") ==
        "a.ply:4: the count type of a list must be an integer type");
  CHECK(header_complaint(begin + "element face 1\nproperty list uchar long a\n") == "a.ply:4: unknown type 'long'");
  CHECK_THAT(header_complaint(begin + "element tristrips 1\n"),
             contains("a.ply:3: triangle strips (element tristrips)"));
}

TEST_CASE("headers that are not those of a mesh", "[ply]") {
  const auto header = [](const std::string &lines) {
    return header_complaint("format ascii 1.0\n" + lines + "end_header\n");
  };
  const std::string vertex = "element vertex 1\n" + vertex_lines, face = "element face 1\n" + face_line;
  CHECK_THAT(header(face), contains("a.ply: the header has no element vertex"));
  CHECK(header("element vertex 1\nproperty float x\nproperty float y\n" + face) ==
        "a.ply: element vertex has no property z");
  CHECK(header(vertex + "property float y\n" + face) == "a.ply: element vertex has property y twice");
  CHECK(header("element vertex 1\nproperty list uchar float x\nproperty float y\nproperty float z\n" + face) ==
        "a.ply: property x of element vertex is a list");
  CHECK(header(vertex + "element face 1\nproperty int a\n") ==
        "a.ply: element face has no property vertex_indices or vertex_index");
  CHECK(header(vertex + "element face 1\nproperty list uchar float vertex_index\n") ==
        "a.ply: property vertex_index of element face is not a list of integers");
  CHECK(header(vertex + face + "property list uchar int vertex_index\n") ==
        "a.ply: element face has two lists of vertex indices");
}

TEST_CASE("bad ascii PLY bodies name line, element and row", "[ply]") {
  const auto body = [](const std::string &faces, const std::string &text) {
    return complaint("a.ply", mesh("4", faces, square + text));
  };
  CHECK(body("1", "2 0 1\n") == "a.ply:14: face 0: 2 corners; a face has at least 3");
  CHECK(body("2", "3 0 1 2\n3 0 1 4\n") == "a.ply:15: face 1: vertex 4 does not exist; the file has 4, counted from 0");
  CHECK_THAT(body("1", "3 0 1 -1\n"), contains("a.ply:14: face 0: vertex -1 does not exist"));
  CHECK(body("1", "3 0 1\n") == "a.ply:14: face 0: the line has too few values");
  CHECK(body("1", "3 0 1 2 3\n") == "a.ply:14: face 0: '3' after the last value");
  CHECK(body("1", "3 0 1 2.5\n") == "a.ply:14: face 0: '2.5' is not an integer");
  CHECK(body("1", "256 0 1 2\n") == "a.ply:14: face 0: '256' does not fit the property's type");
  CHECK(body("2", "3 0 1 2\n") == "a.ply:14: the file ends after 1 of 2 rows of element 'face'");
  CHECK(body("1", "3 0 1 2\n3 0 1 2\n") == "a.ply:15: '3 0 1 2' after the last element");
  CHECK(body("4000000000", "3 0 1 2\n") ==
        "a.ply:13: 4000000000 rows of element 'face' take at least 2 bytes each, but 8 bytes are left");
  CHECK_THAT(complaint("a.ply", mesh("4000000000", "0", square)),
             contains("a.ply:9: 4000000000 rows of element 'vertex'"));
  CHECK(complaint("a.ply", mesh("9000000000", "0", square)) ==
        "a.ply: 9000000000 vertices; at most 4294967295 can be indexed");
  CHECK(complaint("a.ply", mesh("2", "0", "0 0 0\n0 0\n")) == "a.ply:11: vertex 1: the line has too few values");
  CHECK(complaint("a.ply", mesh("2", "0", "0 0 0\n0 0x1 0\n")) == "a.ply:11: vertex 1: '0x1' is not a number");
  CHECK(complaint("a.ply", mesh("2", "0", "0 0 0\ninf 0 0\n")) == "a.ply:11: vertex 1: x is inf, not finite");
  CHECK(complaint("a.ply", mesh("2", "0", "0 0 0\n0 -3.5e38 0\n")) ==
        "a.ply:11: vertex 1: y is -inf, not finite in float32 (read as -3.5e+38)");
}
