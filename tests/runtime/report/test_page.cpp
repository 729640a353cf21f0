// `meet collide --report`: the page that is written, and what is not.
#include "decode.hpp"
#include "tests/runtime/app/fixture.hpp"

using namespace fixture;

namespace {

pair_list pairs_in_page(const decoded::page &page) {
  const decoded::numbers a = page.differences(page.header["pairs"]["a"]),
                         b = page.differences(page.header["pairs"]["b"]);
  pair_list out;
  for (std::size_t i = 0; i < a.size(); ++i)
    out.emplace_back(a[i], b[i]);
  return out;
}

std::string fact(const decoded::page &page, const std::string &name) {
  for (const json &f : page.header["facts"])
    if (f[0] == name)
      return f[1];
  return "";
}

} // namespace

TEST_CASE("a report has the pairs, their contacts and what was decided") {
  const std::string a = put_mesh("a.ply", meetc::bodies::blob(48)), b = put_mesh("b.ply", meetc::bodies::figure(48));
  const std::vector<std::string> two = {a, b, "--translate-b", "0.75,0.25,0.25"};
  const pair_list pairs = pairs_of(two);
  REQUIRE(!pairs.empty());
  std::vector<std::string> asked = two;
  asked.insert(asked.end(), {"--report", at("out.html"), "--contacts", at("contacts.json")});
  const json counts = answer(asked);
  const std::string html = get(at("out.html"));
  const decoded::page page(html);
  CHECK(pairs_in_page(page) == pairs);
  CHECK(page.header["title"] == "a.ply and b.ply");
  CHECK(has(fact(page, "Precision"), "certified: no answer is wrong"));
  CHECK(fact(page, "B") == "b.ply, moved");
  CHECK(page.differences(page.header["contacts"]["pieces"]).size() ==
        2 * counts["contacts"]["pieces"].get<std::size_t>());
  const json written = json::parse(get(at("contacts.json")));
  CHECK(page.floats(page.header["contacts"]["points"]).size() == 3 * written["nodes"].size());
  answer(asked);
  CHECK(get(at("out.html")) == html);
}

TEST_CASE("a report of one mesh with itself has the pairs that --pairs writes") {
  const std::string a = put_mesh("self.ply", meetc::bodies::torus(32, 16));
  meetc::bodies::mesh twice = meetc::bodies::torus(32, 16);
  const std::size_t n = twice.vertices(), m = twice.index.size();
  for (std::size_t i = 0; i < 3 * n; ++i)
    twice.xyz.push_back(twice.xyz[i] + (i % 3 == 0 ? 0.5f : 0.25f));
  for (std::size_t i = 0; i < m; ++i)
    twice.index.push_back(twice.index[i] + static_cast<std::uint32_t>(n));
  const std::string both = put_mesh("twice.ply", twice);
  answer({both, "--self", "--pairs", at("self.csv"), "--report", at("self.html")});
  const decoded::page page(get(at("self.html")));
  const pair_list pairs = pairs_in(at("self.csv"));
  REQUIRE(!pairs.empty());
  CHECK(pairs_in_page(page) == pairs);
  CHECK(page.header["shapes"].size() == 1);
  CHECK(page.differences(page.header["contacts"]["pieces"]).size() >= pairs.size());
  answer({a, "--self", "--report", at("none.html")});
  CHECK(pairs_in_page(decoded::page(get(at("none.html")))).empty());
}

