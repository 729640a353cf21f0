// Kinds and blades as structs, and how blades are computed.
#include "gen/ir/count.hpp"
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/shader/shader.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string type_of(const shader_language &l, const unit &u, const lang::field &f) {
  return f.type == "real" ? l.number : shader_name(u, f.type);
}

std::string maker(const shader_language &l, const unit &u, const lower::lowered_kind &k, const lower::blade_maker &m) {
  std::vector<std::string> parameters;
  if (m.name.empty())
    parameters.push_back(l.declared(shader_name(u, k.name), "k"));
  else
    for (const lang::field &f : m.of)
      parameters.push_back(l.declared(type_of(l, u, f), shader_operand(f.name)));
  const auto input = [&](int i) {
    const std::string &path = m.inputs[static_cast<std::size_t>(i)];
    if (m.name.empty())
      return "k." + shader_path(path);
    const std::size_t dot = path.find('.');
    const std::string operand = shader_operand(path.substr(0, dot));
    return dot == std::string::npos ? operand : operand + '.' + shader_path(path.substr(dot + 1));
  };
  const std::string code = shader_body(l, m.code, input, [&](std::size_t i, const std::string &value) {
    return fmt::format("B.{} = {};", shader_member(blade_field(k.blades[i])), value);
  });
  const std::string name = m.name.empty() ? "blade_of_" + k.name : k.name + "_from_" + m.name;
  return fmt::format("// {}.\n", count_text(ir::count(m.code.nodes, m.code.results))) +
         shader_function(l, shader_name(u, k.name + "_blade"), shader_name(u, name), parameters, "B", code);
}

} // namespace

std::string shader_kinds(const shader_language &l, const unit &u) {
  const std::string sign = shader_name(u, "sign_of");
  std::string out = fmt::format("{} {{\n  return {}(v > 0.0) - {}(v < 0.0);\n}}\n\n",
                                l.head(l.integer, sign, l.declared(l.number, "v")), l.integer, l.integer);
  for (const lower::lowered_kind &k : u.kinds) {
    std::vector<std::pair<std::string, std::string>> members;
    for (const lang::field &f : k.fields)
      members.emplace_back(type_of(l, u, f), shader_member(f.name));
    out += fmt::format("// A {} as it is stored: {} numbers.\n{}\n", k.name, k.reals.size(),
                       shader_struct(l, shader_name(u, k.name), members));
  }
  for (const lower::lowered_kind &k : u.kinds) {
    if (!k.has_blade())
      continue;
    std::vector<std::pair<std::string, std::string>> members;
    for (const lower::basis_blade &b : k.blades)
      members.emplace_back(l.number, shader_member(blade_field(b)));
    out += fmt::format("// The blade of a {}, and how to compute it from stored numbers.\n{}", k.name,
                       shader_struct(l, shader_name(u, k.name + "_blade"), members));
    for (const lower::blade_maker &m : k.makers)
      out += maker(l, u, k, m);
    out += '\n';
  }
  return out;
}

} // namespace meetc::target
