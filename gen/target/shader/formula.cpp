// Formulas, on blades and on stored operands.
#include "gen/ir/count.hpp"
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/shader/shader.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

class writer {
public:
  writer(const shader_language &l, const unit &u, const lower::kernel &k) : l_(l), u_(u), k_(k), f_(k.value) {
    for (const std::string &name : k.asked.names)
      operands_.push_back(shader_operand(name));
  }

  std::string text() const {
    std::string out = fmt::format("// {}, on blades: {}\n", k_.asked.text, says(f_.from_blades));
    for (const std::string &line : assumption_lines(f_.assumed, f_.result_names, f_.blade_inputs))
      out += fmt::format("// {}\n", line);
    return out + result_struct() + on_blades() + on_stored() + '\n';
  }

private:
  const shader_language &l_;
  const unit &u_;
  const lower::kernel &k_;
  const lower::formula &f_;
  std::vector<std::string> operands_;

  // The error is that of operations in this order, which a shader keeps where its values are precise.
  std::string says(const ir::program &p) const {
    const std::string counts = count_text(ir::count(p.nodes, p.results));
    return l_.keeps_order ? fmt::format("{}.\n// {}", counts, error_text(p)) : counts + '.';
  }
  std::string type() const {
    return f_.is_number()   ? l_.number
           : f_.result_kind ? shader_name(u_, f_.result_kind->name + "_blade")
                            : shader_name(u_, k_.asked.name() + "_result");
  }
  std::vector<std::string> parameters(const char *suffix) const {
    std::vector<std::string> list;
    for (std::size_t i = 0; i < operands_.size(); ++i)
      list.push_back(l_.declared(shader_name(u_, k_.asked.kinds[i]->name + suffix), operands_[i]));
    return list;
  }

  // The struct for a value that is not the blade of a kind.
  std::string result_struct() const {
    if (f_.is_number() || f_.result_kind)
      return "";
    std::vector<std::pair<std::string, std::string>> members;
    for (const lower::basis_blade &b : f_.result_names)
      members.emplace_back(l_.number, shader_member(blade_field(b)));
    return shader_struct(l_, type(), members);
  }

  std::string on_blades() const {
    std::vector<std::string> inputs;
    for (std::size_t i = 0; i < operands_.size(); ++i)
      for (const lower::basis_blade &b : u_.kind(k_.asked.kinds[i]->name).blades)
        inputs.push_back(operands_[i] + '.' + shader_member(blade_field(b)));
    std::string code = statements_of(f_.from_blades, inputs);
    if (f_.result_kind)
      for (const lower::basis_blade &b : u_.kind(f_.result_kind->name).blades)
        if (std::find(f_.result_names.begin(), f_.result_names.end(), b) == f_.result_names.end())
          code += fmt::format("  B.{} = 0.0;\n", shader_member(blade_field(b)));
    return shader_function(l_, type(), shader_name(u_, k_.asked.name() + "_blades"), parameters("_blade"), "B", code);
  }

  std::string on_stored() const {
    const std::string name = shader_name(u_, k_.asked.name());
    if (f_.is_number()) {
      std::vector<std::string> inputs;
      for (std::size_t i = 0; i < operands_.size(); ++i)
        for (const lower::stored_real &r : u_.kind(k_.asked.kinds[i]->name).reals)
          inputs.push_back(operands_[i] + '.' + shader_path(r.path));
      return fmt::format("// From stored numbers, in differences if the value is translation invariant: {}\n",
                         says(f_.from_stored)) +
             shader_function(l_, type(), name, parameters(""), "B", statements_of(f_.from_stored, inputs));
    }
    std::vector<std::string> blades;
    for (std::size_t i = 0; i < operands_.size(); ++i)
      blades.push_back(fmt::format("{}({})", shader_name(u_, "blade_of_" + k_.asked.kinds[i]->name), operands_[i]));
    return fmt::format("// From stored numbers.\n{} {{\n  return {}({});\n}}\n",
                       l_.head(type(), name, join(parameters(""), ", ")), shader_name(u_, k_.asked.name() + "_blades"),
                       join(blades, ", "));
  }

  std::string statements_of(const ir::program &p, const std::vector<std::string> &inputs) const {
    return shader_body(
        l_, p, [&](int i) { return inputs[static_cast<std::size_t>(i)]; },
        [&](std::size_t i, const std::string &value) {
          return f_.is_number() ? fmt::format("B = {};", value)
                                : fmt::format("B.{} = {};", shader_member(blade_field(f_.result_names[i])), value);
        });
  }
};

} // namespace

std::string shader_formula(const shader_language &l, const unit &u, const lower::kernel &k) {
  return writer(l, u, k).text();
}

} // namespace meetc::target
