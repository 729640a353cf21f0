// Many bodies on the command line: who touches whom, frame by frame.
#include "fixture.hpp"
#include "tests/runtime/picture/decode.hpp"

using namespace fixture;

namespace {

// Cubes with sides of length 1 about the origin, and a ball of radius 0.25.
void put_files() {
  put_mesh("cube.ply", meetc::bodies::block(1, 1, 1, 0));
  put_mesh("slab.ply", meetc::bodies::block(8, 1, 8, 0));
  put("ball.csv", "x,y,z,r\n0,0,0,0.25\n");
}

std::string world(const std::string &bodies, const std::string &more = "") {
  return put("cell.json", "{\"bodies\": [" + bodies + "]" + more + "}");
}

// "arm-tool" for each two that touch in a frame, in their order.
std::vector<std::string> touching(const json &all, std::size_t frame = 0) {
  std::vector<std::string> out;
  for (const json &t : all["frames"].at(frame)["touching"])
    out.push_back(t["a"].get<std::string>() + "-" + t["b"].get<std::string>());
  return out;
}

using names = std::vector<std::string>;

constexpr const char *three = R"({"name": "left", "file": "cube.ply", "pose": [1,0,0,-0.75, 0,1,0,0, 0,0,1,0]},
  {"name": "right", "file": "cube.ply", "pose": [0.75,0,0,1,0,0,0]},
  {"file": "ball.csv", "pose": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})";

} // namespace

TEST_CASE("three files and more are bodies that stand as they are") {
  put_files();
  const json all = answer({"cube.ply", "slab.ply", "ball.csv", "cube.ply"});
  CHECK(touching(all) == names{"cube-slab", "cube-cube 2", "slab-cube 2"});
  CHECK(all["bodies"].size() == 4);
  CHECK(all["bodies"][2] == json{{"name", "ball"}, {"kind", "sphere"}, {"elements", 1}});
  const said s = run({"collide", "cube.ply", "slab.ply", "ball.csv", "cube.ply"});
  CHECK(s.code == 0);
  CHECK(has(s.out, "cube    12 faces"));
  CHECK(has(s.out, "cube - slab ("));
  CHECK(has(s.out, " pairs)\ncube - cube 2 (")); // each two on a line
}

TEST_CASE("two files are bodies on request, and then one may lie inside the other") {
  put_files();
  put("seed.csv", "x,y,z,r\n0,0,0,0.25\n");
  const said two = run({"collide", "cube.ply", "seed.csv"}),
             bodies = run({"collide", "--bodies", "cube.ply", "seed.csv"});
  CHECK(has(two.out, "wholly inside one does not touch it (--bodies tells of it)"));
  for (const std::vector<std::string> &more : {names{"--precision", "fp32"}, names{"--translate-b", "0,0,0.125"}}) {
    std::vector<std::string> words{"collide", "cube.ply", "seed.csv"}; // of which --bodies would tell nothing
    words.insert(words.end(), more.begin(), more.end());
    const std::string out = run(words).out;
    CHECK((has(out, "does not touch it.") && !has(out, "--bodies")));
  }
  CHECK(has(bodies.out, "seed inside cube\n"));
  CHECK(has(bodies.out, "certified, on the CPU: 1 pair of bodies near each other, "));
  CHECK(answer({"--bodies", "cube.ply", "seed.csv"})["frames"][0]["inside"] ==
        json{{{"inner", "seed"}, {"outer", "cube"}}});
}

TEST_CASE("of many bodies of which it is unknown, the first eight are told") {
  put_files();
  put("inward.obj", "v -1 -1 -1\nv 3 -1 -1\nv -1 3 -1\nv -1 -1 3\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  std::vector<std::string> all{"inward.obj"};
  for (int i = 0; i < 10; ++i)
    all.emplace_back("ball.csv");
  const auto unknown_in = [](const std::string &text) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find("Unknown whether inward or ball", at)) != std::string::npos; ++at)
      ++n;
    return n;
  };
  const std::string said_of_all = run({"collide", "inward.obj", "ball.csv", "ball.csv"}).out;
  CHECK(unknown_in(said_of_all) == 2);
  CHECK(has(said_of_all, " -1 times, so that its normals point inwards."));
  std::vector<std::string> many{"collide"};
  many.insert(many.end(), all.begin(), all.end());
  const std::string said_of_many = run(many).out;
  CHECK(unknown_in(said_of_many) == 8);
  CHECK(has(said_of_many, "It is unknown of 2 pairs of bodies more, which JSON lists."));
}

