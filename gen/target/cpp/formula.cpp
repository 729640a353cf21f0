// A formula as functions on blades and on stored operands.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

// Marks an operand that nothing reads, so that no compiler warns about it.
std::string unused_mark(const std::string &body, const std::string &name) {
  return body.find(name + '.') == std::string::npos ? "[[maybe_unused]] " : "";
}

// A pointer parameter, without its name where nothing reads it.
std::string pointer(const char *type, const std::string &name, const std::string &reads) {
  return fmt::format("{} *{}", type, reads.find(name + '[') == std::string::npos ? "" : name);
}

// A program for many pairs, whose objects store what each alone decides.
struct three_functions {
  const ir::program &code;
  std::string says;          // the comment's first sentences
  std::string operand;       // after the kind's name: "" or "_blade"
  std::string result;        // the type
  std::string before, after; // statements of the pair around those of the program
};

std::string for_pairs(const lower::kernel &k, const body_names &names, const three_functions &f) {
  const stored_body stored = stored_parts(f.code, names, "    ");
  const std::string pair = f.before + pair_body(f.code, stored, names, false, {}, "    ") + f.after;
  const auto operand = [&](std::size_t i, const std::string &reads) {
    const std::string name = identifier(k.asked.names[i]);
    return fmt::format("{}const {}{}<T> &{}", unused_mark(reads, name), identifier(k.asked.kinds[i]->name), f.operand,
                       name);
  };
  std::string out = fmt::format("\n{}"
                                "// Each object computes once, into f, what it alone decides, and each pair reads "
                                "these values as fa and fb. The\n"
                                "// whole has other operations than the function above, and so rounds otherwise.\n"
                                "struct {} {{\n  static constexpr int fields_a = {}, fields_b = {};\n",
                                f.says, identifier(k.asked.name()), stored.fields_a, stored.fields_b);
  for (const auto &[i, where, text] : {std::tuple(std::size_t{0}, poly::residency::a, stored.object_a),
                                       std::tuple(std::size_t{1}, poly::residency::b, stored.object_b)})
    out +=
        fmt::format("  // {}.\n  template <class T> MEETC_HD static constexpr void object_{}({}, {}) {} {{\n{}  }}\n",
                    count_text(ir::count_object(f.code, where)), i == 0 ? 'a' : 'b', operand(i, text),
                    pointer("T", "f", text), throws_nothing, text);
  return out +
         fmt::format(
             "  // {}.\n  template <class T> MEETC_HD static constexpr {} pair({}, {}, {}, {}) {} {{\n{}  }}\n}};\n",
             count_text(ir::count_pair(f.code)), f.result, operand(0, pair), pointer("const T", "fa", pair),
             operand(1, pair), pointer("const T", "fb", pair), throws_nothing, pair);
}

std::string comment(const std::vector<std::string> &lines) {
  std::string out;
  for (const std::string &line : lines)
    out += wrapped(line, "// ");
  return out;
}

// Whether blades of the kind have several grades, as motors and rotors have.
bool is_versor(const lower::lowered_kind &k) {
  return std::any_of(k.blades.begin(), k.blades.end(),
                     [&](const lower::basis_blade &b) { return b.vectors.size() != k.blades.front().vectors.size(); });
}

// Where an operand is a versor, blades and stored operands mix, so that products of versors act on what is stored.
std::string mixed_operands(const unit &u, const lower::kernel &k, const std::string &type) {
  const std::vector<const lang::kind *> &kinds = k.asked.kinds;
  constexpr std::size_t most_operands = 4; // of which there are 14 mixtures
  const bool versors =
      std::any_of(kinds.begin(), kinds.end(), [&](const lang::kind *kind) { return is_versor(u.kind(kind->name)); });
  std::string out;
  if (!versors || kinds.size() > most_operands)
    return out;
  const std::size_t all = (std::size_t{1} << kinds.size()) - 1;
  for (std::size_t stored = 1; stored < all; ++stored) {
    std::vector<std::string> parameters, arguments;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      const bool is_stored = stored >> i & 1;
      const std::string name = identifier(k.asked.names[i]);
      parameters.push_back(
          fmt::format("const {}{}<T> &{}", identifier(kinds[i]->name), is_stored ? "" : "_blade", name));
      arguments.push_back(is_stored ? fmt::format("blade({})", name) : name);
    }
    out += fmt::format("template <class T> MEETC_HD constexpr {} {}({}) {} {{\n  return {}({});\n}}\n", type,
                       kernel_function(k.asked), join(parameters, ", "), throws_nothing, kernel_function(k.asked),
                       join(arguments, ", "));
  }
  return out;
}

} // namespace

