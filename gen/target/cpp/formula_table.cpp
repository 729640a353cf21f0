// Formulas on columns of numbers: how to read their operands from a row and write their values, and the table by which a
// runtime knows them.
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

// Whether the formula has a function on stored operands.
bool on_stored(const unit &u, const lower::kernel &k) {
  return k.value.is_number() || std::all_of(k.asked.kinds.begin(), k.asked.kinds.end(), [&](const lang::kind *kind) {
           const auto &makers = u.kind(kind->name).makers;
           return std::any_of(makers.begin(), makers.end(), [](const auto &m) { return m.name.empty(); });
         });
}

std::string result_names(const lower::kernel &k) {
  if (k.value.is_number())
    return k.asked.function;
  std::vector<std::string> names;
  for (const lower::basis_blade &b : k.value.result_names)
    names.push_back(blade_field(b));
  return join(names, ",");
}

// The struct that formula_columns.hpp asks for.
std::string columns_struct(const unit &u, const lower::kernel &k) {
  const std::string space = identifier(u.scene.space);
  std::string operands, call, values;
  std::size_t numbers = 0, place = 0;
  for (const lang::kind *kind : k.asked.kinds) {
    const lower::lowered_kind &of = u.kind(kind->name);
    call += fmt::format("{}detail::{}_in(in{})", place ? ", " : "", identifier(of.name),
                        numbers ? fmt::format(" + {}", numbers) : "");
    for (std::size_t i = 0; i < of.reals.size(); ++i)
      operands += fmt::format("{}{}", operands.empty() ? "" : ", ", place);
    numbers += of.reals.size();
    ++place;
  }
  call = fmt::format("::{}::{}({})", space, kernel_function(k.asked), call);
  if (k.value.is_number()) {
    values = fmt::format("    out[0] = {};\n", call);
  } else {
    values = fmt::format("    const auto B = {};\n", call);
    std::size_t i = 0;
    for (const lower::basis_blade &b : k.value.result_names)
      values += fmt::format("    out[{}] = B.{};\n", i++, blade_field(b));
  }
  return fmt::format("// {}\nstruct {} {{\n  static constexpr int operands = {}, numbers = {}, results = {};\n"
                     "  MEETC_HD static constexpr int operand_of(int number) {{\n"
                     "    constexpr int all[] = {{{}}};\n    return all[number];\n  }}\n"
                     "  template <class T> MEETC_HD static void values({}const T *in, T *out) {{\n{}  }}\n}};\n\n",
                     k.asked.text, identifier(k.asked.name()), place, numbers, k.value.result_names.size(), operands,
                     numbers ? "" : "[[maybe_unused]] ", values);
}

} // namespace

std::vector<const lower::kernel *> formulas_on_columns(const unit &u) {
  std::vector<const lower::kernel *> out;
  for (const lower::kernel &k : u.kernels)
    if (!k.is_predicate && !k.asked.kinds.empty() && !k.value.result_names.empty() && on_stored(u, k))
      out.push_back(&k);
  return out;
}

std::string columns_header(const unit &u) {
  std::vector<std::string> headers;
  std::string structs;
  for (const lower::kernel *k : formulas_on_columns(u)) {
    headers.push_back(k->asked.name() + ".hpp");
    structs += columns_struct(u, *k);
  }
  std::sort(headers.begin(), headers.end());
  return banner(u.scene, "Formulas on rows of numbers.") + open_header(u.scene, "file_columns", headers) +
         "// operand_of(): the operand that a number of the row belongs to. values(): the row has the operands' "
         "stored\n"
         "// numbers one after another.\nnamespace detail::columns {\n\n" +
         structs + "} // namespace detail::columns\n" + close_header(u.scene);
}

std::string formulas_source(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string out = banner(u.scene, "The table of formulas.") +
                    fmt::format("#include <meetc/simd/formula_columns.hpp>\n\n#include <{0}/detail/columns.hpp>\n\n"
                                "MEETC_NAMESPACE({0}) {{\nnamespace detail {{\n\n",
                                space);
  std::string operands, entries;
  for (const lower::kernel *k : formulas_on_columns(u)) {
    const std::string name = identifier(k->asked.name());
    std::string kinds;
    for (const lang::kind *kind : k->asked.kinds) {
      const lower::lowered_kind &of = u.kind(kind->name);
      kinds +=
          fmt::format("{}{{\"{}\", \"{}\", {}}}", kinds.empty() ? "" : ", ", of.name, csv_names(of), of.reals.size());
    }
    operands += fmt::format("constexpr meetc::formula_operand {}_operands[] = {{{}}};\n", name, kinds);
    entries += fmt::format("    meetc::formula_of<columns::{0}>(\"{1}\", {0}_operands, \"{2}\"),\n", name,
                           k->asked.text, result_names(*k));
  }
  return out + "namespace {\n" + operands +
         fmt::format("}} // namespace\n\nconst meetc::formula_info *formulas() {{\n"
                     "  static const meetc::formula_info all[] = {{\n{}  }};\n  return all;\n}}\n\n"
                     "}} // namespace detail\n}} // namespace {}\n",
                     entries, space);
}

} // namespace meetc::target
