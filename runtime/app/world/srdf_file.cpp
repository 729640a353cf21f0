#include "meet/app/world/srdf_file.hpp"

#include "meet/io/files/error.hpp"
#include "meet/io/files/file_bytes.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <set>
#include <utility>

namespace meetc::app {

namespace {

using link_pair = std::pair<std::string, std::string>; // the lesser name first

class srdf_reader {
public:
  srdf_reader(const std::filesystem::path &path, const std::vector<std::string> &names) : names_(names) {
    const io::file_bytes bytes = io::load_file(path);
    file_ = bytes.name;
    if (file_xml_.Parse(bytes.bytes.get(), bytes.size) != tinyxml2::XML_SUCCESS)
      fail(file_xml_.ErrorLineNum(), fmt::format("this is no XML: {}", fault()));
  }

  srdf_pairs read() {
    const tinyxml2::XMLElement *const robot = file_xml_.RootElement();
    if (!robot || robot->Name() != std::string_view("robot"))
      fail(robot ? robot->GetLineNum() : 1, "a <robot> is expected, as of an SRDF file");
    std::set<link_pair> disabled, enabled;
    std::set<std::string> by_default;
    for (const tinyxml2::XMLElement *e = robot->FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string_view name = e->Name();
      if (name == "disable_default_collisions")
        by_default.insert(known({link_of(*e, "link")})[0]);
      else if (name == "disable_collisions" || name == "enable_collisions")
        (name == "enable_collisions" ? enabled : disabled).insert(pair_of(*e));
    }
    srdf_pairs out;
    out.others = others_;
    for (std::size_t a = 0; a < names_.size(); ++a)
      for (std::size_t b = a + 1; b < names_.size(); ++b) {
        const link_pair pair = std::minmax(names_[a], names_[b]);
        const bool usually = by_default.contains(pair.first) || by_default.contains(pair.second);
        if (disabled.contains(pair) || (usually && !enabled.contains(pair)))
          out.allowed.push_back({pair.first, pair.second, file_});
      }
    return out;
  }

private:
  [[noreturn]] void fail(int line, const std::string &what) const {
    throw io::error(fmt::format("{}:{}: {}", file_, line, what));
  }
  // "mismatched element"
  std::string fault() const {
    constexpr std::string_view before = "XML_ERROR_";
    std::string name = file_xml_.ErrorName();
    name.erase(0, name.starts_with(before) ? before.size() : 4);
    std::ranges::replace(name, '_', ' ');
    return io::lower_case(name);
  }
  std::string link_of(const tinyxml2::XMLElement &e, const char *attribute) const {
    const char *const value = e.Attribute(attribute);
    if (!value || *value == '\0')
      fail(e.GetLineNum(), fmt::format("<{}> without {}", e.Name(), attribute));
    return value;
  }
  // Counts lines with a link that is no body.
  std::vector<std::string> known(std::vector<std::string> links) {
    const auto is_body = [this](const std::string &l) { return std::ranges::find(names_, l) != names_.end(); };
    others_ += std::ranges::all_of(links, is_body) ? 0 : 1;
    return links;
  }
  link_pair pair_of(const tinyxml2::XMLElement &e) {
    const std::vector<std::string> links = known({link_of(e, "link1"), link_of(e, "link2")});
    return std::minmax(links[0], links[1]);
  }

  const std::vector<std::string> &names_;
  std::string file_;
  tinyxml2::XMLDocument file_xml_;
  std::size_t others_ = 0;
};

} // namespace

srdf_pairs read_srdf(const std::filesystem::path &path, const std::vector<std::string> &names) {
  return srdf_reader(path, names).read();
}

} // namespace meetc::app
