// A stage as a struct, and its bounds and bytecode as structs of their own in detail/.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/bounds.hpp"
#include "gen/target/cpp/bytecode.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

const char *what_of(const emitted_predicate &p, const emitted_stage &s) {
  const std::string name = s.name;
  return p.kernel.is_sign   ? "The sign"
         : name == "reject" ? "Decides most misses"
         : name == "rare"   ? "The rare case"
                            : "The usual case";
}

std::string detail_name(const emitted_predicate &p, const emitted_stage &s, const char *what) {
  return fmt::format("{}_{}_{}", p.name, s.name, what);
}

// A parameter of a pointer, without its name where the text does not use it.
std::string pointer(const char *type, const std::string &name, const std::string &text) {
  const bool used = text.find(name + '[') != std::string::npos || text.find('(' + name + ')') != std::string::npos;
  return used ? fmt::format("{} *{}", type, name) : fmt::format("{} *", type);
}

std::string function_of_object(const emitted_predicate &p, const char *name, const char *row, const std::string &body,
                               const std::string &indent) {
  const std::string all = p.operands_in(body, indent + "  ") + body;
  return fmt::format("{0}template <class T> MEETC_HD MEETC_INLINE static void {1}({2}, {3}) {{\n{4}{0}}}\n", indent,
                     name, pointer("const T", row, all), pointer("T", "f", all), all);
}

std::string opened(const emitted_predicate &p, const char *which, const std::vector<std::string> &includes,
                   const std::vector<std::string> &kernel_headers = {}) {
  return open_header(p.of.scene, fmt::format("detail_{}_{}", p.kernel.asked.name(), which), includes, kernel_headers);
}

} // namespace

std::string stage_text(const emitted_predicate &p, const emitted_stage &s, const std::string &scope) {
  const lower::predicate &d = p.kernel.decision;
  const std::string indent = scope.empty() ? "  " : "", inner = indent + "  ";
  std::vector<std::string> remarks;
  for (std::size_t i = 0; i < s.code->atoms.size(); ++i) {
    const std::string text = d.signs.text(s.code->atoms[i]);
    remarks.push_back(text.empty() ? "" : fmt::format("s[{}] = {}", s.first + static_cast<int>(i), text));
  }
  const auto input = [&p](int i) { return p.input(i); };
  const parts text = split_body(s.code->code, input, s.bounds && s.bounds->mixed, remarks, inner + "  ");
  const auto counted = [&](poly::residency r) { return count_text(ir::count(s.code->code, r)); };
  std::string out =
      fmt::format("{}// {}: signs {} to {}, degree {}.\n", indent, what_of(p, s), s.first,
                  s.first + static_cast<int>(s.code->atoms.size()) - 1, (s.bounds ? s.bounds->degree : 0));
  out += fmt::format("{}// Once an object {}: {}; {}: {}; a pair: {}.\n", indent, p.a, counted(poly::residency::a), p.b,
                     counted(poly::residency::b), counted(poly::residency::pair));
  out += fmt::format(
      "{}struct {}{}_stage{} {{\n{}static constexpr int first = {}, atoms = {}, fields_a = {}, fields_b = {};\n",
      indent, scope, s.name, s.bounds ? fmt::format(" : detail::{}", detail_name(p, s, "bounds")) : "", inner, s.first,
      s.code->atoms.size(), text.fields_a, text.fields_b);
  if (s.bounds)
    out += fmt::format("{}using bytecode = detail::{};\n", inner, detail_name(p, s, "bytecode"));
  out += function_of_object(p, "object_a", "row_a", text.object_a, inner) +
         function_of_object(p, "object_b", "row_b", text.object_b, inner);
  const std::string pair = p.operands_in(text.pair, inner + "  ") + text.pair;
  out += fmt::format(
      "{0}// The values whose signs are wanted; W holds those of degree 3 and more.\n"
      "{0}template <class T, class W = T>\n{0}MEETC_HD MEETC_INLINE static void pair({1}, {2}, {3}, {4}, W *v) "
      "{{\n{5}{0}}}\n",
      inner, pointer("const T", "row_a", pair), pointer("const T", "fa", pair), pointer("const T", "row_b", pair),
      pointer("const T", "fb", pair), pair);
  return out + indent + "};\n";
}

