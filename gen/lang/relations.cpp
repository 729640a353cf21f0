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

} // namespace meetc::lang
