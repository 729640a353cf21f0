// Kinds and blades as named tuples.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/python/python.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

// The arguments of a kind's tuple from columns[at], columns[at + 1], ...
std::string from_columns(const unit &u, const lower::lowered_kind &k, int &at) {
  std::vector<std::string> out;
  for (const lang::field &f : k.fields)
    out.push_back(f.type == "real" ? fmt::format("columns[{}]", at++)
                                   : fmt::format("{}({})", python_name(f.type), from_columns(u, u.kind(f.type), at)));
  return join(out, ", ");
}

std::string methods(const std::string &type, const std::string &kind, std::size_t numbers, const std::string &made,
                    const std::vector<std::string> &columns) {
  return fmt::format("\n    @staticmethod\n    def from_rows(rows: NDArray[np.floating[Any]]) -> {0}:\n"
                     "        \"\"\"From an array of shape (..., {2}): the numbers in memory order.\"\"\"\n"
                     "        columns = _columns(rows, {2}, \"{1}\")\n        return {0}({3})\n\n"
                     "    def rows(self) -> NDArray[np.floating[Any]]:\n"
                     "        \"\"\"An array of shape (..., {2}).\"\"\"\n        return _rows([{4}])\n",
                     type, kind, numbers, made, join(columns, ", "));
}

std::string stored_tuple(const unit &u, const lower::lowered_kind &k) {
  const std::string name = python_name(k.name);
  std::string out = fmt::format("\n\nclass {}(NamedTuple):\n    \"\"\"A {} as it is stored: {} numbers.\"\"\"\n\n",
                                name, k.name, k.reals.size());
  for (const lang::field &f : k.fields)
    out += fmt::format("    {}: {}\n", python_member(f.name), f.type == "real" ? "Numbers" : python_name(f.type));
  std::vector<std::string> columns;
  for (const lower::stored_real &r : k.reals)
    columns.push_back("self." + python_path(r.path));
  int at = 0;
  return out + methods(name, k.name, k.reals.size(), from_columns(u, k, at), columns);
}

std::string maker(const unit &u, const lower::lowered_kind &k, const lower::blade_maker &m) {
  std::vector<std::string> parameters;
  if (m.name.empty())
    parameters.push_back("k: " + python_name(k.name));
  else
    for (const lang::field &f : m.of)
      parameters.push_back(
          fmt::format("{}: {}", python_operand(u, f.name), f.type == "real" ? "Numbers" : python_name(f.type)));
  const auto input = [&](int i) {
    const std::string &path = m.inputs[static_cast<std::size_t>(i)];
    if (m.name.empty())
      return "k." + python_path(path);
    const std::size_t dot = path.find('.');
    const std::string operand = python_operand(u, path.substr(0, dot));
    return dot == std::string::npos ? operand : operand + '.' + python_path(path.substr(dot + 1));
  };
  const statements::text code = python_body(m.code, input);
  const std::string name = python_name(m.name.empty() ? "blade_of_" + k.name : k.name + "_from_" + m.name);
  return fmt::format("\n\ndef {}({}) -> {}:\n    \"\"\"{}\n\n    {}.\n    \"\"\"\n{}    return {}({})\n", name,
                     join(parameters, ", "), python_name(k.name + "_blade"), m.text,
                     count_text(ir::count(m.code.nodes, m.code.results)), code.before, python_name(k.name + "_blade"),
                     join(code.results, ", "));
}

} // namespace

std::string python_blade_tuple(const std::string &type, const std::string &what,
                               const std::vector<lower::basis_blade> &blades) {
  std::string out = fmt::format("\n\nclass {}(NamedTuple):\n    \"\"\"The coefficients of {}.\"\"\"\n\n", type, what);
  std::vector<std::string> columns, made;
  for (const lower::basis_blade &b : blades) {
    out += fmt::format("    {}: Numbers\n", python_member(blade_field(b)));
    made.push_back(fmt::format("columns[{}]", made.size()));
    columns.push_back("self." + python_member(blade_field(b)));
  }
  return out + methods(type, what, blades.size(), join(made, ", "), columns);
}

std::string python_kinds(const unit &u) {
  std::string out;
  for (const lower::lowered_kind &k : u.kinds)
    out += stored_tuple(u, k);
  for (const lower::lowered_kind &k : u.kinds) {
    if (!k.has_blade())
      continue;
    out += python_blade_tuple(python_name(k.name + "_blade"), "the blade of a " + k.name, k.blades);
    for (const lower::blade_maker &m : k.makers)
      out += maker(u, k, m);
  }
  return out;
}

} // namespace meetc::target