TEST_CASE("bodies whose numbers float32 does not hold say so, each file once") {
  put_files();
  put("far.csv", "x,y,z,r\n433832.18,0,0,0.5\n");
  const json all = answer({"cube.ply", "far.csv", "far.csv"});
  CHECK(all["rounded"]["numbers"] == 1);
  CHECK(has(run({"collide", "cube.ply", "far.csv", "far.csv"}).out, "Rounded to float32: 1 number of far.csv moved"));
  put("notch.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n"); // a quadrangle that is not planar
  const json noted = answer({"cube.ply", "notch.obj", "far.csv"});
  REQUIRE(noted["notes"].size() == 1);
  CHECK(has(noted["notes"][0].get<std::string>(), "notch.obj: "));
}

TEST_CASE("a world file places bodies, and closed ones touch where they meet in a plane") {
  put_files();
  world(three);
  CHECK(touching(answer({"--world", "cell.json"})) == names{"left-ball", "right-ball"}); // at x = -0.25 and 0.25
  world(R"({"name": "left", "file": "cube.ply", "pose": [-0.5,0,0, 1,0,0,0]},
           {"name": "right", "file": "cube.ply", "pose": [0.5,0,0, 1,0,0,0]},
           {"name": "far", "file": "cube.ply", "pose": [1.50000001,0,0, 0,0,0,2]})"); // turned by half, exactly; not in float32
  CHECK(touching(answer({"--world", "cell.json"})) == names{"left-right", "right-far"});
}

TEST_CASE("pairs that may touch, and the only ones that are asked about") {
  put_files();
  world(three, R"(, "allow": [["ball", "left"]])");
  CHECK(touching(answer({"--world", "cell.json"})) == names{"right-ball"});
  CHECK(touching(answer({"--world", "cell.json", "--allow", "ball,*"})).empty());
  world(three);
  CHECK(touching(answer({"--world", "cell.json", "--only", "left,*"})) == names{"left-ball"});
  CHECK(touching(answer({"--world", "cell.json", "--only", "left,right"})).empty());
  CHECK(touching(answer({"--world", "cell.json", "--allow", "left,ball", "--allow", "right, ball"})).empty());
}

TEST_CASE("poses move bodies frame by frame, and those that are not named stay") {
  put_files();
  world(three);
  put("poses.csv", "frame,body,x,y,z,qw,qx,qy,qz\n"
                   "# the ball goes to the left\n"
                   "0,ball,-0.125,0,0,1,0,0,0\n"
                   "\n"
                   "1,ball,-9,9,0,1,0,0,0\n1,left,0.75,9,0,0,0,3,0\n"
                   "last,right,0,9,0,1,0,0,0\n");
  const json all = answer({"--world", "cell.json", "--poses", "poses.csv"});
  REQUIRE(all["frames"].size() == 3);
  CHECK(touching(all, 0) == names{"left-ball"});
  CHECK(touching(all, 1).empty());
  CHECK(touching(all, 2) == names{"left-right"});
  CHECK(all["frames"][2]["frame"] == "last");
  const said s = run({"collide", "--world", "cell.json", "--poses", "poses.csv"});
  CHECK(has(s.out, "frame 0     left - ball ("));
  CHECK(has(s.out, "frame 1     nothing touches"));
  put("matrices.csv", "frame,body,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n0,ball,1,0,0,9,0,1,0,0,0,0,1,0\n");
  CHECK(touching(answer({"--world", "cell.json", "--poses", "matrices.csv"})).empty());
}

namespace {
// Whether the picture of these words shows elements that touch.
bool yellow_shown(const std::vector<std::string> &words, const std::string &said_of_it) {
  std::vector<std::string> all{"collide", "--image", "cell.png", "--size", "640x360"};
  all.insert(all.end(), words.begin(), words.end());
  const said s = run(all);
  INFO(s.out << s.err);
  CHECK(s.code == 0);
  CHECK(has(s.out, "wrote cell.png" + said_of_it + "\n"));
  const std::string png = get(at("cell.png"));
  const meetc::picture::image picture = meetc::picture::decode(png);
  CHECK(picture.width == 640);
  std::size_t yellow = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
    yellow += picture.rgb[i] > 200 && picture.rgb[i + 1] > 150 && picture.rgb[i + 2] < 60;
  return yellow > 20;
}
} // namespace