std::string bounds_header(const emitted_predicate &p) {
  std::string out = banner(p.of.scene, fmt::format("Error bounds of {}.", p.kernel.asked.text)) +
                    opened(p, "bounds", {"kinds.hpp"}) + "namespace detail {\n\n";
  out += fmt::format("struct {}_points {{\n{}}};\n", p.name, kernel_bounds_text(*p.bounds, p));
  for (const emitted_stage &s : p.stages)
    if (s.name != std::string("rare")) {
      out += fmt::format("\nstruct {};\n", detail_name(p, s, "bytecode")); // in the other header
      out += fmt::format("struct {} {{\n{}}};\n", detail_name(p, s, "bounds"), stage_bounds_text(*s.bounds, s, p));
    }
  return out + "\n} // namespace detail\n" + close_header(p.of.scene);
}

std::string rest_header(const emitted_predicate &p) {
  const std::string name = p.kernel.asked.name();
  std::vector<std::string> includes{name + ".hpp"};
  for (const std::string &callee : called_by(p))
    includes.push_back(fmt::format("detail/{}_rest.hpp", callee));
  std::string out =
      banner(p.of.scene,
             fmt::format("What only few pairs need of {}: the rare case, and the program as bytecode for the "
                         "exact rung.",
                         p.kernel.asked.text)) +
      opened(p, "rest", includes, {"rest.hpp"});
  if (p.bounds) {
    out += "namespace detail {\n\n";
    for (const emitted_stage &s : p.stages) {
      if (s.name == std::string("rare"))
        out += fmt::format("struct {} {{\n{}}};\n\n", detail_name(p, s, "bounds"), stage_bounds_text(*s.bounds, s, p));
      out += fmt::format("struct {} {{\n{}}};\n\n", detail_name(p, s, "bytecode"),
                         bytecode_text(s.code->code, p.kernel.decision.inputs_a + p.kernel.decision.inputs_b));
    }
    out += "} // namespace detail\n\n";
  }
  if (const emitted_stage *rare = p.stage("rare")) {
    out += stage_text(p, *rare, p.name + "::") + '\n' +
           truth_function(p, "whole", {p.kernel.decision.truths.hit}, p.name + "::");
  }
  return out + close_header(p.of.scene);
}

std::string out_of_line(const emitted_predicate &p, const std::string &head) {
  const char *type = p.kernel.is_sign ? "meetc::sign" : "bool";
  const char *of = p.kernel.is_sign ? "_sign" : "";
  constexpr const char *rows = "(const float *row_a, const float *row_b)";
  std::string out;
  const auto define = [&](const char *result, const char *name, const std::string &call) {
    out += fmt::format("{}{} {}::{}{} {{\n  return meetc::{}(row_a, row_b);\n}}\n", head, result, p.name, name, rows,
                       call);
  };
  if (p.of.asks("certified"))
    define(type, "after_fp32", fmt::format("decide_rest{}<{}>", of, p.name));
  else if (p.of.asks("exact"))
    define(type, "exactly", fmt::format("decide_exactly{}<{}>", of, p.name));
  if (p.has_rare() && p.of.asks("certified"))
    define("meetc::answer", "whole_filter", fmt::format("certify<{}, meetc::in_fp32>", p.name));
  if (p.has_rare() && p.asks_plain())
    out += fmt::format("template <class T> bool {0}::whole_plain{1} {{\n"
                       "  return meetc::decide<{0}>(meetc::plain_signs<{0}, T>(row_a, row_b));\n}}\n",
                       p.name, rows);
  return out;
}

} // namespace meetc::target
