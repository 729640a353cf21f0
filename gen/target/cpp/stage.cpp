// A stage as a struct, with its bounds and bytecode as separate structs in detail/.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/bounds.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

const char *what_of(const emitted_predicate &p, const emitted_stage &s) {
  if (p.kernel.is_sign)
    return "The sign";
  switch (s.kind) {
  case lower::stage_kind::reject:
    return "Decides most misses";
  case lower::stage_kind::rare:
    return "The rare case";
  case lower::stage_kind::common:
    break;
  }
  return "The common case";
}

std::string detail_name(const emitted_predicate &p, const emitted_stage &s, const char *what) {
  return fmt::format("{}_{}_{}", p.name, name_of(s.kind), what);
}

// A pointer parameter, without its name where the text does not use it.
std::string pointer(const char *type, const std::string &name, const std::string &text) {
  const bool used = text.find(name + '[') != std::string::npos || text.find('(' + name + ')') != std::string::npos;
  return used ? fmt::format("{} *{}", type, name) : fmt::format("{} *", type);
}

std::string function_of_object(const emitted_predicate &p, const char *name, const char *row, const std::string &body,
                               const std::string &indent) {
  const std::string all = p.operands_in(body, indent + "  ") + body;
  return fmt::format("{0}template <class T> MEETC_HD MEETC_INLINE static constexpr void {1}({2}, {3}) {{\n{4}{0}}}\n",
                     indent, name, pointer("const T", row, all), pointer("T", "f", all), all);
}

std::string opened(const emitted_predicate &p, const char *which, const std::vector<std::string> &includes,
                   const std::vector<std::string> &kernel_headers = {}) {
  return open_header(p.of.scene, fmt::format("detail_{}_{}", p.kernel.asked.name(), which), includes, kernel_headers);
}

// The operations that run once for each object of a set, and those that run for each pair: of the values, and of the
// magnitudes where a rung has bounds.
std::string counts_of(const emitted_predicate &p, const emitted_stage &s, const std::string &indent) {
  bool any_stored = false;
  const auto counted = [&](const char *what, const char *one, const ir::program &code) {
    std::string text = fmt::format("{}// {} cost each pair {}.\n", indent, what, count_text(ir::count_pair(code)));
    for (const auto &[where, name] : {std::pair(poly::residency::a, &p.a), std::pair(poly::residency::b, &p.b)})
      if (const std::size_t n = ir::stored_of(code, where).size()) {
        any_stored = true;
        text += fmt::format("{}// A set on a CPU stores {} {}{} beside each {}, by {}.\n", indent, n, one,
                            n == 1 ? "" : "s", *name, count_text(ir::count_object(code, where)));
      }
    return text;
  };
  std::string out = counted("Values", "value", s.code->code);
  if (s.bounds)
    out += counted("Magnitudes, where a rung has bounds,", "magnitude", s.bounds->magnitudes);
  if (any_stored)
    out += fmt::format("{}// A call on two single objects computes these as well.\n", indent);
  return out;
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
  const ir::program &code = s.code->code;
  const stored_body stored = stored_parts(code, {input, {}}, inner + "  ");
  std::string out =
      fmt::format("{}// {}: signs {} to {}, degree {}.\n", indent, what_of(p, s), s.first,
                  s.first + static_cast<int>(s.code->atoms.size()) - 1, (s.bounds ? s.bounds->degree : 0));
  out += counts_of(p, s, indent);
  out += fmt::format(
      "{}struct {}{}_stage{} {{\n{}static constexpr int first = {}, atoms = {}, fields_a = {}, fields_b = {};\n",
      indent, scope, name_of(s.kind), s.bounds ? fmt::format(" : detail::{}", detail_name(p, s, "bounds")) : "", inner,
      s.first, s.code->atoms.size(), stored.fields_a, stored.fields_b);
  if (s.bounds && p.asks_bytecode())
    out += fmt::format("{}using bytecode = detail::{};\n", inner, detail_name(p, s, "bytecode"));
  if (stored.fields_a > 0)
    out += function_of_object(p, "object_a", "row_a", stored.object_a, inner);
  if (stored.fields_b > 0)
    out += function_of_object(p, "object_b", "row_b", stored.object_b, inner);
  const body_names names{input, [](std::size_t i, const std::string &v) { return fmt::format("v[{}] = {};", i, v); }};
  const std::string body = pair_body(code, stored, names, s.bounds && s.bounds->mixed, remarks, inner + "  ");
  const std::string pair = p.operands_in(body, inner + "  ") + body;
  out += fmt::format("{0}// The values of the signs; W holds those of degree 3 and more.\n"
                     "{0}template <class T, class W = T>\n{0}MEETC_HD MEETC_INLINE static constexpr void pair({1}, "
                     "{2}, {3}, {4}, W *v) "
                     "{{\n{5}{0}}}\n",
                     inner, pointer("const T", "row_a", pair), pointer("const T", "fa", pair),
                     pointer("const T", "row_b", pair), pointer("const T", "fb", pair), pair);
  return out + indent + "};\n";
}