TEST_CASE("a report of polygons, with a tolerance, or where nothing touches") {
  const std::string square = put("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const std::string blade = put("blade.obj", "v .2 .2 -1\nv .8 .8 -1\nv .5 .6 1\nf 1 2 3\n");
  answer({square, blade, "--report", at("p.html")});
  const decoded::page page(get(at("p.html")));
  CHECK(pairs_in_page(page) == pair_list{{0, 0}});
  CHECK(page.differences(page.header["shapes"][0]["detail"]["items"]) == decoded::numbers{0, 0});
  answer({square, blade, "--tolerance", "0.125", "--report", at("t.html")});
  const decoded::page tolerant(get(at("t.html")));
  CHECK(has(fact(tolerant, "Precision"), "an answer may be wrong only where"));
  CHECK(tolerant.differences(tolerant.header["contacts"]["pieces"]).empty());
  answer({square, blade, "--translate-b", "5,0,0", "--report", at("apart.html")});
  CHECK(has(fact(decoded::page(get(at("apart.html"))), "Answer"), "Nothing touches"));
}

TEST_CASE("a report that cannot be written leaves none, and says why") {
  const std::string a = put_mesh("a.ply", meetc::bodies::torus(8, 8));
  fs::remove(at("out.png"));
  CHECK(has(complaint({"collide", a, a, "--report", at("out.png")}), "a report is a page of HTML; name it"));
  CHECK(!fs::exists(at("out.png")));
  CHECK(has(complaint({"collide", a, a, "--report", at("no/out.html")}), "no/out.html"));
  CHECK(has(complaint({"collide", a, a, "--any", "--report", at("out2.html")}), "--report need them all"));
  CHECK(!fs::exists(at("out2.html")));
  CHECK(has(complaint({"collide", a, a, "--report", a}), "a.ply"));
  const said full = run({"collide", a, a, "--report", "/dev/full"});
  CHECK(full.code != 0);
  CHECK(has(full.err, "/dev/full"));
  CHECK(has(complaint({"collide", a, "--self", "--report", at("out.png")}), "a report is a page of HTML"));
}

TEST_CASE("a report of many bodies has their poses and what touches in each frame") {
  put_mesh("ring.ply", meetc::bodies::torus(16, 8));
  put_mesh("ball.ply", meetc::bodies::icosphere(1));
  const std::string world = put("cell.json", R"({"bodies": [{"name": "one", "file": "ring.ply"},
    {"name": "two", "file": "ring.ply", "pose": [5, 0, 0, 1, 0, 0, 0]}, {"name": "ball", "file": "ball.ply"}]})");
  const std::string poses = put("poses.csv", "frame,body,x,y,z,qw,qx,qy,qz\n"
                                             "first,ball,10,0,0,1,0,0,0\nsecond,ball,1,0,0,1,0,0,0\n"
                                             "third,two,1,0,0,1,0,0,0\n");
  const std::vector<std::string> asked = {"--world", world, "--poses", poses, "--report", at("world.html")};
  const json said = answer(asked);
  const std::string html = get(at("world.html"));
  const decoded::page page(html);
  const json &h = page.header;
  REQUIRE(h["bodies"].size() == 3);
  CHECK(h["shapes"].size() == 2); // a file is in the page once
  CHECK(h["bodies"][1]["name"] == "two");
  CHECK(h["bodies"][1]["shape"] == h["bodies"][0]["shape"]);
  CHECK(h["bodies"][1]["pose"][3] == 5);
  REQUIRE(h["frames"].size() == 3);
  CHECK(h["frames"][0]["moved"][0][0] == 2);
  CHECK(h["frames"][0]["moved"][0][1][3] == 10);
  for (std::size_t f = 0; f < 3; ++f) {
    const json &touching = said["frames"][f]["touching"], &shown = h["frames"][f]["touching"];
    REQUIRE(touching.size() == shown.size());
    CHECK(h["frames"][f]["name"] == said["frames"][f]["frame"]);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      CHECK(h["bodies"][shown[i][0].get<std::size_t>()]["name"] == touching[i]["a"]);
      const auto pairs = touching[i]["pairs"].get<std::size_t>();
      CHECK(shown[i][2] == std::to_string(pairs) + (pairs == 1 ? " pair" : " pairs"));
    }
  }
  CHECK(said["frames"][0]["touching"].empty());
  CHECK(said["frames"][1]["touching"].size() == 1);
  CHECK(fact(page, "Answer") == "in 2 of 3 frames some bodies touch");
  answer(asked);
  CHECK(get(at("world.html")) == html);
  CHECK(has(complaint({"collide", "--world", world, "--any", "--report", at("any.html")}), "--report need them all"));
  CHECK(has(complaint({"collide", "--world", world, "--report", at("any.txt")}), "a report is a page of HTML"));
  CHECK(!fs::exists(at("any.html")));
}

TEST_CASE("a report of many bodies lists those that lie in one another, and says of which this is unknown") {
  put_mesh("big.ply", meetc::bodies::icosphere(2));
  put("open.obj", "v 3 -3 -3\nv -3 3 -3\nv -3 -3 3\nf 1 2 3\n");
  put("small.obj", "v 0 0 0\nv .1 0 0\nv 0 .1 0\nv 0 0 .1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const std::string cell = put("nest.json", R"({"bodies": [{"name": "big", "file": "big.ply"},
    {"name": "small", "file": "small.obj"}, {"name": "open", "file": "open.obj"}]})");
  answer({"--world", cell, "--report", at("nest.html")});
  const decoded::page page(get(at("nest.html")));
  CHECK(page.header["frames"][0]["touching"] == json::parse(R"([[1, 0, "inside"]])"));
  CHECK(fact(page, "Answer") == "nothing touches, 1 pair of bodies lies in one another");
  CHECK(has(page.header["notes"].dump(), "Unknown whether big or open is inside the other"));
}

TEST_CASE("a report does not take the place of a file that is read") {
  put_mesh("kept.ply", meetc::bodies::icosphere(1));
  const std::string text = R"({"bodies": [{"name": "one", "file": "kept.ply"}, {"name": "two", "file": "kept.ply"}]})";
  const std::string cell = put("cell", text),
                    poses = put("poses", "frame,body,x,y,z,qw,qx,qy,qz\n0,one,0,0,0,1,0,0,0\n");
  CHECK(has(complaint({"collide", "--world", cell, "--report", cell}), "is an input and would be overwritten"));
  CHECK(get(at("cell")) == text);
  CHECK(has(complaint({"collide", "--world", cell, "--poses", poses, "--report", poses}), "would be overwritten"));
}

TEST_CASE("a report of balls shows the witness of each pair") {
  const std::string one = put("one.csv", "x,y,z,radius\n0,0,0,1\n"),
                    two = put("two.csv", "x,y,z,radius\n1,0,0,1\n1.5,0,0,1\n");
  answer({one, two, "--report", at("balls.html")});
  const decoded::page page(get(at("balls.html")));
  CHECK(page.differences(page.header["contacts"]["single"]) == decoded::numbers{0, 1});
  CHECK(has(fact(page, "Contacts"), "2 witnesses"));
}
