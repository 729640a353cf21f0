// Formulas in Python, on blades and on stored operands.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/python/python.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

class writer {
public:
  writer(const unit &u, const lower::kernel &k) : u_(u), k_(k), f_(k.value) {
    for (const std::string &name : k.asked.names)
      operands_.push_back(python_operand(u, name));
  }

  std::string text() const {
    std::string out = result_tuple() + fmt::format("\n\ndef {}({}) -> {}:\n", name(), parameters(), type());
    out += fmt::format("    \"\"\"{}\n\n    On blades: {}. {}\n", k_.asked.text, counted(f_.from_blades),
                       error_text(f_.from_blades));
    for (const std::string &line : assumption_lines(f_.assumed, f_.result_names, f_.blade_inputs))
      out += fmt::format("    {}\n", line);
    if (f_.is_number())
      out += fmt::format("    From stored numbers: {}. {}\n", counted(f_.from_stored), error_text(f_.from_stored));
    out += "    \"\"\"\n";
    if (f_.is_number())
      out += from_stored();
    for (std::size_t i = 0; i < operands_.size(); ++i)
      out += fmt::format("    {0}_blade = {0} if isinstance({0}, {1}) else blade_of_{2}({0})\n", operands_[i],
                         blade_type(i), identifier(k_.asked.kinds[i]->name));
    return out + from_blades();
  }

private:
  const unit &u_;
  const lower::kernel &k_;
  const lower::formula &f_;
  std::vector<std::string> operands_;

  std::string name() const { return python_name(k_.asked.name()); }
  std::string stored_type(std::size_t i) const { return python_name(k_.asked.kinds[i]->name); }
  std::string blade_type(std::size_t i) const { return python_name(k_.asked.kinds[i]->name + "_blade"); }
  std::string type() const {
    return f_.is_number()   ? "Numbers"
           : f_.result_kind ? python_name(f_.result_kind->name + "_blade")
                            : python_name(k_.asked.name() + "_result");
  }
  static std::string counted(const ir::program &p) { return count_text(ir::count(p.nodes, p.results)); }

  std::string parameters() const {
    std::vector<std::string> list;
    for (std::size_t i = 0; i < operands_.size(); ++i)
      list.push_back(fmt::format("{}: {} | {}", operands_[i], stored_type(i), blade_type(i)));
    return join(list, ", ");
  }

  // The tuple of a value that is not the blade of a kind.
  std::string result_tuple() const {
    return f_.is_number() || f_.result_kind ? "" : python_blade_tuple(type(), k_.asked.text, f_.result_names);
  }

  std::string from_stored() const {
    std::vector<std::string> inputs, tests;
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      tests.push_back(fmt::format("isinstance({}, {})", operands_[i], stored_type(i)));
      for (const lower::stored_real &r : u_.kind(k_.asked.kinds[i]->name).reals)
        inputs.push_back(operands_[i] + '.' + python_path(r.path));
    }
    const statements::text code =
        python_body(f_.from_stored, [&](int i) { return inputs[static_cast<std::size_t>(i)]; });
    std::string out = fmt::format("    if {}:\n", join(tests, " and "));
    for (std::size_t from = 0; from < code.before.size();) {
      const std::size_t end = code.before.find('\n', from) + 1;
      out += "    " + code.before.substr(from, end - from);
      from = end;
    }
    return out + fmt::format("        return {}\n", code.results.at(0));
  }

  std::string from_blades() const {
    std::vector<std::string> inputs;
    for (std::size_t i = 0; i < operands_.size(); ++i)
      for (const lower::basis_blade &b : u_.kind(k_.asked.kinds[i]->name).blades)
        inputs.push_back(operands_[i] + "_blade." + python_member(blade_field(b)));
    const statements::text code =
        python_body(f_.from_blades, [&](int i) { return inputs[static_cast<std::size_t>(i)]; });
    if (f_.is_number())
      return code.before + fmt::format("    return {}\n", code.results.at(0));
    std::vector<std::string> members;
    for (std::size_t i = 0; i < code.results.size(); ++i)
      members.push_back(
          fmt::format("        {}={},\n", python_member(blade_field(f_.result_names[i])), code.results[i]));
    if (f_.result_kind)
      for (const lower::basis_blade &b : u_.kind(f_.result_kind->name).blades)
        if (std::find(f_.result_names.begin(), f_.result_names.end(), b) == f_.result_names.end())
          members.push_back(fmt::format("        {}=0.0,\n", python_member(blade_field(b))));
    return code.before + fmt::format("    return {}(\n{}    )\n", type(), join(members, ""));
  }
};

} // namespace

std::string python_formula(const unit &u, const lower::kernel &k) {
  return writer(u, k).text();
}

} // namespace meetc::target
