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
}

TEST_CASE("columns are found by name, in any order and case", "[csv]") {
  const std::vector<float> want{1, 2, 3, .5F};
  for (const char *const text :
       {"r,x,y,z\n.5,1,2,3\n", "X,Y,Z,R\n1,2,3,.5\n", "x;y;z;r\n1;2;3;.5\n", "x;y;z;r\n1;2;3;0,5\n",
        "x\ty\tz\tr\n1\t2\t3\t.5\n", "\"x\",\"y\",\"z\",\"r\"\n1,2,3,.5\n", "x,y,z,radius\n\"1\",2,\" 3 \",.5\n",
        "Z,Radius,x,y\n3,.5,1,2", "x,y,z,r,g,b,radius\n1,2,3,9,9,9,.5\n"}) {
    INFO(text);
    const auto set = read("a.csv", text);
    CHECK(set.kind == &sphere);
    CHECK(set.data == want);
  }
  const auto more = read("a.csv", "id,x,y,z,r,name\n7,1,2,3,.5,\"a, b\"\n,1,2,3,.5,c\n");
  CHECK(more.elements == 2);
  CHECK(more.notes == std::vector<std::string>{"left out: the columns 'id', 'name'"});
  CHECK(read("a.csv", "x,y,z,red,green,blue\n1,2,3,4,5,6\n").kind == &point);
  CHECK(read("a.csv", "x1,y1,z1,x0,y0,z0\n4,5,6,1,2,3\n").data == std::vector<float>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("a header that fits two kinds is refused with the option that chooses", "[csv]") {
  const std::string colours = "x,y,z,r,g,b\n1,2,3,.5,0,0\n";
  CHECK(complaint("a.csv", colours) == "a.csv:1: the header 'x,y,z,r,g,b' fits point or sphere; choose with --kind-b");
  CHECK(complaint("a.csv", "x,y,z,x0,y0,z0,x1,y1,z1\n") ==
        "a.csv:1: the header 'x,y,z,x0,y0,z0,x1,y1,z1' fits segment or point; choose with --kind-b");
  meetc::io::read_options how;
  how.kind = "point";
  CHECK(read("a.csv", colours, how).data == std::vector<float>{1, 2, 3});
  how.kind = "sphere";
  CHECK(read("a.csv", colours, how).data == std::vector<float>{1, 2, 3, .5F});
  how.kind = "segment";
  how.move.side = 'a';
  CHECK(complaint("a.csv", colours, how) ==
        "a.csv:1: the header 'x,y,z,r,g,b' does not have the columns x0,y0,z0,x1,y1,z1 of --kind-a segment");
}

TEST_CASE("a column that is there twice is refused", "[csv]") {
  CHECK(complaint("a.csv", "x,y,z,r,R\n1,2,3,4,5\n") == "a.csv:1: the header 'x,y,z,r,R' has the column 'r' twice");
  CHECK(complaint("a.csv", "x,y,z,radius,Radius\n1,2,3,4,5\n") ==
        "a.csv:1: the header 'x,y,z,radius,Radius' has the column 'radius' twice");
  CHECK(complaint("a.csv", "x,x,y,z\n1,2,3,4\n") == "a.csv:1: the header 'x,x,y,z' has the column 'x' twice");
}

TEST_CASE("moved numbers are counted in the columns that are read", "[csv]") {
  const auto set = read("a.csv", "id,x,y,z,r\n433832.18,433832.18,0.1,16777217,1\n1,\"433832.18\",0,0,0\n");
  CHECK(set.rounded.numbers == 3);
  CHECK(set.rounded.largest == 1);
  CHECK(read("a.csv", "x;y;z;r\n43383218,5;0;0;0\n").rounded.numbers == 1);
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
  CHECK(row("\"1,2,3,4") == "a.csv:3: a quote is not closed");
  CHECK(row("\n1,2,3,4") == "a.csv:4: a row after a blank line");
  // Below the smallest subnormal the radius becomes that of a point, which is allowed.
  CHECK(read("a.csv", "x,y,z,r\n1,2,3,-1e-99\n").data[3] == 0.0F);
}
