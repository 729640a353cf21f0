// Kinds and blades as structs of C, and how blades are computed.
#include "gen/ir/count.hpp"
#include "gen/target/c/c.hpp"
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string type_of(const unit &u, const std::string &field_type, const c_number &n) {
  return field_type == "real" ? n.type : c_name(u, field_type, n);
}

std::string stored_struct(const unit &u, const lower::lowered_kind &k, const c_number &n) {
  std::string out;
  for (const lang::field &f : k.fields)
    out += fmt::format("  {} {};\n", type_of(u, f.type, n), identifier(f.name));
  return fmt::format("typedef struct {{\n{}}} {};\n", out, c_name(u, k.name, n));
}

std::string blade_struct(const unit &u, const lower::lowered_kind &k, const c_number &n) {
  std::vector<std::string> fields;
  for (const lower::basis_blade &b : k.blades)
    fields.push_back(blade_field(b));
  return fmt::format("typedef struct {{\n  {} {};\n}} {};\n", n.type, join(fields, ", "),
                     c_name(u, k.name + "_blade", n));
}

std::string maker(const unit &u, const lower::lowered_kind &k, const lower::blade_maker &m, const c_number &n) {
  const std::string blade = c_name(u, k.name + "_blade", n);
  std::vector<std::string> parameters;
  if (m.name.empty())
    parameters.push_back(fmt::format("const {} *k", c_name(u, k.name, n)));
  for (std::size_t i = 0; i < (m.name.empty() ? 0 : m.of.size()); ++i)
    parameters.push_back(m.of[i].type == "real"
                             ? fmt::format("{} {}", n.type, identifier(m.of[i].name))
                             : fmt::format("const {} *{}", c_name(u, m.of[i].type, n), identifier(m.of[i].name)));
  const auto input = [&](int i) {
    const std::string path = path_identifier(m.inputs[static_cast<std::size_t>(i)]);
    const std::size_t dot = path.find('.');
    if (m.name.empty())
      return "k->" + path;
    return dot == std::string::npos ? path : path.substr(0, dot) + "->" + path.substr(dot + 1);
  };
  const std::string code = c_body(m.code, n, c_multiply_add(u, n), input, [&](std::size_t i, const std::string &value) {
    return fmt::format("B.{} = {};", blade_field(k.blades[i]), value);
  });
  const std::string name = m.name.empty() ? "blade_of_" + k.name : k.name + "_from_" + m.name;
  return fmt::format("static inline {} {}({}) {{\n  MEETC_{}_{}_AS_WRITTEN\n  {} B;\n{}  return B;\n}}\n", blade,
                     c_name(u, name, n), join(parameters, ", "), identifier(u.scene.space).size(),
                     identifier(u.scene.space), blade, code);
}

} // namespace

std::string c_kinds(const unit &u) {
  std::string out = fmt::format("static inline int {}_sign_of(double v) {{ return (v > 0) - (v < 0); }}\n\n",
                                identifier(u.scene.space));
  for (const lower::lowered_kind &k : u.kinds) {
    out += fmt::format("/* A {} as it is stored: {} numbers. */\n", k.name, k.reals.size());
    for (const c_number &n : c_numbers)
      out += stored_struct(u, k, n);
    out += fmt::format("/* Whether all numbers are finite and the kind's rule holds. Predicates assume it. */\n"
                       "bool {}_valid_{}(const {} *k);\n\n",
                       identifier(u.scene.space), identifier(k.name), c_name(u, k.name, c_numbers[1]));
  }
  for (const lower::lowered_kind &k : u.kinds) {
    if (!k.has_blade())
      continue;
    out += fmt::format("/* The blade of a {}, and how to compute it from stored numbers. */\n", k.name);
    for (const c_number &n : c_numbers)
      out += blade_struct(u, k, n);
    for (const lower::blade_maker &m : k.makers) {
      out += fmt::format("/* {}. */\n", count_text(ir::count(m.code.nodes, m.code.results)));
      for (const c_number &n : c_numbers)
        out += maker(u, k, m, n);
    }
    out += '\n';
  }
  return out;
}

} // namespace meetc::target
