// Formulas in C, on blades and on stored operands.
#include "gen/ir/count.hpp"
#include "gen/target/c/c.hpp"
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

class writer {
public:
  writer(const unit &u, const lower::kernel &k, const c_number &n) : u_(u), k_(k), n_(n), f_(k.value) {}

  bool is_number() const { return f_.is_number(); }

  // The struct for a value that is not the blade of a kind.
  std::string result_struct() const {
    if (is_number() || f_.result_kind)
      return "";
    std::vector<std::string> fields;
    for (const lower::basis_blade &b : f_.result_names)
      fields.push_back(blade_field(b));
    return fmt::format("typedef struct {{\n  {} {};\n}} {};\n", n_.type, join(fields, ", "), type());
  }

  std::string on_blades() const {
    std::vector<std::string> inputs;
    for (std::size_t i = 0; i < k_.asked.kinds.size(); ++i)
      for (const lower::basis_blade &b : u_.kind(k_.asked.kinds[i]->name).blades)
        inputs.push_back(c_operand(k_.asked.names[i]) + "->" + blade_field(b));
    return function("_blades", "_blade", f_.from_blades, inputs);
  }

  std::string on_stored() const {
    if (is_number()) {
      std::vector<std::string> inputs;
      for (std::size_t i = 0; i < k_.asked.kinds.size(); ++i)
        for (const lower::stored_real &r : u_.kind(k_.asked.kinds[i]->name).reals)
          inputs.push_back(c_operand(k_.asked.names[i]) + "->" + path_identifier(r.path));
      return function("", "", f_.from_stored, inputs);
    }
    std::string code, call;
    for (std::size_t i = 0; i < k_.asked.kinds.size(); ++i) {
      const std::string kind = k_.asked.kinds[i]->name, operand = c_operand(k_.asked.names[i]);
      code += fmt::format("  const {} of_{} = {}({});\n", c_name(u_, kind + "_blade", n_), operand,
                          c_name(u_, "blade_of_" + kind, n_), operand);
      call += fmt::format("{}&of_{}", i ? ", " : "", operand);
    }
    return fmt::format("static inline {} {}({}) {{\n{}  return {}({});\n}}\n", type(), name(""), parameters(""), code,
                       name("_blades"), call);
  }

private:
  const unit &u_;
  const lower::kernel &k_;
  const c_number &n_;
  const lower::formula &f_;

  std::string name(const char *suffix) const { return c_name(u_, k_.asked.name() + suffix, n_); }
  std::string type() const {
    return is_number()      ? n_.type
           : f_.result_kind ? c_name(u_, f_.result_kind->name + "_blade", n_)
                            : c_name(u_, k_.asked.name() + "_result", n_);
  }
  std::string parameters(const char *suffix) const {
    std::vector<std::string> list;
    for (std::size_t i = 0; i < k_.asked.kinds.size(); ++i)
      list.push_back(
          fmt::format("const {} *{}", c_name(u_, k_.asked.kinds[i]->name + suffix, n_), c_operand(k_.asked.names[i])));
    return join(list, ", ");
  }

  std::string function(const char *suffix, const char *of, const ir::program &p,
                       const std::vector<std::string> &inputs) const {
    const auto result = [&](std::size_t i, const std::string &value) {
      return is_number() ? fmt::format("return {};", value)
                         : fmt::format("B.{} = {};", blade_field(f_.result_names[i]), value);
    };
    const std::string code = c_body(
        p, n_, c_multiply_add(u_, n_), [&](int i) { return inputs[static_cast<std::size_t>(i)]; }, result);
    if (&p == &f_.from_blades)
      check_whole(f_, code);
    std::string out = fmt::format("static inline {} {}({}) {{\n  MEETC_{}_{}_AS_WRITTEN\n", type(), name(suffix),
                                  parameters(of), identifier(u_.scene.space).size(), identifier(u_.scene.space));
    std::string rest;
    for (const std::string &operand : k_.asked.names)
      if (code.find(c_operand(operand) + "->") == std::string::npos)
        rest += fmt::format("  (void){};\n", c_operand(operand));
    if (is_number())
      return out + rest + code + "}\n";
    out += fmt::format("  {} B;\n", type()) + rest + code;
    if (f_.result_kind)
      for (const lower::basis_blade &b : u_.kind(f_.result_kind->name).blades)
        if (std::find(f_.result_names.begin(), f_.result_names.end(), b) == f_.result_names.end())
          out += fmt::format("  B.{} = 0;\n", blade_field(b));
    return out + "  return B;\n}\n";
  }
};

} // namespace

std::string c_formula(const unit &u, const lower::kernel &k) {
  std::string out = fmt::format("/* {}, on blades: {}. {} */\n", k.asked.text,
                                count_text(ir::count(k.value.from_blades.nodes, k.value.from_blades.results)),
                                error_text(k.value.from_blades));
  for (const std::string &line : assumption_lines(k.value.assumed, k.value.result_names, k.value.blade_inputs))
    out += fmt::format("/* {} */\n", line);
  for (const c_number &n : c_numbers)
    out += writer(u, k, n).result_struct() + writer(u, k, n).on_blades();
  out += writer(u, k, c_numbers[0]).is_number()
             ? fmt::format("/* From stored numbers, in differences if the value is translation invariant: {}. {} */\n",
                           count_text(ir::count(k.value.from_stored.nodes, k.value.from_stored.results)),
                           error_text(k.value.from_stored))
             : "/* From stored numbers. */\n";
  for (const c_number &n : c_numbers)
    out += writer(u, k, n).on_stored();
  return out + '\n';
}

} // namespace meetc::target
