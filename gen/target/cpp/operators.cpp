// Operators on blades, as a header that a program may include: sums, multiples and reverses of each type, and the products
// that the scene asks for as kernels.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace meetc::target {
namespace {

// A function of one or two blades of a type, each of whose coefficients is a term with the coefficients of X and Y.
template <class Term>
std::string by_coefficient(const std::string &type, const std::vector<lower::basis_blade> &blades,
                           const std::string &name, const std::string &parameters, Term term) {
  std::string out = fmt::format("template <class T> MEETC_HD constexpr {0}<T> operator{1}({2}) {3} {{\n  {0}<T> B;\n",
                                type, name, parameters, throws_nothing);
  for (const lower::basis_blade &b : blades)
    out += fmt::format("  B.{} = {};\n", blade_field(b), term(b));
  return out + "  return B;\n}\n";
}

std::string linear(const std::string &type, const std::vector<lower::basis_blade> &blades) {
  const std::string x = fmt::format("const {}<T> &X", type), y = fmt::format("const {}<T> &Y", type),
                    k = "const std::type_identity_t<T> &k";
  const auto term = [](const char *form) {
    return [form](const lower::basis_blade &b) { return fmt::format(fmt::runtime(form), blade_field(b)); };
  };
  const auto reversed = [](const lower::basis_blade &b) {
    const std::size_t grade = b.vectors.size();
    return fmt::format("{}X.{}", grade * (grade - (grade > 0)) / 2 % 2 ? "-" : "", blade_field(b));
  };
  return by_coefficient(type, blades, "+", x + ", " + y, term("X.{0} + Y.{0}")) +
         by_coefficient(type, blades, "-", x + ", " + y, term("X.{0} - Y.{0}")) +
         by_coefficient(type, blades, "-", x, term("-X.{0}")) +
         by_coefficient(type, blades, "*", k + ", " + x, term("k * X.{0}")) +
         by_coefficient(type, blades, "*", x + ", " + k, term("X.{0} * k")) +
         by_coefficient(type, blades, "~", x, reversed) + '\n';
}

// The operator that a kernel is, between its two operands; none for all else.
std::string operator_of(const lower::request &r) {
  const lang::expr *const body = r.body.get();
  if (!body || r.kinds.size() != 2 || body->args.size() != 2)
    return "";
  for (std::size_t i = 0; i < 2; ++i)
    if (body->args[i]->kind != lang::op::name || body->args[i]->text != r.names[i])
      return "";
  switch (body->kind) {
  case lang::op::multiply:
    return "*";
  case lang::op::outer:
    return "^";
  case lang::op::inner:
    return "|";
  case lang::op::builtin:
    return body->text == "regressive" ? "&" : "";
  default:
    return "";
  }
}

} // namespace

std::string operators_header(const unit &u) {
  std::vector<std::string> headers{"kinds.hpp"};
  std::string text, products;
  for (const lower::lowered_kind &k : u.kinds)
    if (k.has_blade())
      text += linear(identifier(k.name) + "_blade", k.blades);
  std::set<std::string> seen; // a scene may ask for one product under two names
  for (const lower::kernel &k : u.kernels) {
    if (k.is_predicate)
      continue;
    const bool has_type = !k.value.is_number() && !k.value.result_kind;
    if (has_type)
      text += linear(identifier(k.asked.name()) + "_result", k.value.result_names);
    const std::string name = operator_of(k.asked);
    if (has_type || !name.empty())
      headers.push_back(k.asked.name() + ".hpp");
    if (name.empty())
      continue;
    const std::string parameters = fmt::format("const {}_blade<T> &X, const {}_blade<T> &Y",
                                               identifier(k.asked.kinds[0]->name), identifier(k.asked.kinds[1]->name));
    if (seen.insert(name + parameters).second)
      products += fmt::format("// {}\ntemplate <class T> MEETC_HD constexpr auto operator{}({}) {} {{\n  return "
                              "{}(X, Y);\n}}\n",
                              k.asked.text, name, parameters, throws_nothing, kernel_function(k.asked));
  }
  std::sort(headers.begin() + 1, headers.end());
  return banner(u.scene, "Operators on blades: sums, multiples, reverses (~), and the products that are kernels.") +
         open_header(u.scene, "file_operators", headers, {}, formula_support) + text + products + close_header(u.scene);
}

} // namespace meetc::target
