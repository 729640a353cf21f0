// Reads and checks the meaning of a predicate.
#include "gen/lang/relations.hpp"

#include <fmt/format.h>

namespace meetc::lang {
namespace {

struct word {
  const char *text;
  meaning means;
};
const word words[] = {{"touch", meaning::touch},
                      {"beyond", meaning::beyond},
                      {"overlap", meaning::overlap},
                      {"contains", meaning::contains}};

} // namespace

std::string text_of(const predicate &p) {
  for (const word &w : words)
    if (w.means == p.means)
      return p.common == 0 ? w.text : fmt::format("{} {} common point{}", w.text, p.common, p.common == 1 ? "" : "s");
  return "";
}

void read_meaning(const toml_reader &in, const toml::table &t, const std::string &what, predicate &p) {
  if (const toml::node *means = t.get("means")) {
    p.means_where = in.place(*means);
    const std::string name = in.as_string(*means, what + ".means");
    std::vector<std::string> known;
    bool found = false;
    for (const word &w : words) {
      known.emplace_back(w.text);
      if (name == w.text)
        p.means = w.means, found = true;
    }
    if (!found)
      throw spec_error(p.means_where, fmt::format("{}.means is 'touch', 'beyond', 'overlap' or 'contains'{}", what,
                                                  nearest(name, known)));
    if (p.means != meaning::touch && p.mode == "surface")
      throw spec_error(p.means_where,
                       fmt::format("the elements of mode = 'surface' can only touch; leave out means = '{}', or write "
                                   "mode = 'solid'",
                                   name));
  }
  if (const toml::node *common = t.get("common")) {
    p.common_where = in.place(*common);
    if (p.means != meaning::beyond)
      throw spec_error(p.common_where, fmt::format("{}.common goes with means = 'beyond' alone: a hit is then a point "
                                                   "beyond the common ones",
                                                   what));
    p.common = static_cast<int>(in.as_whole_number(*common, what + ".common", 1, 16));
  }
}

void check_meaning(const algebra &a, const predicate &p) {
  if (p.means == meaning::touch)
    return;
  for (const field &f : p.of) {
    const kind *k = a.find_kind(f.type);
    if (!k || (!k->hull && !k->position))
      throw spec_error(p.means_where, fmt::format("'{}' is judged by exact geometry of hulls, and the kind {} of {} "
                                                  "has none; leave out 'means', or give the kind a hull",
                                                  text_of(p), f.type, f.name));
    if (p.means == meaning::beyond && k->pad)
      throw spec_error(p.means_where, fmt::format("'{}' is a meaning of hulls, and the kind {} of {} has a pad; leave "
                                                  "out 'means'",
                                                  text_of(p), f.type, f.name));
    const std::size_t points = !k->hull ? 1 : k->hull->kind == op::list ? k->hull->args.size() : 16;
    if (static_cast<std::size_t>(p.common) > points)
      throw spec_error(p.common_where, fmt::format("{} common points, but the hull of {}, of kind {}, has {}; write at "
                                                   "most that many",
                                                   p.common, f.name, f.type, points));
  }
}

} // namespace meetc::lang