std::string formula_header(const unit &u, const lower::kernel &k) {
  const lower::formula &f = k.value;
  const bool number = f.is_number();
  std::string out;
  if (!number && !f.result_kind) {
    std::vector<std::string> fields;
    for (const lower::basis_blade &b : f.result_names)
      fields.push_back(blade_field(b));
    out += fmt::format("template <class T = float> struct {}_result {{\n  T {};\n}};\n\n", identifier(k.asked.name()),
                       join(fields, ", "));
  }
  const std::string type = number          ? "T"
                           : f.result_kind ? identifier(f.result_kind->name) + "_blade<T>"
                                           : identifier(k.asked.name()) + "_result<T>";
  std::vector<std::string> blade_names;
  for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
    for (const lower::basis_blade &b : u.kind(k.asked.kinds[i]->name).blades)
      blade_names.push_back(k.asked.names[i] + '.' + blade_field(b));
  std::string prepared;
  // On blades.
  out += fmt::format("// {} on blades\n", k.asked.text);
  for (std::size_t i = 0; i < f.result_names.size(); ++i) {
    const std::string left = number ? "" : "B." + blade_field(f.result_names[i]) + " = ";
    if (!f.is_expanded())
      out += fmt::format("//   {}too long to be expanded\n", left);
    else if (f.polynomials[i].length() <= 60)
      out += wrapped(left + poly_with_names(f.polynomials[i], blade_names), "//   ");
    else
      out += fmt::format("//   {}{} terms when expanded\n", left, f.polynomials[i].length());
  }
  out += fmt::format("// {}.\n// {}\n", count_text(ir::count(f.from_blades.nodes, f.from_blades.results)),
                     error_text(f.from_blades));
  out += comment(assumption_lines(f.assumed, f.result_names, blade_names));
  const auto parameters = [&](const char *suffix, const std::string &reads) {
    std::string list;
    for (std::size_t i = 0; i < k.asked.kinds.size(); ++i) {
      const std::string kind = identifier(k.asked.kinds[i]->name), name = identifier(k.asked.names[i]);
      list += fmt::format("{}{}const {}{}<T> &{}", i ? ", " : "", unused_mark(reads, name), kind, suffix, name);
    }
    return list;
  };
  std::string call;
  for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
    call += fmt::format("{}blade({})", i ? ", " : "", identifier(k.asked.names[i]));
  body_names names = names_of_formula();
  names.input = [&](int i) { return blade_names[static_cast<std::size_t>(i)]; };
  if (number) {
    names.result = [](std::size_t, const std::string &value) { return fmt::format("return {};", value); };
    const std::string code = body(f.from_blades, names, "  ");
    check_whole(f, code);
    out += fmt::format("template <class T> MEETC_HD constexpr T {}({}) {} {{\n{}}}\n", kernel_function(k.asked),
                       parameters("_blade", code), throws_nothing, code);
  } else {
    names.result = [&](std::size_t i, const std::string &value) {
      return fmt::format("B.{} = {};", blade_field(f.result_names[i]), value);
    };
    std::string rest;
    if (f.result_kind)
      for (const lower::basis_blade &b : u.kind(f.result_kind->name).blades)
        if (std::find(f.result_names.begin(), f.result_names.end(), b) == f.result_names.end())
          rest += fmt::format("  B.{} = meetc::number<T>(0);\n", blade_field(b));
    const std::string code = body(f.from_blades, names, "  ");
    check_whole(f, code);
    out += fmt::format("template <class T> MEETC_HD constexpr {} {}({}) {} {{\n  {} B;\n{}{}  return B;\n}}\n", type,
                       kernel_function(k.asked), parameters("_blade", code), throws_nothing, type, code, rest);
    if (!f.prepared.results.empty()) {
      std::string indented;
      for (std::size_t from = 0; from < rest.size();) {
        const std::size_t to = rest.find('\n', from) + 1;
        indented += "  " + rest.substr(from, to - from);
        from = to;
      }
      const std::string says =
          fmt::format("// {} on blades, for many pairs. {}\n", k.asked.text, error_text(f.prepared)) +
          comment(assumption_lines(f.prepared_assumed, f.result_names, blade_names));
      prepared = for_pairs(
          k, names, {f.prepared, says, "_blade", type, fmt::format("    {} B;\n", type), indented + "    return B;\n"});
    }
  }
  // On stored operands.
  if (number) {
    std::vector<std::string> inputs;
    for (std::size_t i = 0; i < k.asked.kinds.size(); ++i)
      for (const lower::stored_real &r : u.kind(k.asked.kinds[i]->name).reals)
        inputs.push_back(identifier(k.asked.names[i]) + '.' + path_identifier(r.path));
    names.input = [&](int i) { return inputs[static_cast<std::size_t>(i)]; };
    out += fmt::format(
        "\n// {} from stored numbers, in differences if it is translation invariant; B is not computed.\n"
        "// {}.\n// {}\n",
        k.asked.text, count_text(ir::count(f.from_stored.nodes, f.from_stored.results)), error_text(f.from_stored));
    const std::string code = body(f.from_stored, names, "  ");
    out += fmt::format("template <class T> MEETC_HD constexpr T {}({}) {} {{\n{}}}\n", kernel_function(k.asked),
                       parameters("", code), throws_nothing, code);
    if (!f.for_pairs.results.empty())
      out += for_pairs(
          k, names,
          {f.for_pairs,
           fmt::format("// {} from stored numbers, for many pairs. {}\n", k.asked.text, error_text(f.for_pairs)), "",
           "T", "", ""});
  } else {
    std::string all;
    for (const std::string &name : k.asked.names)
      all += identifier(name) + '.';
    out += fmt::format("template <class T> MEETC_HD constexpr {} {}({}) {} {{\n  return {}({});\n}}\n", type,
                       kernel_function(k.asked), parameters("", all), throws_nothing, kernel_function(k.asked), call);
  }
  return out + prepared + mixed_operands(u, k, type);
}

} // namespace meetc::target
