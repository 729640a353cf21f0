// Kinds as structs: the stored numbers, whether they are valid, their row, and the blade with its constructors.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

// The condition that predicates assume of an operand: finite numbers, and the kind's `where`.
std::string valid_text(const lower::lowered_kind &k) {
  std::string holds;
  for (const lower::stored_real &r : k.reals)
    holds += fmt::format("{}meetc::is_finite(k.{})", holds.empty() ? "" : " &&\n      ", path_identifier(r.path));
  std::string rule;
  if (k.enclosed && k.enclosed->rule) {
    holds += " &&\n      " + rule_test(*k.enclosed->rule, [&](int i) {
               return "k." + path_identifier(k.reals[static_cast<std::size_t>(i)].path);
             });
    rule = fmt::format(" and {}", k.enclosed->rule->text);
  }
  return fmt::format("// Whether all numbers are finite{}, by their bits. Predicates assume it.\n"
                     "template <class T> MEETC_HD inline bool valid(const {}<T> &k) {{\n  return {};\n}}\n",
                     rule, identifier(k.name), holds);
}

std::string struct_text(const unit &u, const lower::lowered_kind &k) {
  const std::string name = identifier(k.name);
  std::string out = fmt::format("// A {} as it is stored: {} numbers.\ntemplate <class T = float> struct {} {{\n",
                                k.name, k.reals.size(), name);
  for (std::size_t i = 0; i < k.fields.size();) {
    // Adjacent members of one type share a line.
    std::vector<std::string> names;
    const std::string &type = k.fields[i].type;
    bool clash = false; // a member named like its type would change the meaning of that name
    for (; i < k.fields.size() && k.fields[i].type == type; ++i) {
      names.push_back(identifier(k.fields[i].name));
      for (const lang::field &f : k.fields)
        clash = clash || identifier(f.name) == identifier(type);
    }
    const std::string space = clash ? "::" + identifier(u.scene.space) + "::" : "";
    out += fmt::format("  {} {};\n", type == "real" ? "T" : space + identifier(type) + "<T>", join(names, ", "));
  }
  out += "};\n";
  out += fmt::format("template <class T> MEETC_HD constexpr void to_row(const {}<T> &k, T *out) {} {{\n", name,
                     throws_nothing);
  int i = 0;
  for (const lower::stored_real &r : k.reals)
    out += fmt::format("  out[{}] = k.{};\n", i++, path_identifier(r.path));
  return out + "}\n" + valid_text(k) + "\n";
}

// Reads a kind's struct from the row, starting at `at`, which moves past it.
std::string members_in_row(const unit &u, const lower::lowered_kind &k, int &at) {
  std::string out;
  for (const lang::field &f : k.fields)
    out += (out.empty() ? "" : ", ") +
           (f.type == "real" ? fmt::format("row[{}]", at++) : '{' + members_in_row(u, u.kind(f.type), at) + '}');
  return out;
}
std::string row_reader(const unit &u, const lower::lowered_kind &k) {
  int at = 0;
  const std::string members = members_in_row(u, k, at);
  return fmt::format(
      "template <class T> MEETC_HD MEETC_INLINE constexpr {0}<T> {0}_in(const T *row) {2} {{\n  return {{{1}}};\n}}\n",
      identifier(k.name), members, throws_nothing);
}

std::string blade_struct(const lower::lowered_kind &k) {
  std::vector<std::string> fields, blades;
  for (const lower::basis_blade &b : k.blades) {
    fields.push_back(blade_field(b));
    blades.push_back(b.text());
  }
  return fmt::format("// The blade of a {}: coefficients on {}.\ntemplate <class T = float> struct {}_blade {{\n"
                     "  T {};\n}};\n",
                     k.name, join(blades, ", "), identifier(k.name), join(fields, ", "));
}

std::string maker_text(const lower::lowered_kind &k) {
  std::string out;
  for (const lower::blade_maker &maker : k.makers) {
    out += fmt::format("// {}\n// {}. {}\n", maker.text, count_text(ir::count(maker.code.nodes, maker.code.results)),
                       error_text(maker.code));
    std::string parameters;
    if (maker.name.empty()) {
      parameters = fmt::format("const {}<T> &k", identifier(k.name));
      out += fmt::format("template <class T> MEETC_HD constexpr {}_blade<T> blade({}) {} {{\n", identifier(k.name),
                         parameters, throws_nothing);
    } else {
      for (const lang::field &f : maker.of)
        parameters += fmt::format("{}const {} &{}", parameters.empty() ? "" : ", ",
                                  f.type == "real" ? "T" : identifier(f.type) + "<T>", identifier(f.name));
      out += fmt::format("template <class T> MEETC_HD constexpr {0}_blade<T> {1}({2}) {3} {{\n", identifier(k.name),
                         identifier(k.name + "_from_" + maker.name), parameters, throws_nothing);
    }
    body_names names = names_of_formula();
    names.input = [&](int i) {
      return (maker.name.empty() ? "k." : "") + path_identifier(maker.inputs[static_cast<std::size_t>(i)]);
    };
    names.result = [&](std::size_t i, const std::string &value) {
      return fmt::format("B.{} = {};", blade_field(k.blades[i]), value);
    };
    out += fmt::format("  {}_blade<T> B;\n", identifier(k.name)) + body(maker.code, names, "  ") + "  return B;\n}\n";
  }
  return out + "\n";
}

} // namespace

std::string kinds_header(const unit &u) {
  std::string out = banner(u.scene, "Kinds: the stored numbers, and the blades that they represent.");
  out += open_header(u.scene, "file_kinds", {}, {"environment/valid.hpp"}, formula_support);
  for (const lower::lowered_kind &k : u.kinds)
    out += struct_text(u, k);
  out += "// Reads kinds from rows.\nnamespace detail {\n";
  for (const lower::lowered_kind &k : u.kinds)
    out += row_reader(u, k);
  out += "} // namespace detail\n\n";
  for (const lower::lowered_kind &k : u.kinds)
    if (k.has_blade())
      out += blade_struct(k) + maker_text(k);
  return out + close_header(u.scene);
}

} // namespace meetc::target
