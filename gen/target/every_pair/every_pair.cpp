// The brute-force engine: the form of touching balls with the proofs of its margins, the columns of each kind, and the
// catalogue for a product of signs. The kernels are templates in runtime/kernel/meetc/every_pair; the pairs that it leaves go
// through the steps that the target cuda writes.
#include "gen/target/every_pair/every_pair.hpp"

#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/gappa/gappa.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string header(const unit &u) {
  const std::string space = identifier(u.scene.space);
  return banner(u.scene, "Every pair of two sets as a product of matrices, on a CUDA device.") +
         fmt::format("#ifndef MEETC_{0}_every_pair_HPP\n#define MEETC_{0}_every_pair_HPP\n\n"
                     "#include <meetc/every_pair/table.hpp>\n#include <meetc/support.hpp>\n\n"
                     "namespace {0} {{\nnamespace every_pair {{\n\n"
                     "// The kinds of cuda::catalogue(), with the kernels that the engine needs besides.\n"
                     "const meetc::every_pair::catalogue &catalogue();\n\n"
                     "}} // namespace every_pair\n}} // namespace {0}\n\n#endif\n",
                     space);
}

std::string source(const unit &u) {
  const std::string space = identifier(u.scene.space);
  const auto kinds = element_kinds(u);
  std::string out = banner(u.scene, "The catalogue for a product of signs on a CUDA device.") +
                    fmt::format("#include <{0}/{0}_every_pair.hpp>\n#include <{0}/ball_form.hpp>\n"
                                "#include <{0}/shapes.hpp>\n#include <meetc/every_pair/filter.hpp>\n"
                                "#include <meetc/every_pair/probe.hpp>\n#include <meetc/every_pair/sets.hpp>\n\n"
                                "namespace {0} {{\nnamespace every_pair {{\n\n"
                                "const meetc::every_pair::catalogue &catalogue() {{\n"
                                "  static const meetc::every_pair::set_launchers all_kinds[] = {{\n",
                                space);
  for (const lower::lowered_kind *k : kinds)
    out += fmt::format("    {{.name = \"{0}\",\n     .enclose = meetc::every_pair::enclose<{1}_shape>,\n"
                       "     .columns = meetc::every_pair::columns<{1}_shape, ball_form>}},\n",
                       k->name, identifier(k->name));
  return out +
         fmt::format(
             "  }};\n  static const meetc::every_pair::catalogue c{{.kinds = all_kinds,\n"
             "                                              .kind_count = {},\n"
             "                                              .candidates = meetc::every_pair::candidates<ball_form>,\n"
             "                                              .touching = meetc::every_pair::touching,\n"
             "                                              .probe = meetc::every_pair::probe}};\n  return c;\n}}\n\n"
             "}} // namespace every_pair\n}} // namespace {}\n",
             kinds.size(), space);
}

} // namespace

std::vector<file> every_pair_files(const unit &u) {
  if (predicates_of(u).empty())
    return {}; // nothing to decide
  if (!u.balls)
    throw spec_error({}, "the backend 'every_pair' filters pairs by the balls around them, and no predicate of the "
                         "algebra says when two balls touch by one sign that separates; import "
                         "'primitives/ball.toml', or leave this backend out");
  const std::string space = identifier(u.scene.space), stem = space + '/' + space + "_every_pair";
  std::vector<file> out{{space + "/ball_form.hpp", broken_lines(ball_form_header(u))},
                        {stem + ".hpp", broken_lines(header(u))},
                        {stem + ".cu", broken_lines(source(u))}};
  if (u.asks(lang::rung::certified))
    for (file &f : filter_proofs(u))
      out.push_back(std::move(f));
  return out;
}

} // namespace meetc::target
