// Functions that are no polynomials in C: declarations, and definitions in the library over the target cpp.
#include "gen/target/c/c.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

class writer {
public:
  writer(const unit &u, const lower::analytic_kernel &k, const c_number &n) : u_(u), k_(k), n_(n) {}

  // The struct for a value that is not the blade of a kind.
  std::string result_struct() const {
    std::string fields;
    if (k_.read) {
      for (const lower::reading::entry &e : k_.read->entries)
        fields += fmt::format("  {} {};\n", e.kind ? c_name(u_, e.kind->name, n_) : n_.type, identifier(e.name));
      fields += "  bool exists, is_real;\n";
    } else if (!k_.result_kind && !k_.result.empty()) {
      std::vector<std::string> names;
      for (const lower::basis_blade &b : k_.result)
        names.push_back(blade_field(b));
      fields = fmt::format("  {} {};\n", n_.type, join(names, ", "));
    }
    return fields.empty() ? "" : fmt::format("typedef struct {{\n{}}} {};\n", fields, type());
  }

  // On blades and, for all but readings, on stored operands.
  std::string declarations() const { return head("_blade") + ";\n" + (k_.read ? "" : head("") + ";\n"); }
  std::string definitions() const { return definition("_blade") + (k_.read ? "" : definition("")); }

private:
  const unit &u_;
  const lower::analytic_kernel &k_;
  const c_number &n_;

  bool is_pose() const { return k_.function == "pose"; }
  std::string type() const {
    return is_pose()           ? "void"
           : k_.read           ? c_name(u_, k_.kind->name + "_given", n_)
           : k_.result_kind    ? c_name(u_, k_.result_kind->name + "_blade", n_)
           : k_.result.empty() ? n_.type
                               : c_name(u_, k_.name + "_result", n_);
  }
  std::string head(const std::string &operand) const {
    return fmt::format("{} {}(const {} *X{})", type(), c_name(u_, k_.name + (operand.empty() ? "" : "_blades"), n_),
                       c_name(u_, k_.kind->name + operand, n_), is_pose() ? ", double m[12]" : "");
  }
  std::string definition(const std::string &operand) const {
    const std::string space = identifier(u_.scene.space);
    const std::string x = fmt::format("of<{}::{}<{}>>(X)", space, identifier(k_.kind->name) + operand, n_.type);
    if (is_pose()) // a parameter of C is a pointer
      return fmt::format("{} {{\n  double of_x[12];\n  {}::pose({}, of_x);\n  std::copy(of_x, of_x + 12, m);\n}}\n",
                         head(operand), space, x);
    const std::string value = fmt::format("{}::{}({})", space, k_.function, x);
    return fmt::format("{} {{\n  return {};\n}}\n", head(operand),
                       type() == n_.type ? value : fmt::format("std::bit_cast<{}>({})", type(), value));
  }
};

} // namespace

std::string c_analytic(const unit &u, const lower::analytic_kernel &k) {
  std::string out = fmt::format("/* {}, as in C++; in the library.{} */\n", k.text,
                                k.read ? " `exists`: no divisor is 0. `is_real`: no radicand is negative." : "");
  for (const c_number &n : c_numbers)
    out += writer(u, k, n).result_struct();
  for (const c_number &n : c_numbers)
    out += writer(u, k, n).declarations();
  return out + '\n';
}

std::string c_analytic_definitions(const unit &u, const lower::analytic_kernel &k) {
  std::string out;
  for (const c_number &n : c_numbers)
    out += writer(u, k, n).definitions();
  return out;
}

std::string c_analytic_text(const unit &u, std::size_t kernel) {
  return broken_lines(c_analytic(u, u.analytic[kernel]));
}

} // namespace meetc::target
