#include "gen/target/c/c.hpp"

#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/statements.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

std::string open_c_header(const unit &u) {
  const std::string space = identifier(u.scene.space);
  return fmt::format(
      "#ifndef MEETC_{1}_{0}_C_H\n#define MEETC_{1}_{0}_C_H\n\n#include <math.h>\n#include <stdbool.h>\n\n"
      "#if !defined(__cplusplus) && (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L)\n"
      "#error \"{0}.h needs C99: compile with -std=c99 or later\"\n#endif\n\n"
      "/* Products and sums are rounded one by one, as in the generated library. */\n"
      "#if defined(__clang__)\n#define MEETC_{1}_{0}_AS_WRITTEN _Pragma(\"STDC FP_CONTRACT OFF\")\n"
      "#else\n#define MEETC_{1}_{0}_AS_WRITTEN\n#endif\n\n"
      "/* a b + c in formulas: rounded once where the target has the instruction, and elsewhere a product and a sum, "
      "since\n"
      "   fma() is a call there that takes as long as twenty products. */\n"
      "#if defined(__FMA__) || defined(__FMA4__) || defined(__aarch64__)\n"
      "#define {2}(a, b, c) fma((a), (b), (c))\n#define {3}(a, b, c) fmaf((a), (b), (c))\n"
      "#else\n"
      "#define {2}(a, b, c) ((a) * (b) + (c))\n#define {3}(a, b, c) ((a) * (b) + (c))\n#endif\n\n",
      space, space.size(), c_multiply_add(u, c_numbers[0]), c_multiply_add(u, c_numbers[1]));
}

std::string constant(const ir::rational &q, const c_number &n) {
  const auto integer = [&](const mpz_class &z) { return fmt::format("{}.0{}", z.get_str(), n.literal); };
  const std::string size = q.get_den() == 1 ? integer(abs(q.get_num()))
                                            : fmt::format("({} / {})", integer(abs(q.get_num())), integer(q.get_den()));
  return q < 0 ? fmt::format("(-{})", size) : size;
}

} // namespace

std::string c_name(const unit &u, const std::string &name, const c_number &n) {
  return fmt::format("{}_{}{}", identifier(u.scene.space), identifier(name), n.suffix);
}

std::string c_operand(const std::string &name) {
  const std::string id = identifier(name);
  const bool numbered =
      id.size() > 1 && (id[0] == 't' || id[0] == 'b') && id.find_first_not_of("0123456789", 1) == std::string::npos;
  return numbered || id == "sign" || id == "B" || id.starts_with("of_") ? id + "_operand" : id;
}

std::string c_multiply_add(const unit &u, const c_number &n) {
  const std::string space = identifier(u.scene.space);
  return fmt::format("MEETC_{}_{}_MULTIPLY_ADD{}", space.size(), space, n.literal[0] ? "F" : "");
}

std::string c_body(const ir::program &p, const c_number &n, const std::string &fma,
                   const std::function<std::string(int)> &input,
                   const std::function<std::string(std::size_t, const std::string &)> &result) {
  const statements::text code = statements::of(p, {.type = n.type,
                                                   .fma = fma,
                                                   .constant = [&](const ir::rational &q) { return constant(q, n); },
                                                   .input = input,
                                                   .indent = "  ",
                                                   .local = identifier});
  std::string out = code.before;
  for (std::size_t i = 0; i < code.results.size(); ++i)
    out += fmt::format("  {}\n", result(i, code.results[i]));
  return out;
}

std::string c_text(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  return broken_lines(k.is_predicate ? c_decision(u, k) : c_formula(u, k));
}

std::vector<file> c_files(const unit &u) {
  const std::string space = identifier(u.scene.space);
  std::string header = banner(u.scene, "Formulas, signs and predicates in C99.") + open_c_header(u);
  header += "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n" + c_kinds(u);
  for (const lower::kernel &k : u.kernels)
    header += k.is_predicate ? c_decision(u, k) : c_formula(u, k);
  for (const lower::analytic_kernel &k : u.analytic)
    header += c_analytic(u, k);
  header += "#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  std::vector<file> out{{space + '/' + space + ".h", broken_lines(header)}};
  const std::string library = c_library(u);
  out.push_back({space + '/' + space + "_c.cpp",
                 broken_lines(banner(u.scene, "Definitions of the functions that the C header declares.") + library)});
  return out;
}

} // namespace meetc::target
