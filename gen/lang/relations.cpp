#include "gen/lang/relations.hpp"

#include <fmt/format.h>

namespace meetc::lang {
namespace {

// Splits 'a = b' at its only '=' that is not a part of a comparison.
relation read_relation(const toml_reader &in, const toml::node &node, const std::string &what, bool nearly) {
  const expr_source all = in.inside(node, what);
  const std::string &text = all.file->text;
  std::size_t at = all.end;
  for (std::size_t i = all.begin; i < all.end; ++i) {
    if (text[i] != '=')
      continue;
    const bool comparison = (i > all.begin && std::string_view("<>!=").find(text[i - 1]) != std::string_view::npos) ||
                            (i + 1 < all.end && text[i + 1] == '=');
    if (comparison || at != all.end)
      throw spec_error({all.file, i, 1}, "a relation is one equation: write 'a = b', as in 'motor * rev(motor) = 1'");
    at = i;
  }
  if (at == all.end)
    throw spec_error(in.place(node), "a relation is an equation: write 'a = b', as in 'motor * rev(motor) = 1'");
  return {parse_expression({all.file, all.begin, at}), parse_expression({all.file, at + 1, all.end}), nearly,
          in.place(node)};
}

struct word {
  const char *text;
  meaning means;
};
const word words[] = {{"touch", meaning::touch},
                      {"beyond", meaning::beyond},
                      {"overlap", meaning::overlap},
                      {"contains", meaning::contains}};

} // namespace

void read_relations(const toml_reader &in, const toml::table &t, const std::string &what, kind &k) {
  if (const toml::node *node = t.get("relations")) {
    const std::string here = what + ".relations";
    const toml::table &r = in.as_table(*node, here);
    in.allow(r, here, {"is", "nearly", "within"});
    for (const bool nearly : {false, true})
      if (const toml::node *list = r.get(nearly ? "nearly" : "is"))
        for (const toml::node &item : in.as_array(*list, here + (nearly ? ".nearly" : ".is")))
          k.relations.push_back(read_relation(in, item, "each item of " + here, nearly));
    if (const toml::node *within = r.get("within"))
      k.within = in.as_positive_number(*within, here + ".within");
    const bool nearly = r.contains("nearly");
    if (nearly && k.within == 0)
      throw spec_error(
          in.place(*r.get("nearly")),
          fmt::format("{}.nearly needs 'within': the most by which a coefficient of either side may differ; "
                      "write relations.within = 1e-6",
                      here));
    if (!nearly && k.within != 0)
      throw spec_error(in.place(*r.get("within")), here + ".within belongs to 'nearly', which is not there");
    if (nearly && !t.contains("samples"))
      throw spec_error(
          in.place(*r.get("nearly")),
          fmt::format("{}.nearly needs {}.samples: a construction of blades that satisfy it exactly, by which "
                      "verify checks; write samples.of = ['p: plane', ...] and samples.blades = ['...', ...]",
                      here, what));
  }
  if (const toml::node *node = t.get("samples")) {
    const std::string here = what + ".samples";
    const toml::table &s = in.as_table(*node, here);
    in.allow(s, here, {"of", "blades"});
    if (!s.contains("of") || !s.contains("blades"))
      throw spec_error(in.place(*node), here + " needs 'of', the operands of the construction, and 'blades'");
    if (!t.contains("relations"))
      throw spec_error(in.place(*node), here + " belongs to 'relations', which is not there");
    k.sample_of = read_fields(in, *s.get("of"), here + ".of");
    for (const toml::node &item : in.as_array(*s.get("blades"), here + ".blades"))
      k.samples.push_back(in.as_expression(item, "each item of " + here + ".blades"));
    if (k.samples.empty())
      throw spec_error(in.place(*s.get("blades")), here + ".blades is empty");
  }
}

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
