#include "fixture.hpp"

#include <algorithm>
#include <limits>

using namespace fixture;

namespace {

std::string binary(const std::vector<float> &rows, const std::string &header = "solid by some program") {
  std::string out = header;
  out.resize(80, ' ');
  append(out, static_cast<std::uint32_t>(rows.size() / 9));
  for (std::size_t i = 0; i < rows.size(); i += 9) {
    for (int n = 0; n < 3; ++n)
      append(out, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t k = 0; k < 9; ++k)
      append(out, rows[i + k]);
    out.append("\1\2");
  }
  return out;
}

const std::string facet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 .5\n endloop\n"
                          "endfacet\n";

} // namespace

TEST_CASE("binary STL, even when it begins with solid", "[stl]") {
  const std::vector<float> rows{1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto set = read("a.stl", binary(rows));
  CHECK(set.kind == &triangle);
  CHECK(set.data == rows);
  CHECK(set.index.empty());
  CHECK(set.elements == 2);
  CHECK(set.items == 2);
  CHECK(set.vertices == 6);
  CHECK(complaint("a.stl", binary({}, "")) == "a.stl: no facets to collide; it holds nothing");
}

TEST_CASE("ascii STL, in several solids", "[stl]") {
  const auto set =
      read("a.STL", "solid two words\r\n" + facet + "endsolid two words\nSOLID\n" + facet + "EndSolid\n\n");
  CHECK(set.elements == 2);
  CHECK(std::vector<float>(set.data.begin(), set.data.begin() + 9) == std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, .5F});
  CHECK(complaint("a.stl", "\n solid x\nendsolid") == "a.stl: no facets to collide; it holds nothing");
}

TEST_CASE("ascii STL as people write it", "[stl]") {
  const std::vector<float> rows{0, 0, 0, 1, 0, 0, 0, 1, .5F};
  const auto same = [&](const std::string &text) { return read("a.stl", text).data == rows; };
  const std::string solid = "solid a\n" + facet + "endsolid a\n";
  std::string returns = solid, one_line = solid;
  std::ranges::replace(returns, '\n', '\r');
  std::ranges::replace(one_line, '\n', ' ');
  CHECK(same(returns));
  CHECK(same(one_line));
  CHECK(read("a.stl", one_line + one_line).elements == 2);
  CHECK(same("# by hand\n ; and more\n" + solid + "# end\n"));
  CHECK(same("solid a\n; one\nfacet normal 0 0 1\nouter loop # two\nvertex 0 0 0\nvertex 1 0\n#three\n0 vertex\n0 1 "
             ".5\nendloop endfacet\nendsolid\n"));
  CHECK(same("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 .5\nendloop\nendfacet\nendsolid"));
  CHECK(
      same("solid\nfacet normal\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 .5\nendloop\nendfacet\nendsolid"));
  CHECK(same("solid facet of the sun\n" + facet + "endsolid facet of the sun\n"));
  CHECK(same(solid + "\x1a"));
}

TEST_CASE("bad binary STL", "[stl]") {
  const std::string good = binary({1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(complaint("a.stl", good.substr(0, 133)) ==
        "a.stl: byte 80: the header says 1 facets, which take 134 bytes, but the file has 133");
  CHECK(read("a.stl", good + "x").notes == std::vector<std::string>{"left out: 1 bytes after the last facet"});
  CHECK_THAT(complaint("a.stl", good + good.substr(84)), contains("but the file has 184"));
  std::string none = good;
  none[80] = 0;
  CHECK_THAT(complaint("a.stl", none), contains("the header says 0 facets, which take 84 bytes, but the file has 134"));
  std::string lie = good;
  lie.replace(80, 4, "\xff\xff\xff\xff");
  CHECK_THAT(complaint("a.stl", lie), contains("the header says 4294967295 facets, which take 214748364834 bytes"));
  CHECK_THAT(complaint("a.stl", std::string("ab\0", 3)),
             contains("a.stl: byte 3: neither ascii STL nor a whole header"));
  CHECK(complaint("a.stl", "abc") == "a.stl:1: 'abc' where solid was expected");
  CHECK(complaint("a.stl", binary({1, 2, 3, 4, std::numeric_limits<float>::infinity(), 6, 7, 8, 9})) ==
        "a.stl: facet 0: corner 1: y is inf, not finite");
}

TEST_CASE("bad ascii STL", "[stl]") {
  const auto text = [](const std::string &body) { return complaint("a.stl", "solid a\n" + body); };
  CHECK(text(facet) == "a.stl:8: the file ends before endsolid");
  CHECK(text("facet normal 0 0 1\nouter loop\nvertex 1 2\n") == "a.stl:4: the file ends before endsolid");
  CHECK(text("facet normal 0 0 1\nouter loop\nvertex 1 2 endloop\n") ==
        "a.stl:4: facet 0: corner 0: 'endloop' is not a number");
  CHECK(text("facet normal 0 0 1\nouter loop\nvertex 1 2 inf\n") == "a.stl:4: facet 0: corner 0: z is inf, not finite");
  CHECK(text("facet normal 0 0 1\nouter loop\nvertex 1 2 3\nendloop\n") ==
        "a.stl:5: facet 0: 'endloop' where vertex was expected");
  CHECK(text("facet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\n") ==
        "a.stl:7: facet 0: 'vertex' where endloop was expected");
  CHECK(text("triangle\n") == "a.stl:2: 'triangle' where facet or endsolid was expected");
  CHECK(text("endsolid\nmore\n") == "a.stl:3: 'more' where solid was expected");
}