TEST_CASE("a picture shows the bodies of the first frame in which some touch") {
  put_files();
  world(three);
  CHECK(yellow_shown({"--world", "cell.json"}, ""));
  CHECK_FALSE(yellow_shown({"--world", "cell.json", "--allow", "ball,*"}, ""));
  const std::string header = "frame,body,x,y,z,qw,qx,qy,qz\n";
  put("poses.csv", header + "0,ball,0,9,0,1,0,0,0\nlater,ball,0,0,0,1,0,0,0\n");
  CHECK(yellow_shown({"--world", "cell.json", "--poses", "poses.csv"}, ", frame later"));
  put("poses.csv", header + "0,ball,0,9,0,1,0,0,0\n1,ball,0,8,0,1,0,0,0\n");
  CHECK_FALSE(yellow_shown({"--world", "cell.json", "--poses", "poses.csv"}, ", frame 0"));
  std::vector<std::string> many;
  for (int i = 0; i < 70; ++i)
    many.emplace_back(i % 2 == 0 ? "cube.ply" : "ball.csv");
  CHECK(yellow_shown(many, ""));
  const auto complaint = [](const char *option, const char *value) {
    return run({"collide", "--world", "cell.json", option, value}).err;
  };
  CHECK(has(complaint("--camera", "0,0"), "--camera: it is about a picture; write --image out.png as well"));
  CHECK(has(complaint("--image", "cell.jpg"), "pictures are PNG; name it cell.png"));
  CHECK(
      has(run({"collide", "--world", "cell.json", "--any", "--image", "no.png"}).err, "--any stops at the first pair"));
  CHECK_FALSE(fs::exists(at("no.png")));
}

TEST_CASE("the pairs of each two bodies are those of the two files") {
  put_files();
  world(R"({"name": "a", "file": "cube.ply"}, {"name": "b", "file": "slab.ply", "pose": [0.25,0.25,0, 1,0,0,0]},
           {"name": "c", "file": "ball.csv", "pose": [9,9,9, 1,0,0,0]})");
  const json all = answer({"--world", "cell.json", "--pairs", "out"});
  CHECK(touching(all) == names{"a-b"});
  answer({"cube.ply", "slab.ply", "--translate-b", "0.25,0.25,0", "--pairs", "two.csv"});
  CHECK(get(at("out/a_b.csv")) == get(at("two.csv")));
  CHECK(!get(at("two.csv")).empty());
}

TEST_CASE("any stops, and a touch may be a failure") {
  put_files();
  world(three);
  const json any = answer({"--world", "cell.json", "--any"});
  CHECK(touching(any) == names{"left-ball"});
  CHECK(run({"collide", "--world", "cell.json", "--fail-on-touch"}).code == 1);
  CHECK(run({"collide", "--world", "cell.json", "--fail-on-touch", "--allow", "ball,*"}).code == 0);
  CHECK(run({"collide", "cube.ply", "slab.ply", "--fail-on-touch"}).code == 1);
  CHECK(run({"collide", "cube.ply", "ball.csv", "--fail-on-touch"}).code == 0);
}

