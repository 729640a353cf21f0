#include "fixture.hpp"

#include <limits>

using namespace fixture;

namespace {

using indices = std::vector<std::uint32_t>;

// Vertices of doubles and a list, faces of a list between others, and an element of neither kind.
std::string header(bool big, const std::string &vertices = "4", const std::string &faces = "2") {
  return std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\nelement odd 1\n" +
         "property ushort a\nproperty list int uchar b\nelement vertex " + vertices +
         "\nproperty double z\nproperty list ushort double spare\nproperty float x\nproperty int y\nelement "
         "face " +
         faces + "\nproperty uchar flag\nproperty list short uint vertex_index\nproperty list uchar char more\n" +
         "end_header\n";
}

std::string odd(std::endian order, std::int32_t count = 2) {
  std::string out;
  append(out, std::uint16_t{258}, order);
  append(out, count, order);
  return out + "ab";
}
std::string vertex(std::endian order, double x, double y, double z) {
  std::string out;
  append(out, z, order);
  append(out, std::uint16_t{1}, order);
  append(out, 7.5, order);
  append(out, static_cast<float>(x), order);
  append(out, static_cast<std::int32_t>(y), order);
  return out;
}
std::string face(std::endian order, const indices &corners, std::int16_t count) {
  std::string out = "f";
  append(out, count, order);
  for (const std::uint32_t c : corners)
    append(out, c, order);
  return out + '\1' + 'x';
}
std::string face(std::endian order, const indices &corners) {
  return face(order, corners, static_cast<std::int16_t>(corners.size()));
}
std::string vertices(std::endian order) {
  return vertex(order, 1, -2, 0.1) + vertex(order, 4, 5, 6) + vertex(order, 7, 8, 9) + vertex(order, 0, 0, 1e-300);
}

constexpr std::endian le = std::endian::little;
std::string complaint_of(const std::string &body) {
  return complaint("b.ply", header(false) + body);
}

} // namespace

TEST_CASE("binary PLY in both byte orders", "[ply]") {
  for (const bool big : {false, true}) {
    const std::endian order = big ? std::endian::big : std::endian::little;
    const auto set =
        read("b.ply", header(big) + odd(order) + vertices(order) + face(order, {0, 1, 2, 3}) + face(order, {3, 2, 1}));
    CHECK(set.data == std::vector<float>{1, -2, 0.1F, 4, 5, 6, 7, 8, 9, 0, 0, 0});
    CHECK(set.index == indices{1, 2, 3, 0, 1, 3, 3, 2, 1});
    CHECK(set.owner == indices{0, 0, 1});
    CHECK(set.items == 2);
    CHECK(set.vertices == 4);
  }
}

TEST_CASE("a binary body may begin with any byte after a CRLF header", "[ply]") {
  std::string text = "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 1\r\nproperty uchar x\r\n"
                     "property uchar y\r\nproperty uchar z\r\nelement face 0\r\nend_header\r\n\n\r\n";
  CHECK(read("b.ply", text).data == std::vector<float>{10, 13, 10});
}

TEST_CASE("bad binary PLY bodies", "[ply]") {
  const std::string start = odd(le) + vertices(le);
  const std::string one = face(le, {0, 1, 2});
  const std::size_t at = header(false).size();
  CHECK(complaint_of(start + one + face(le, {0, 1})) == "b.ply: face 1: 2 corners; a face has at least 3");
  CHECK(complaint_of(start + one + face(le, {0, 1, 4})) ==
        "b.ply: face 1: vertex 4 does not exist; the file has 4, counted from 0");
  CHECK_THAT(complaint_of(start + one + face(le, {0, 1, 0xffffffff})), contains("vertex 4294967295 does not exist"));
  CHECK(complaint_of(start + one + face(le, {0, 1, 2}, -1)) == "b.ply: face 1: the count of list 'vertex_index' is -1");
  CHECK(complaint_of(odd(le, -5)) == "b.ply: odd 0: the count of list 'b' is -5");
  const std::string whole = start + one + one;
  CHECK(complaint_of(whole + "more") ==
        "b.ply: byte " + std::to_string(at + whole.size()) + ": 4 bytes after the last element");
  CHECK(complaint_of(whole.substr(0, whole.size() - 1)) ==
        "b.ply: byte " + std::to_string(at + whole.size() - 1) + ": the file ends inside face 1");
  CHECK(complaint_of(odd(le, 1000) + vertices(le)) ==
        "b.ply: byte " + std::to_string(at + 8 + vertices(le).size()) + ": the file ends inside odd 0");
  CHECK_THAT(complaint_of(start + one + face(le, {0, 1, 2}, 32767)), contains("the file ends inside face 1"));
}

TEST_CASE("counts are checked before they are believed", "[ply]") {
  const std::string start = odd(le) + vertices(le);
  CHECK_THAT(complaint("b.ply", header(false, "4294967295") + start),
             contains("4294967295 rows of element 'vertex' take at least 18 bytes each, but 104 bytes are left"));
  CHECK_THAT(complaint("b.ply", header(false, "4", "4000000000") + start),
             contains("4000000000 rows of element 'face'"));
  CHECK_THAT(complaint("b.ply", header(false, "4", "9223372036854775807") + start), contains("rows of element 'face'"));
}

TEST_CASE("coordinates of binary PLY are finite", "[ply]") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(complaint_of(odd(le) + vertex(le, 0, 0, 0) + vertex(le, inf, 0, 0) + vertices(le)) ==
        "b.ply: vertex 1: x is inf, not finite");
  CHECK(complaint_of(odd(le) + vertex(le, 0, 0, -1e39) + vertices(le)) ==
        "b.ply: vertex 0: z is -inf, not finite in float32 (read as -1e+39)");
  CHECK_THAT(complaint_of(odd(le) + vertex(le, 0, 0, std::numeric_limits<double>::quiet_NaN()) + vertices(le)),
             contains("b.ply: vertex 0: z is nan, not finite"));
}
