#include "fixture.hpp"

using namespace fixture;

TEST_CASE("a CSV gives the kind that its header names", "[csv]") {
  const auto set = read("a.csv", "x,y,z,r\n1,2,3,0\n-4,5e1,+6,0.5\n");
  CHECK(set.kind == &sphere);
  CHECK(set.elements == 2);
  CHECK(set.items == 2);
  CHECK(set.vertices == 0);
  CHECK(set.index.empty());
  CHECK(set.owner.empty());
  CHECK(set.data == std::vector<float>{1, 2, 3, 0, -4, 50, 6, 0.5F});
  CHECK(read("a.csv", "x0,y0,z0,x1,y1,z1\n").kind == &segment);
  CHECK(read("A.CSV", "x0,y0,z0,x1,y1,z1,x2,y2,z2\n1,2,3,4,5,6,7,8,9").elements == 1);
}

TEST_CASE("blanks, CRLF, comments, a byte order mark and blank lines at the end are no matter", "[csv]") {
  const auto set = read("a.csv", "\xef\xbb\xbf# balls\r\n x , y,\tz,r \r\n# one\r\n 1 ,2, 3 ,4\r\n\r\n  \r\n#end\r\n");
  CHECK(set.kind == &sphere);
  CHECK(set.data == std::vector<float>{1, 2, 3, 4});
}

TEST_CASE("an unknown header lists the supported ones", "[csv]") {
  const std::string what = complaint("a.csv", "x,y\n1,2\n");
  CHECK_THAT(what, contains("a.csv:1: unknown header 'x,y'; supported: "));
  CHECK_THAT(what, contains("x,y,z,r (sphere)") && contains("x0,y0,z0,x1,y1,z1 (segment)"));
  CHECK_THAT(complaint("a.csv", "1,2,3,4\n"), contains("a.csv:1: unknown header '1,2,3,4'"));
  CHECK_THAT(complaint("a.csv", "\n\n# nothing\n"), contains("a.csv:3: unknown header ''"));
  CHECK_THAT(complaint("a.csv", "X,Y,Z,R\n"), contains("unknown header"));
}

TEST_CASE("bad rows name their line", "[csv]") {
  const auto row = [](const std::string &text) { return complaint("a.csv", "x,y,z,r\n0,0,0,0\n" + text + "\n"); };
  CHECK(row("1,2,3") == "a.csv:3: 3 fields, but the header x,y,z,r names 4");
  CHECK(row("1,2,3,4,5") == "a.csv:3: 5 fields, but the header x,y,z,r names 4");
  CHECK(row("1,2,3,4,") == "a.csv:3: 5 fields, but the header x,y,z,r names 4");
  CHECK(row("1,,3,4") == "a.csv:3: y is empty");
  CHECK(row("1,2,3z,4") == "a.csv:3: z is '3z', not a number");
  CHECK(row("1,2,0x3,4") == "a.csv:3: z is '0x3', not a number");
  CHECK(row("1 2 3 4") == "a.csv:3: 1 fields, but the header x,y,z,r names 4");
  CHECK(row("nan,2,3,4") == "a.csv:3: sphere 1: x is nan, not finite");
  CHECK(row("1,-inf,3,4") == "a.csv:3: sphere 1: y is -inf, not finite");
  CHECK(row("1,1e39,3,4") == "a.csv:3: sphere 1: y is inf, not finite in float32 (read as 1e+39)");
  CHECK(row("1,2,3,-1e-9") == "a.csv:3: sphere 1: r < 0");
  CHECK(row("1,2,3,\x01\x02\n") == "a.csv:3: r is '\\x01\\x02', not a number");
  CHECK(row("\n1,2,3,4") == "a.csv:4: a row after a blank line");
  // Below the smallest subnormal the radius becomes that of a point, which is allowed.
  CHECK(read("a.csv", "x,y,z,r\n1,2,3,-1e-99\n").data[3] == 0.0F);
}
