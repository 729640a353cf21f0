#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace meetc::target {

std::string identifier(const std::string &name) {
  // C++20 keywords and alternative tokens, CUDA's qualifiers, and the names that emitted code uses.
  static const std::set<std::string> taken{"alignas",
                                           "alignof",
                                           "and",
                                           "and_eq",
                                           "asm",
                                           "auto",
                                           "bitand",
                                           "bitor",
                                           "bool",
                                           "break",
                                           "case",
                                           "catch",
                                           "char",
                                           "char8_t",
                                           "char16_t",
                                           "char32_t",
                                           "class",
                                           "compl",
                                           "concept",
                                           "const",
                                           "consteval",
                                           "constexpr",
                                           "constinit",
                                           "const_cast",
                                           "continue",
                                           "co_await",
                                           "co_return",
                                           "co_yield",
                                           "decltype",
                                           "default",
                                           "delete",
                                           "do",
                                           "double",
                                           "dynamic_cast",
                                           "else",
                                           "enum",
                                           "explicit",
                                           "export",
                                           "extern",
                                           "false",
                                           "float",
                                           "for",
                                           "friend",
                                           "goto",
                                           "if",
                                           "inline",
                                           "int",
                                           "long",
                                           "mutable",
                                           "namespace",
                                           "new",
                                           "noexcept",
                                           "not",
                                           "not_eq",
                                           "nullptr",
                                           "operator",
                                           "or",
                                           "or_eq",
                                           "private",
                                           "protected",
                                           "public",
                                           "register",
                                           "reinterpret_cast",
                                           "requires",
                                           "restrict",
                                           "return",
                                           "short",
                                           "signed",
                                           "sizeof",
                                           "static",
                                           "static_assert",
                                           "static_cast",
                                           "struct",
                                           "switch",
                                           "template",
                                           "this",
                                           "thread_local",
                                           "throw",
                                           "true",
                                           "try",
                                           "typedef",
                                           "typeid",
                                           "typename",
                                           "union",
                                           "unsigned",
                                           "using",
                                           "virtual",
                                           "void",
                                           "volatile",
                                           "wchar_t",
                                           "while",
                                           "xor",
                                           "xor_eq",
                                           "T",
                                           "S",
                                           "blade",
                                           "to_row",
                                           "valid",
                                           "hit",
                                           "plain",
                                           "usual",
                                           "whole",
                                           "rejected",
                                           "needs_rare",
                                           "atoms",
                                           "inputs_a",
                                           "inputs_b",
                                           "value",
                                           "reject_stage",
                                           "common_stage",
                                           "rare_stage",
                                           "after_fp32",
                                           "coincident",
                                           "coincidences",
                                           "detail",
                                           "exactly",
                                           "filter",
                                           "whole_filter",
                                           "whole_plain",
                                           "axis",
                                           "catalogue",
                                           "ball_form",
                                           "NULL",
                                           "NAN",
                                           "INFINITY",
                                           "EOF",
                                           "errno",
                                           "assert",
                                           "stdin",
                                           "stdout",
                                           "stderr",
                                           "main",
                                           "std",
                                           "meetc",
                                           "cuda",
                                           "every_pair",
                                           "predicates",
                                           "kinds",
                                           "linux",
                                           "unix"};
  // Leading underscores and double underscores are reserved, and trailing ones are used here.
  std::string out;
  for (const char c : name)
    if (c != '_' || (!out.empty() && out.back() != '_'))
      out += c;
  if (out.empty() || out != name || taken.count(out))
    out += out.empty() || out.back() == '_' ? "0_" : "_";
  return out;
}

std::string path_identifier(const std::string &path) {
  std::string out;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    if (from)
      out += '.';
    out += identifier(path.substr(from, dot - from));
    from = dot + 1;
  }
  return out;
}

std::string blade_field(const lower::basis_blade &b) {
  return b.is_scalar() ? "scalar" : identifier(join(b.vectors, "_"));
}

std::string kernel_function(const lower::request &r) {
  // An operand with the name of a function would hide it.
  const bool hidden = std::find(r.names.begin(), r.names.end(), r.function) != r.names.end();
  return identifier(r.function) + (hidden ? "_" : "");
}

std::string rule_test(const lower::element_rule &r, const std::function<std::string(int)> &number) {
  using type = lower::element_rule::type;
  if (r.kind == type::positive || r.kind == type::not_negative)
    return fmt::format("meetc::{}({})", r.kind == type::positive ? "is_positive" : "not_negative", number(r.x[0]));
  std::vector<std::string> axes;
  for (std::size_t i = 0; i < r.x.size(); ++i)
    axes.push_back(r.kind == type::not_zero
                       ? fmt::format("meetc::is_not_zero({})", number(r.x[i]))
                       : fmt::format("meetc::{}({}, {})", r.kind == type::differ ? "differ" : "not_above",
                                     number(r.x[i]), number(r.y[i])));
  return '(' + join(axes, r.kind == type::not_above ? " && " : " || ") + ')';
}

} // namespace meetc::target
