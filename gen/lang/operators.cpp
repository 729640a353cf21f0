#include "gen/lang/operators.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace meetc::lang {
namespace {

// Calls in the body of an operator are of operators, whatever an algebra declares.
expr_ptr closed(const expr_ptr &e) {
  expr out = *e;
  if (out.kind == op::call)
    out.kind = op::builtin;
  for (expr_ptr &arg : out.args)
    arg = closed(arg);
  return std::make_shared<expr>(std::move(out));
}

expr_ptr body(const std::string &text) {
  return closed(parse_expression(text, "an operator's definition"));
}

} // namespace

const std::vector<builtin> &builtins() {
  static const std::vector<builtin> all{
      {"rev", "`rev(A)`, `~A`", "Σ (−1)^(k(k−1)/2) ⟨A⟩ₖ", operation::reverse, {"A"}},
      {"involute", "`involute(A)`", "Σ (−1)^k ⟨A⟩ₖ", operation::involute, {"A"}},
      {"conj", "`conj(A)`", "Σ (−1)^(k(k+1)/2) ⟨A⟩ₖ", operation::conjugate, {"A"}},
      {"grade", "`grade(A, k)`", "⟨A⟩ₖ", operation::grade_part, {"A", "k"}},
      {"scalar", "`scalar(A)`", "⟨A⟩₀", operation::scalar_part, {"A"}},
      {"rc", "`rc(A)`", "linear; a ∧ rc(a) = I for each basis blade a", operation::right_complement, {"A"}},
      {"lc", "`lc(A)`", "linear; lc(a) ∧ a = I for each basis blade a", operation::left_complement, {"A"}},
      {"dual", "`dual(A)`", "A ⌋ I⁻¹; rc(A) where I² = 0", operation::dual, {"A"}},
      {"undual", "`undual(A)`", "A ⌋ I; lc(A) where I² = 0", operation::undual, {"A"}},
      {"regressive",
       "`A & B`, `regressive(A, B)`",
       "lc(rc(A) ∧ rc(B))",
       operation::expression,
       {"A", "B"},
       body("lc(rc(A) ^ rc(B))")},
      {"commutator", "`commutator(A, B)`", "(A B − B A) / 2", operation::expression, {"A", "B"}, body("(A*B - B*A)/2")},
      {"dot", "`dot(A, B)`", "Σ ⟨⟨A⟩ᵣ ⟨B⟩ₛ⟩ₜ, t = |r − s|", operation::dot, {"A", "B"}},
      {"sandwich",
       "`sandwich(V, X)`",
       "V X ~V; V involute(X) ~V for odd V",
       operation::of_versor,
       {"V", "X"},
       body("V*X*~V"),
       body("V*involute(X)*~V")},
      {"reflect",
       "`reflect(X, p)`",
       "p X ~p; p involute(X) ~p for odd p",
       operation::of_versor,
       {"X", "p"},
       body("p*X*~p"),
       body("p*involute(X)*~p")},
      {"project", "`project(X, Y)`", "dot(X, Y) ~Y", operation::expression, {"X", "Y"}, body("dot(X, Y)*~Y")},
      {"inverse", "`inverse(V)`", "~V / (V ~V)", operation::inverse, {"V"}},
      {"rnorm2", "`rnorm2(A)`", "⟨A ~A⟩₀", operation::expression, {"A"}, body("scalar(A*~A)")},
  };
  return all;
}

bool builtin::needs_pseudoscalar() const {
  return does == operation::right_complement || does == operation::left_complement || does == operation::dual ||
         does == operation::undual || name == "regressive";
}

const builtin *find_builtin(const std::string &name) {
  const auto it = std::find_if(builtins().begin(), builtins().end(), [&](const builtin &b) { return b.name == name; });
  return it == builtins().end() ? nullptr : &*it;
}

const builtin *called_builtin(const algebra &a, const expr &e) {
  if (e.kind == op::builtin)
    return find_builtin(e.text);
  if (e.kind != op::call || a.find_function(e.text) || a.find_predicate(e.text) || a.find_kind(e.text) ||
      (e.text == "grade" && e.args.size() == 1)) // the number that is the grade
    return nullptr;
  return find_builtin(e.text);
}

void refuse_arguments(const expr &call, std::size_t want) {
  throw spec_error(call.where,
                   fmt::format("'{}' takes {}{} argument{}, not {}", call.text, call.text == "grade" ? "1 or " : "",
                               want, want == 1 ? "" : "s", call.args.size()));
}

std::vector<std::string> vectors_of_name(const algebra &a, const std::string &name) {
  std::size_t digits = name.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(name[digits - 1])))
    --digits;
  std::vector<std::string> out;
  for (std::size_t i = digits; i < name.size(); ++i) {
    const std::string vector = name.substr(0, digits) + name[i];
    const bool known = std::find(a.vectors.begin(), a.vectors.end(), vector) != a.vectors.end() ||
                       std::any_of(a.null.begin(), a.null.end(), [&](const auto &n) { return n.name == vector; });
    if (!known)
      return {};
    out.push_back(vector);
  }
  return out.size() < 2 ? std::vector<std::string>{} : out;
}

} // namespace meetc::lang
