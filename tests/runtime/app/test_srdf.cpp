// Pairs of links that may touch, from a robot's SRDF file.
#include "fixture.hpp"

using namespace fixture;

namespace {

// Three cubes in a row, which all touch.
void put_robot() {
  put_mesh("cube.ply", meetc::bodies::block(1, 1, 1, 0));
  put("cell.json", R"({"bodies": [{"name": "base", "file": "cube.ply"},
                                  {"name": "arm & hand", "file": "cube.ply", "pose": [0.5,0,0,1,0,0,0]},
                                  {"name": "tool", "file": "cube.ply", "pose": [1,0,0,1,0,0,0]}]})");
}

const std::vector<std::string> command{"collide", "--world", "cell.json", "--srdf", "robot.srdf"};

json answer_with(const std::string &lines) {
  put("robot.srdf", "<?xml version=\"1.0\"?>\n<!-- links -->\n<robot name=\"r\">\n" + lines + "</robot>\n");
  return answer({command.begin() + 1, command.end()});
}
std::set<std::string> touching(const json &all) {
  std::set<std::string> out;
  for (const json &t : all["frames"][0]["touching"])
    out.insert(t["a"].get<std::string>() + "-" + t["b"].get<std::string>());
  return out;
}
using pairs = std::set<std::string>;

} // namespace

TEST_CASE("pairs of links that an SRDF file disables may touch, in either order") {
  put_robot();
  CHECK(touching(answer_with("")) == pairs{"base-arm & hand", "base-tool", "arm & hand-tool"});
  const json all = answer_with("<group name='g'><link name='base'/></group>\n"
                               "<disable_collisions link1='arm &amp; hand' link2=\"base\" reason='Adjacent'/>\n"
                               "<disable_collisions link1='base' link2='wheel' reason='Never'>\n</disable_collisions>\n"
                               "<disable_collisions link1='door' link2='wheel'/>\n");
  CHECK(touching(all) == pairs{"base-tool", "arm & hand-tool"});
  CHECK(all["notes"] == json{"robot.srdf: 1 pair of bodies may touch; 2 lines name a link that is no body"});
  std::vector<std::string> more = command;
  more.insert(more.end(), {"--allow", "base,tool", "--only", "base,*"});
  const said s = run(more);
  CHECK(has(s.out, "nothing touches"));
  CHECK(has(s.out, "robot.srdf: 1 pair of bodies may touch; 2 lines name a link that is no body"));
}

TEST_CASE("a link may be disabled with all others but some") {
  put_robot();
  CHECK(touching(answer_with("<disable_default_collisions link='base'/>\n")) == pairs{"arm & hand-tool"});
  CHECK(touching(answer_with("<disable_default_collisions link='base'/>\n<enable_collisions link1='tool' "
                             "link2='base'/>\n")) == pairs{"base-tool", "arm & hand-tool"});
  CHECK(touching(answer_with("<enable_collisions link1='tool' link2='base'/>\n<disable_collisions link1='base' "
                             "link2='tool'/>\n<disable_default_collisions link='base'/>\n")) ==
        pairs{"arm & hand-tool"});
  CHECK(touching(answer_with("<disable_default_collisions link='wheel'/>\n")).size() == 3);
}

TEST_CASE("a fault of an SRDF file is one line that names the place") {
  put_robot();
  const auto fault_of = [](const std::string &text) {
    put("robot.srdf", text);
    return complaint(command);
  };
  CHECK(has(fault_of("<robot>\n<disable_collisions link1='a'/>\n</robot>"),
            "robot.srdf:2: <disable_collisions> without link2"));
  CHECK(has(fault_of("<robot>\n\n<disable_collisions link1='' link2='b'/></robot>"),
            "robot.srdf:3: <disable_collisions> without link1"));
  CHECK(has(fault_of("<robot>\n<disable_default_collisions/></robot>"),
            "robot.srdf:2: <disable_default_collisions> without link"));
  CHECK(has(fault_of("<robot>\n<group>\n</robot>"), "robot.srdf:2: this is no XML: mismatched element"));
  CHECK(has(fault_of("<robot>\n<disable_collisions link1='a'"), "robot.srdf:2: this is no XML: "));
  CHECK(has(fault_of("<robot"), "robot.srdf:1: this is no XML: "));
  CHECK(has(fault_of("link1,link2\n"), "robot.srdf:1: this is no XML: "));
  CHECK(has(fault_of("<?xml version='1.0'?>\n<sdf/>"), "robot.srdf:2: a <robot> is expected, as of an SRDF file"));
  CHECK(has(fault_of("<!-- nothing -->"), "robot.srdf:1: a <robot> is expected"));
  std::string deep = "<robot>";
  for (int i = 0; i < 100000; ++i)
    deep += "<a>";
  CHECK(has(fault_of(deep), "robot.srdf:1: this is no XML: "));
  CHECK(has(complaint({"collide", "--world", "cell.json", "--srdf", "none.srdf"}), "none.srdf"));
  CHECK(has(complaint({"collide", "cube.ply", "cube.ply", "--srdf", "robot.srdf"}), "--srdf: it is for many bodies"));
}
