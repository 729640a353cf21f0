// Functions that are no polynomials: readings, as steps with their bounds, and functions of motions, by the header that
// computes them.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string type_of(const lang::kind *k) {
  return k ? identifier(k->name) + "<T>" : "T";
}

std::string reading_text(const unit &u, const lower::analytic_kernel &k) {
  const lower::reading &r = *k.read;
  const std::string kind = identifier(k.kind->name);
  const std::vector<lower::basis_blade> &blades = u.kind(k.kind->name).blades;
  const auto variable = [&](int i) {
    return i < std::ssize(blades) ? "X." + blade_field(blades[static_cast<std::size_t>(i)])
                                  : "v_" + r.variables[static_cast<std::size_t>(i)];
  };
  std::string out =
      fmt::format("// The geometry of a {0}, read back from its blade.\n//   exists: no divisor is 0; a quotient "
                  "by 0 is taken as 0.\n//   is_real: no radicand is negative; the root of a negative number "
                  "is taken as 0.\ntemplate <class T = float> struct {1}_given {{\n",
                  k.kind->name, kind);
  for (const lower::reading::entry &e : r.entries)
    out += fmt::format("  // {}\n  {} {};\n", e.text, type_of(e.kind), identifier(e.name));
  out += fmt::format("  bool exists, is_real;\n}};\n\n"
                     "// {0}. A bound that follows a step is of its values as functions of the numbers that it reads;\n"
                     "// a quotient and a root add a relative error of u.\n"
                     "template <class T> MEETC_HD inline {1}_given<T> gives(const {1}_blade<T> &X) {{\n"
                     "  {1}_given<T> given;\n  given.exists = given.is_real = true;\n",
                     k.text, kind);
  for (const lower::reading::step &s : r.steps) {
    body_names names = names_of_formula();
    names.input = variable;
    std::string all;
    for (std::size_t i = 0; i < s.code.results.size(); ++i)
      all += fmt::format("{}{}", i ? ", " : "", variable(s.sets[i]));
    names.result = [&](std::size_t i, const std::string &value) {
      const std::string left = variable(s.sets[i]);
      switch (s.makes) {
      case lower::reading::what::values:
        return fmt::format("{} = {};", left, value);
      case lower::reading::what::reciprocal:
        return fmt::format("{} = meetc::reciprocal<T>({}, given.exists);", left, value);
      default:
        return fmt::format("{} = meetc::root<T>({}, given.is_real);", left, value);
      }
    };
    out += fmt::format("  // {}{}\n  T {};\n  {{\n{}  }}\n",
                       s.makes == lower::reading::what::values       ? s.text + ". "
                       : s.makes == lower::reading::what::reciprocal ? "The divisor. "
                                                                     : "The radicand. ",
                       error_text(s.code), all, body(s.code, names, "    "));
  }
  for (const lower::reading::entry &e : r.entries) {
    std::string row;
    for (const int n : e.numbers)
      row += (row.empty() ? "" : ", ") + variable(n);
    out += e.kind ? fmt::format("  {{\n    const T row[] = {{{}}};\n    given.{} = detail::{}_in(row);\n  }}\n", row,
                                identifier(e.name), identifier(e.kind->name))
                  : fmt::format("  given.{} = {};\n", identifier(e.name), row);
  }
  return out + "  return given;\n}\n";
}

// "{X.scalar, {-X.e2_e3, ...}, ...}"
std::string motion_of(const lower::dual_numbers &numbers) {
  std::string out;
  for (std::size_t n = 0; n < 8; ++n) {
    const lower::dual_number &d = numbers[n];
    out += n == 0 ? "{" : n % 4 == 1 ? ", {" : ", ";
    out += !d.at ? "T(0)" : fmt::format("{}X.{}", d.sign < 0 ? "-" : "", blade_field(*d.at));
    out += n % 4 == 3 ? "}" : "";
  }
  return out + '}';
}

std::string motion_text(const unit &u, const lower::analytic_kernel &k) {
  const std::string kind = identifier(k.kind->name);
  std::string type = "T", out;
  if (k.result_kind) {
    type = identifier(k.result_kind->name) + "_blade<T>";
  } else if (!k.result.empty()) {
    std::vector<std::string> fields;
    for (const lower::basis_blade &b : k.result)
      fields.push_back(blade_field(b));
    type = identifier(k.name) + "_result<T>";
    out += fmt::format("template <class T = float> struct {}_result {{\n  T {};\n}};\n\n", identifier(k.name),
                       join(fields, ", "));
  }
  out += fmt::format("// {}: meetc::motions::{} says what it is and within which error. T is float or double.\n",
                     k.text, k.function);
  if (k.function == "pose") {
    const std::string shift =
        k.shift.get_den() == 1 ? k.shift.get_num().get_str() + ".0"
                               : fmt::format("{}.0 / {}.0", k.shift.get_num().get_str(), k.shift.get_den().get_str());
    return out + fmt::format("template <class T> MEETC_HD inline void pose(const {0}_blade<T> &X, double (&m)[12]) {{\n"
                             "  meetc::motions::pose<T>({1}, {2}, m);\n}}\n"
                             "template <class T> MEETC_HD inline void pose(const {0}<T> &X, double (&m)[12]) {{\n"
                             "  pose(blade(X), m);\n}}\n",
                             kind, motion_of(k.in), shift);
  }
  const std::string call = fmt::format("meetc::motions::{}<T>({})", k.function, motion_of(k.in)), name = k.function;
  if (type == "T") {
    out += fmt::format("template <class T> MEETC_HD inline T {}(const {}_blade<T> &X) {{\n  return {};\n}}\n", name,
                       kind, call);
  } else {
    out +=
        fmt::format("template <class T> MEETC_HD inline {} {}(const {}_blade<T> &X) {{\n  const meetc::motion<T> v = "
                    "{};\n  {} B;\n",
                    type, name, kind, call, type);
    const char *const numbers[] = {"s", "u[0]", "u[1]", "u[2]", "p", "w[0]", "w[1]", "w[2]"};
    const auto &blades = k.result_kind ? u.kind(k.result_kind->name).blades : k.result;
    for (const lower::basis_blade &b : blades) {
      const auto n = std::find_if(k.out.begin(), k.out.end(), [&](const lower::dual_number &d) { return d.at == b; });
      out += fmt::format("  B.{} = {};\n", blade_field(b),
                         n == k.out.end() ? "T(0)"
                                          : fmt::format("{}v.{}", n->sign < 0 ? "-" : "", numbers[n - k.out.begin()]));
    }
    out += "  return B;\n}\n";
  }
  return out + fmt::format("template <class T> MEETC_HD inline {} {}(const {}<T> &X) {{\n  return {}(blade(X));\n}}\n",
                           type, name, kind, name);
}

} // namespace

std::string analytic_text(const unit &u, std::size_t kernel) {
  const lower::analytic_kernel &k = u.analytic[kernel];
  return broken_lines(banner(u.scene, k.text) +
                      open_header(u.scene, "kernel_" + k.name, {"kinds.hpp"},
                                  {k.read ? "number/root.hpp" : "number/motion.hpp"}, formula_support) +
                      (k.read ? reading_text(u, k) : motion_text(u, k)) + close_header(u.scene));
}

} // namespace meetc::target
