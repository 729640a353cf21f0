// The functions of the C header that need the target cpp, with C linkage.
#include "gen/target/c/c.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

// "of<cga::triangle<float>>(A), of<cga::triangle<float>>(B)".
std::string converted(const unit &u, const lower::kernel &k) {
  std::string out;
  for (std::size_t i = 0; i < 2; ++i)
    out += fmt::format("{}of<{}::{}<float>>({})", i ? ", " : "", identifier(u.scene.space),
                       identifier(k.asked.kinds[i]->name), c_operand(k.asked.names[i]));
  return out;
}

std::string function(const unit &u, const lower::kernel &k, const char *type, const char *suffix,
                     const std::string &value) {
  std::string parameters;
  for (std::size_t i = 0; i < 2; ++i)
    parameters += fmt::format("{}const {} *{}", i ? ", " : "", c_name(u, k.asked.kinds[i]->name, c_numbers[1]),
                              c_operand(k.asked.names[i]));
  return fmt::format("{} {}_{}{}({}) {{\n  return {};\n}}\n", type, identifier(u.scene.space),
                     identifier(k.asked.name()), suffix, parameters, value);
}

} // namespace

std::string c_library(const unit &u) {
  const std::string space = identifier(u.scene.space);
  const bool copies = std::any_of(u.analytic.begin(), u.analytic.end(),
                                  [](const lower::analytic_kernel &k) { return k.function == "pose"; });
  std::string out = fmt::format("#include <{0}/{0}.h>\n#include <{0}/{0}.hpp>\n\n{1}#include <bit>\n\nnamespace {{\n\n"
                                "// The structs of both languages hold the same floats in the same order.\n"
                                "template <class T, class C> T of(const C *k) {{\n"
                                "  static_assert(sizeof(T) == sizeof(C));\n  return std::bit_cast<T>(*k);\n}}\n\n"
                                "}} // namespace\n\nextern \"C\" {{\n\n",
                                space, copies ? "#include <algorithm>\n" : "");
  for (const lower::lowered_kind &k : u.kinds)
    out += fmt::format("bool {0}_valid_{1}(const {2} *k) {{\n  return {0}::valid(of<{0}::{1}<float>>(k));\n}}\n", space,
                       identifier(k.name), c_name(u, k.name, c_numbers[1]));
  out += '\n';
  for (const lower::kernel &k : u.kernels) {
    if (!k.is_predicate)
      continue;
    const std::string operands = converted(u, k);
    const bool never_wrong = u.asks(lang::rung::certified) || u.asks(lang::rung::exact);
    if (k.is_sign) {
      const std::string call = fmt::format("static_cast<int>({}::{}", space, kernel_function(k.asked));
      if (u.asks(lang::rung::fp64x2))
        out += function(u, k, "int", "_fp64x2", fmt::format("{}_plain<meetc::double_double>({}))", call, operands));
      if (never_wrong)
        out += function(u, k, "int", "", fmt::format("{}({}))", call, operands));
      continue;
    }
    const std::string of = fmt::format("{}::{}::", space, identifier(k.asked.asked->name));
    if (u.asks(lang::rung::fp64x2))
      out += function(u, k, "bool", "_fp64x2", fmt::format("{}plain<meetc::double_double>({})", of, operands));
    if (never_wrong)
      out += function(u, k, "bool", "", fmt::format("{}hit({})", of, operands));
    if (u.asks(lang::rung::certified))
      out += function(u, k, "int", "_filter", fmt::format("static_cast<int>({}filter({}))", of, operands));
  }
  for (const lower::analytic_kernel &k : u.analytic)
    out += c_analytic_definitions(u, k);
  return out + "\n} // extern \"C\"\n";
}

} // namespace meetc::target
