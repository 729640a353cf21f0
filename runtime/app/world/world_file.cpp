#include "meet/app/world/world_file.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/text/json.hpp"
#include "meet/app/text/nearest.hpp"
#include "meet/app/world/body_pose.hpp"
#include "meet/io/files/file_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

// One reading of a file, whose messages name the place in it.
class world_reader {
public:
  explicit world_reader(const fs::path &path) : path_(path) {}

  world_source read() {
    const json all = parsed();
    only_keys(all, "the file", {"bodies", "allow"});
    world_source out;
    const json &bodies = all.contains("bodies") ? all["bodies"] : json::array();
    if (!bodies.is_array() || bodies.empty())
      fail("bodies", "a list of bodies is expected, such as [{\"name\": \"arm\", \"file\": \"arm.ply\"}]");
    for (std::size_t i = 0; i < bodies.size(); ++i)
      out.bodies.push_back(body(bodies[i], fmt::format("bodies[{}]", i)));
    if (all.contains("allow")) {
      const json &allow = all["allow"];
      if (!allow.is_array())
        fail("allow", "a list of pairs of names is expected, such as [[\"arm\", \"tool\"]]");
      for (std::size_t i = 0; i < allow.size(); ++i)
        out.allowed.push_back(allowed(allow[i], fmt::format("allow[{}]", i)));
    }
    return out;
  }

private:
  [[noreturn]] void fail(const std::string &place, const std::string &what) const {
    throw io::error(fmt::format("{}: {}: {}", path_.string(), place, what));
  }

  json parsed() const {
    const io::file_bytes bytes = io::load_file(path_);
    const std::string_view text = bytes.text();
    try {
      json all = json::parse(text.begin(), text.end());
      if (!all.is_object())
        fail("the file", "an object {\"bodies\": [...]} is expected");
      return all;
    } catch (const json::parse_error &e) {
      const std::string_view before = text.substr(0, e.byte > 0 ? e.byte - 1 : 0);
      const std::size_t line_start = before.rfind('\n') + 1; // 0 where there is none
      const std::string what = e.what();
      const std::size_t said = what.find("syntax error");
      throw io::error(fmt::format("{}:{}:{}: {}", path_.string(), std::ranges::count(before, '\n') + 1,
                                  before.size() - line_start + 1,
                                  said == std::string::npos ? "this is no JSON" : what.substr(said)));
    }
  }

  void only_keys(const json &object, const std::string &place, const std::vector<std::string> &known) const {
    for (const auto &[key, value] : object.items())
      if (std::ranges::find(known, key) == known.end())
        fail(place, fmt::format("unknown key {}{}", io::quote(key), nearest(key, known)));
  }

  std::string text_at(const json &object, const char *key, const std::string &place) const {
    const json &value = object[key];
    if (!value.is_string() || value.get<std::string>().empty())
      fail(place + "." + key, "a text is expected");
    return value.get<std::string>();
  }

  body_source body(const json &object, const std::string &place) const {
    if (!object.is_object())
      fail(place, "an object is expected, such as {\"name\": \"arm\", \"file\": \"arm.ply\"}");
    only_keys(object, place, {"name", "file", "pose"});
    if (!object.contains("file"))
      fail(place, "\"file\" is missing");
    body_source out;
    out.place = fmt::format("{}: {}", path_.string(), place);
    const fs::path file = text_at(object, "file", place);
    out.file = file.is_absolute() ? file : path_.parent_path() / file;
    out.name = object.contains("name") ? text_at(object, "name", place) : file.stem().string();
    if (object.contains("pose"))
      out.at = pose_of(numbers_of(object["pose"], place + ".pose"), fmt::format("{}: {}.pose", path_.string(), place));
    return out;
  }

  std::vector<double> numbers_of(const json &value, const std::string &place) const {
    std::vector<double> out;
    const auto add = [&](const json &x) {
      if (!x.is_number())
        fail(place, "a list of numbers is expected");
      out.push_back(x.get<double>());
    };
    if (!value.is_array())
      fail(place, "a list of numbers is expected");
    for (const json &x : value)
      if (x.is_array()) // a row
        std::ranges::for_each(x, add);
      else
        add(x);
    return out;
  }

  name_pair allowed(const json &value, const std::string &place) const {
    if (!value.is_array() || value.size() != 2 || !value[0].is_string() || !value[1].is_string())
      fail(place, "a pair of names is expected, such as [\"arm\", \"tool\"]");
    return {value[0].get<std::string>(), value[1].get<std::string>(), fmt::format("{}: {}", path_.string(), place)};
  }

  const fs::path &path_;
};

} // namespace

world_source read_world(const fs::path &path) {
  return world_reader(path).read();
}

world_source world_of_files(const std::vector<fs::path> &files) {
  world_source out;
  std::map<std::string, int> seen;
  for (const fs::path &file : files) {
    if (file == "-")
      throw io::error("-: standard input is no body; each of many is a file");
    const std::string name = file.stem().string();
    const int times = ++seen[name];
    out.bodies.push_back({times == 1 ? name : fmt::format("{} {}", name, times), file, {}});
  }
  return out;
}

} // namespace meetc::app
