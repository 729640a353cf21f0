#include "gen/target/shader/shader.hpp"

#include "gen/target/c/c.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/shader/reserved.hpp"
#include "gen/target/statements.hpp"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace meetc::target {
namespace {

// A value is `precise` as a whole, so that the operations of an expression are not fused either.
constexpr shader_language glsl{
    .backend = "glsl",
    .number = "float",
    .integer = "int",
    .keeps_order = true,
    .declared = [](const std::string &type, const std::string &name) { return type + ' ' + name; },
    .after_member = ";",
    .after_struct = ";",
    .variable = [](const std::string &type, const std::string &name) { return "precise " + type + ' ' + name; },
    .head = [](const std::string &type, const std::string &name,
               const std::string &parameters) { return fmt::format("{} {}({})", type, name, parameters); },
    .keep = [](const std::string &name,
               const std::string &value) { return fmt::format("precise float {} = {};", name, value); },
    .truth = [](const std::string &name,
                const std::string &value) { return fmt::format("  bool {} = {};\n", name, value); },
    .choose = [](const std::string &c, const std::string &t,
                 const std::string &e) { return fmt::format("{} ? {} : {}", c, t, e); },
    .integers = [](std::size_t many, const std::string &name) { return fmt::format("int {}[{}]", name, many); }};

constexpr shader_language wgsl{
    .backend = "wgsl",
    .number = "f32",
    .integer = "i32",
    .keeps_order = false,
    .declared = [](const std::string &type, const std::string &name) { return name + ": " + type; },
    .after_member = ",",
    .after_struct = "",
    .variable = [](const std::string &type, const std::string &name) { return fmt::format("var {}: {}", name, type); },
    .head = [](const std::string &type, const std::string &name,
               const std::string &parameters) { return fmt::format("fn {}({}) -> {}", name, parameters, type); },
    .keep = [](const std::string &name, const std::string &value) { return fmt::format("let {} = {};", name, value); },
    .truth = [](const std::string &name,
                const std::string &value) { return fmt::format("  let {} = {};\n", name, value); },
    .choose = [](const std::string &c, const std::string &t,
                 const std::string &e) { return fmt::format("select({}, {}, {})", e, t, c); },
    .integers = [](std::size_t many,
                   const std::string &name) { return fmt::format("var {}: array<i32, {}>", name, many); }};

// A number in float32, rounded as C rounds "(1.0f / 3.0f)": both languages divide less exactly.
std::string constant(const ir::rational &q) {
  const auto rounded = [](const mpz_class &z) { return std::strtof(z.get_str().c_str(), nullptr); };
  const float value = rounded(abs(q.get_num())) / rounded(q.get_den());
  if (!std::isfinite(value))
    throw spec_error({}, fmt::format("the number {} is beyond float32, in which a shader computes", q.get_str()));
  std::string text = fmt::format("{:.9g}", value); // nine digits name one float, and no midpoint of two
  if (text.find_first_of(".e") == std::string::npos)
    text += ".0";
  return q < 0 ? fmt::format("(-{})", text) : text;
}

const char *const bits_of_glsl =
    "// Include this file in a shader of GLSL 4.0 or later; it has no #version and no entry point. All numbers are\n"
    "// float32. `precise` forbids to fuse or reorder operations, so a device that rounds sums and products to "
    "nearest\n"
    "// and keeps subnormal numbers gets the bits of the C header that is compiled without fused multiply-adds.\n";
const char *const bits_of_wgsl =
    "// Put this file before a shader of WGSL; it has no entry point. All numbers are float32. A device may fuse and\n"
    "// reorder operations, so bits are not promised, and no error is stated.\n";

std::string kernel_text(const shader_language &l, const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  return broken_lines(k.is_predicate ? shader_decision(l, u, k) : shader_formula(l, u, k));
}

std::vector<file> shader_files(const shader_language &l, const unit &u, const std::string &says) {
  const std::string space = identifier(u.scene.space);
  std::string text = banner(u.scene, "Formulas, signs and plain predicates in float32.") + says;
  text += shader_kinds(l, u);
  for (std::size_t i = 0; i < u.kernels.size(); ++i)
    text += kernel_text(l, u, i);
  return {{fmt::format("{0}/{0}.{1}", space, l.backend), broken_lines(text)}};
}

} // namespace

std::string shader_member(const std::string &name) {
  const std::string id = identifier(name);
  // No two names become one: a name that begins as a changed one does is changed too.
  return is_reserved_in_shaders(id) || id.starts_with("gl_") || id.starts_with("m_") ? "m_" + id : id;
}

std::string shader_path(const std::string &path) {
  std::string out;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    out += (out.empty() ? "" : ".") + shader_member(path.substr(from, dot - from));
    from = dot + 1;
  }
  return out;
}

std::string shader_name(const unit &u, const std::string &name) {
  return shader_member(u.scene.space + '_' + name);
}

std::string shader_operand(const std::string &name) {
  return shader_member(c_operand(name));
}

std::string shader_body(const shader_language &l, const ir::program &p, const std::function<std::string(int)> &input,
                        const std::function<std::string(std::size_t, const std::string &)> &result) {
  syntax s{.type = "", .fma = "", .constant = constant, .input = input, .indent = "  "};
  s.keep = l.keep;
  s.local = shader_member;
  const statements::text code = statements::of(p, s);
  std::string out = code.before;
  for (std::size_t i = 0; i < code.results.size(); ++i)
    out += fmt::format("  {}\n", result(i, code.results[i]));
  return out;
}

std::string shader_function(const shader_language &l, const std::string &type, const std::string &name,
                            const std::vector<std::string> &parameters, const std::string &result,
                            const std::string &code) {
  return fmt::format("{} {{\n  {};\n{}  return {};\n}}\n", l.head(type, name, join(parameters, ", ")),
                     l.variable(type, result), code, result);
}

std::string shader_struct(const shader_language &l, const std::string &name,
                          const std::vector<std::pair<std::string, std::string>> &types_and_names) {
  std::string out;
  for (const auto &[type, member] : types_and_names)
    out += fmt::format("  {}{}\n", l.declared(type, member), l.after_member);
  return fmt::format("struct {} {{\n{}}}{}\n", name, out, l.after_struct);
}

std::vector<file> glsl_files(const unit &u) {
  const std::string guard = fmt::format("MEETC_{}_{}_GLSL", identifier(u.scene.space).size(), shader_name(u, "file"));
  std::vector<file> out =
      shader_files(glsl, u, fmt::format("{}#ifndef {}\n#define {}\n\n", bits_of_glsl, guard, guard));
  out.front().text += "#endif\n";
  return out;
}

std::vector<file> wgsl_files(const unit &u) {
  return shader_files(wgsl, u, std::string(bits_of_wgsl) + '\n');
}

std::string glsl_text(const unit &u, std::size_t kernel) {
  return kernel_text(glsl, u, kernel);
}

std::string wgsl_text(const unit &u, std::size_t kernel) {
  return kernel_text(wgsl, u, kernel);
}

} // namespace meetc::target