std::string bounds_header(const emitted_predicate &p) {
  std::string out = banner(p.of.scene, fmt::format("Error bounds of {}.", p.kernel.asked.text)) +
                    opened(p, "bounds", {"kinds.hpp"}) + "namespace detail {\n\n";
  out += fmt::format("struct {}_points {{\n{}}};\n", p.name, kernel_bounds_text(*p.bounds, p));
  for (const emitted_stage &s : p.stages)
    if (s.kind != lower::stage_kind::rare) {
      if (p.asks_bytecode())
        out += fmt::format("\nstruct {};", detail_name(p, s, "bytecode")); // defined in the other header
      out += fmt::format("\nstruct {} {{\n{}}};\n", detail_name(p, s, "bounds"), stage_bounds_text(*s.bounds, s, p));
    }
  return out + "\n} // namespace detail\n" + close_header(p.of.scene);
}

std::string later_header(const emitted_predicate &p) {
  const std::string name = p.kernel.asked.name();
  std::vector<std::string> includes;
  for (const std::string &callee : called_by(p))
    includes.push_back(fmt::format("detail/{}_later.hpp", callee));
  std::string out =
      banner(p.of.scene, fmt::format(fmt::runtime(p.asks_bytecode()
                                                      ? "The parts of {} that only few pairs need: the rare case, and "
                                                        "the program as bytecode for the exact rung."
                                                      : "The rare case of {}."),
                                     p.kernel.asked.text)) +
      fmt::format("// Include {0}.hpp first; on a device it includes this file.\n", name) +
      opened(p, "later", includes, {"decide/later_rungs.hpp"});
  if (p.bounds) {
    out += "namespace detail {\n\n";
    for (const emitted_stage &s : p.stages) {
      if (s.kind == lower::stage_kind::rare) // the rung tolerant computes it by integers alone
        out += fmt::format("struct {} {{\n{}}};\n\n", detail_name(p, s, "bounds"),
                           p.asks_bytecode() ? stage_bounds_text(*s.bounds, s, p) : stage_widths_text(*s.bounds));
      if (p.asks_bytecode())
        out += fmt::format("struct {} {{\n{}}};\n\n", detail_name(p, s, "bytecode"),
                           bytecode_text(s.code->code, p.kernel.decision.inputs_a + p.kernel.decision.inputs_b));
    }
    out += "} // namespace detail\n\n";
  }
  if (const emitted_stage *rare = p.stage(lower::stage_kind::rare)) {
    out += stage_text(p, *rare, p.name + "::") + '\n' +
           truth_function(p, "whole", {p.kernel.decision.truths.hit}, p.name + "::");
  }
  return out + close_header(p.of.scene);
}

std::string out_of_line(const emitted_predicate &p, const std::string &head, last_rungs which) {
  const char *type = p.kernel.is_sign ? "meetc::sign" : "bool";
  const char *of = p.kernel.is_sign ? "_sign" : "";
  constexpr const char *rows = "(const float *row_a, const float *row_b)";
  std::string out;
  const auto define = [&](const char *result, const char *name, const std::string &call) {
    out += fmt::format("{}{} {}::{}{} {{\n  return meetc::{}(row_a, row_b);\n}}\n", head, result, p.name, name, rows,
                       call);
  };
  const bool certified = p.of.asks(lang::rung::certified);
  if (certified || p.of.asks(lang::rung::exact)) {
    const char *const name = certified ? "after_fp32" : "exactly";
    if (which == last_rungs::integers)
      out += fmt::format(
          "{0}{1} {2}::{3}{4} {{\n  return meetc::decide{5}<{2}>(meetc::integer_signs<{2}>(row_a, row_b));\n}}\n", head,
          type, p.name, name, rows, of);
    else
      define(type, name, fmt::format("{}{}<{}>", certified ? "later_rungs" : "decide_exactly", of, p.name));
  }
  if (p.tolerant)
    define(type, "tolerant_rest", fmt::format("tolerant_later_rungs<{}>", p.name));
  if (p.has_rare() && p.of.asks(lang::rung::certified))
    define("meetc::answer", "whole_filter", fmt::format("certify<{}, meetc::in_fp32>", p.name));
  if (p.has_rare() && p.asks_plain())
    out += fmt::format("template <class T> bool {0}::whole_plain{1} {{\n"
                       "  return meetc::decide<{0}>(meetc::plain_signs<{0}, T>(row_a, row_b));\n}}\n",
                       p.name, rows);
  return out;
}

} // namespace meetc::target