TEST_CASE("a body inside another is told, and is a touch to those who must not have one") {
  put_files();
  put("dust.csv", "x,y,z,r\n0.25,0,0,0.125\n3,0,0,0.125\n");
  meetc::bodies::mesh open = meetc::bodies::block(4, 4, 4, 0);
  const std::set<std::uint32_t> lost(open.index.end() - 3, open.index.end());
  open.index.resize(open.index.size() - 3);
  std::size_t beside = 0; // the first face that had an edge of the lost one
  while (lost.contains(open.index[3 * beside]) + lost.contains(open.index[3 * beside + 1]) +
             lost.contains(open.index[3 * beside + 2]) <
         2)
    ++beside;
  put_mesh("crate.ply", meetc::bodies::block(4, 4, 4, 0));
  put_mesh("open.ply", open);
  const std::vector<std::string> three_in{"crate.ply", "cube.ply", "dust.csv"};
  const json all = answer(three_in);
  const json &frame = all["frames"][0];
  CHECK(touching(all).empty());
  CHECK(frame["inside"] == json::parse(R"([{"inner": "cube", "outer": "crate"}])"));
  CHECK(frame["overlapping"] == json::parse(R"([{"a": "crate", "b": "dust"}, {"a": "cube", "b": "dust"}])"));
  CHECK(frame["unknown"].empty());
  const auto run_with = [&](std::vector<std::string> words, const std::vector<std::string> &more) {
    words.insert(words.begin(), "collide");
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  CHECK(has(run_with(three_in, {}).out, "cube inside crate\ncrate - dust (overlap, no surfaces touch)"));
  CHECK(run_with(three_in, {}).code == 0);
  CHECK(run_with(three_in, {"--fail-on-touch"}).code == 1);
  CHECK(run_with(three_in, {"--fail-on-touch", "--allow", "crate,*", "--allow", "cube,dust"}).code == 0);
  CHECK(has(run_with(three_in, {"--any"}).out, "\ncube inside crate\n"));
  CHECK(run_with(three_in, {"--any", "--fail-on-touch"}).code == 1);

  // A touch comes before all that lie inside, and a surface holds nothing; nor is anything told where pairs may be wrong.
  CHECK(touching(answer({"crate.ply", "cube.ply", "cube.ply", "--any"})) == names{"cube-cube 2"});
  CHECK(answer({"crate.ply", "cube.ply", "cube.ply", "--any"})["frames"][0]["inside"].empty());
  for (const auto &[option, value] : {std::pair("--mode", "surface"), std::pair("--precision", "fp32")}) {
    const json without = answer({"crate.ply", "cube.ply", "cube.ply", option, value});
    CHECK_FALSE(without["frames"][0].contains("inside"));
  }
  CHECK(run_with({"crate.ply", "cube.ply", "dust.csv"}, {"--mode", "surface", "--fail-on-touch"}).code == 0);

  world(R"({"file": "open.ply"}, {"file": "cube.ply"})");
  put("poses.csv", "frame,body,x,y,z,qw,qx,qy,qz\n0,cube,0,0,0,1,0,0,0\n1,cube,9,0,0,1,0,0,0\n2,cube,1,0,0,1,0,0,0\n");
  const std::string why =
      fmt::format("element {} of open has an edge where the surface is open or not oriented", beside);
  const json unknown = answer({"--world", "cell.json", "--poses", "poses.csv"});
  CHECK(unknown["frames"][0]["unknown"] == json{{{"a", "open"}, {"b", "cube"}, {"why", why}}});
  CHECK(unknown["frames"][1]["unknown"].empty());
  const said s = run({"collide", "--world", "cell.json", "--poses", "poses.csv", "--fail-on-touch"});
  CHECK(has(s.out, "Unknown whether open or cube is inside the other, in 2 of 3 frames: " + why + "."));
  CHECK(s.code == 0);
}

TEST_CASE("a fault of a world is one line that names the place") {
  put_files();
  const auto fault_of = [](const std::string &bodies, const std::string &more = "") {
    world(bodies, more);
    return complaint({"collide", "--world", "cell.json"});
  };
  CHECK(has(fault_of("{\"file\": \"cube.ply\"", ""), "cell.json:1:32: syntax error"));
  CHECK(has(fault_of(""), "cell.json: bodies: a list of bodies is expected"));
  CHECK(has(fault_of("{\"name\": \"a\"}"), "cell.json: bodies[0]: \"file\" is missing"));
  CHECK(
      has(fault_of("{\"file\": \"cube.ply\", \"poses\": []}"), "bodies[0]: unknown key 'poses'; did you mean 'pose'?"));
  CHECK(has(fault_of("{\"file\": \"cube.ply\", \"pose\": [1,2]}"), "bodies[0].pose: 2 numbers; a pose is"));
  CHECK(has(fault_of("{\"file\": \"cube.ply\", \"pose\": [0,0,0,0,0,0,0]}"), "the quaternion is 0"));
  CHECK(has(fault_of("{\"file\": \"cube.ply\", \"pose\": [1,0,0,0, 0,2,0,0, 0,0,1,0]}"), "this is no motion"));
  CHECK(has(fault_of("{\"file\": \"cube.ply\", \"pose\": \"x\"}"), "bodies[0].pose: a list of numbers is expected"));
  CHECK(has(fault_of("{\"file\": \"none.ply\"}"), "none.ply"));
  CHECK(has(fault_of("{\"file\": \"cube.ply\"}, {\"file\": \"cube.ply\"}"),
            "cell.json: bodies[1]: body cube: the name is taken"));
  CHECK(has(fault_of("{\"file\": \"cube.ply\"}", ", \"allow\": [[\"cubes\", \"*\"]]"),
            "allow[0]: no body is named 'cubes'; did you mean 'cube'?"));
  CHECK(has(fault_of("{\"file\": \"cube.ply\"}", ", \"allow\": [\"cube\"]"), "allow[0]: a pair of names is expected"));
  CHECK(has(fault_of("{\"name\": \"a\", \"file\": \"cube.ply\", \"pose\": [1,0,0,1e39, 0,1,0,0, 0,0,1,0]}, {\"file\": "
                     "\"cube.ply\"}"),
            "cell.json: body a, element 0: x0 becomes inf under the pose"));
  world(three);
  const auto fault_of_poses = [](const std::string &rows) {
    put("poses.csv", rows);
    return complaint({"collide", "--world", "cell.json", "--poses", "poses.csv"});
  };
  const std::string head = "frame,body,x,y,z,qw,qx,qy,qz\n";
  CHECK(has(fault_of_poses("frame,body\n"), "poses.csv:1: the first line is neither"));
  CHECK(has(fault_of_poses(head), "poses.csv: no row follows the first line"));
  CHECK(has(fault_of_poses(head + "0,ball,0,0,0\n"), "poses.csv:2: 5 fields, but the first line names 9"));
  CHECK(has(fault_of_poses(head + "0,rigt,0,0,0,1,0,0,0\n"),
            "poses.csv:2: no body is named 'rigt'; did you mean 'right'?"));
  CHECK(has(fault_of_poses(head + "0,ball,0,x,0,1,0,0,0\n"), "poses.csv:2: y is 'x', not a number"));
  CHECK(has(fault_of_poses(head + "0,ball,0,nan,0,1,0,0,0\n"), "poses.csv:2: a number of the pose is not finite"));
  CHECK(has(fault_of_poses(head + "0,ball,0,0,0,1,0,0,0\n0,ball,0,0,0,1,0,0,0\n"),
            "poses.csv:3: frame '0' has a pose of 'ball'"));
  CHECK(has(fault_of_poses(head + "0,ball,0,0,0,1,0,0,0\n1,ball,0,0,0,1,0,0,0\n0,left,0,0,0,1,0,0,0\n"),
            "poses.csv:4: frame '0' begins a second time"));
}

TEST_CASE("options of two sets and of many bodies do not mix in silence") {
  put_files();
  world(three);
  CHECK(has(complaint({"collide", "cube.ply", "slab.ply", "ball.csv", "--translate-b", "1,0,0"}),
            "--translate-b: it is for two sets, and not for many bodies"));
  CHECK(has(complaint({"collide", "cube.ply", "slab.ply", "--translate-a", "1", "2", "3"}),
            "--translate-a: it is for two sets, and not for many bodies; 2 is taken for a file, since commas separate "
            "numbers, as in 1,2,3"));
  CHECK(has(complaint({"collide", "cube.ply", "--bodies"}), "--bodies: name two files or more"));
  CHECK(has(complaint({"collide", "--world", "cell.json", "--pairs", "out.csv"}),
            "--pairs out.csv: for many bodies it is a folder, with a file for each two that touch; name it out"));
  CHECK(has(complaint({"collide", "--world", "cell.json", "--first", "x.csv"}), "--first: it is for two sets"));
  CHECK(has(complaint({"collide", "cube.ply", "slab.ply", "--poses", "p.csv"}), "--poses: it is for many bodies"));
  CHECK(has(complaint({"collide", "cube.ply", "--world", "cell.json"}), "cube.ply: --world lists all bodies"));
  CHECK(has(complaint({"collide", "--world", "cell.json", "--only", "left"}), "two names with a comma"));
  CHECK(has(complaint({"collide", "--world", "cell.json", "--mode", "soft"}), "--mode 'soft': unknown"));
  CHECK(has(complaint({"collide", "--world", "cell.json", "--any", "--pairs", "out"}), "--any stops"));
  CHECK_FALSE(fs::exists(at("out/pairs.csv")));
}
