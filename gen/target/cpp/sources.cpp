// What the generated library compiles for each kernel that is made of signs.
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"

#include <fmt/format.h>

namespace meetc::target {

std::string info_function(const lower::kernel &k) {
  return identifier(k.asked.asked->name) + "_info";
}

std::string predicate_source(const emitted_predicate &p) {
  const std::string space = identifier(p.of.scene.space), name = p.kernel.asked.name();
  std::string out = banner(p.of.scene, fmt::format("The parts of {} that only few pairs need.", p.kernel.asked.text));
  out += fmt::format("#include <{}/detail/{}_rest.hpp>\n#include <meetc/table_functions.hpp>\n\nnamespace {} {{\n\n",
                     space, name, space);
  out += out_of_line(p, "");
  if (p.has_rare() && p.asks_plain())
    for (const char *type : {"float", "double", "meetc::double_double"})
      out += fmt::format("template bool {}::whole_plain<{}>(const float *, const float *);\n", p.name, type);
  if (!p.kernel.is_sign) {
    std::string rungs;
    for (const char *r : {"fp32", "fp64", "fp64x2", "exact", "certified"})
      if (p.of.asks(r))
        rungs += fmt::format("{}meetc::rung::{}", rungs.empty() ? "" : ", ", r);
    out += fmt::format(
        "\nnamespace detail {{\nmeetc::predicate_info {0}(const meetc::kind_info *a, const meetc::kind_info *b) {{\n"
        "  return meetc::info_of<{1}, {2}>(\"{3}\", \"{4}\", a, b);\n}}\n}} // namespace detail\n",
        info_function(p.kernel), p.name, rungs, p.kernel.asked.asked->name, p.kernel.asked.asked->mode);
  }
  return out + fmt::format("\n}} // namespace {}\n", space);
}

std::string header_only(const unit &u) {
  std::string out = banner(u.scene, "For header-only users: defines inline what the generated library would compile.");
  std::vector<std::string> includes;
  std::string functions;
  for (std::size_t i = 0; i < u.kernels.size(); ++i)
    if (u.kernels[i].is_predicate) {
      const emitted_predicate p(u, i);
      includes.push_back(fmt::format("detail/{}_rest.hpp", p.kernel.asked.name()));
      functions += out_of_line(p, "inline ");
    }
  out += open_header(u.scene, "file_header_only", includes) +
         "// Include this in at least one source of a program that is not linked with the library.\n" + functions;
  return out + close_header(u.scene);
}

} // namespace meetc::target
