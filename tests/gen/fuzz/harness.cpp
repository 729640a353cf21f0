#include "tests/gen/fuzz/harness.hpp"

#include "gen/target/cpp/names.hpp"

#include <fmt/format.h>

namespace meetc::fuzz {
namespace {

using target::identifier;

// The operands as the text of declarations and of a list of arguments.
struct operands {
  std::string declared, arguments;
};

// `type` makes the type of an operand from its kind's name.
template <class Type, class Count> operands read(const lower::request &r, const char *by, Type type, Count count) {
  operands out;
  std::size_t at = 0;
  for (std::size_t i = 0; i < r.kinds.size(); ++i) {
    const std::size_t n = count(*r.kinds[i]);
    out.declared +=
        fmt::format("  {0} {1};\n  memcpy(&{1}, in + {2}, sizeof {1});\n  (void)sizeof(char[sizeof {1} == {3} * sizeof "
                    "*in ? 1 : -1]);\n",
                    type(r.kinds[i]->name), r.names[i], at, n);
    out.arguments += fmt::format("{}{}{}", i ? ", " : "", by, r.names[i]);
    at += n;
  }
  return out;
}

std::string returns(const std::string &type, const std::string &value, std::size_t outputs) {
  return fmt::format(
      "  const {0} r = {1};\n  (void)sizeof(char[sizeof r == {2} * sizeof *out ? 1 : -1]);\n  memcpy(out, &r, sizeof "
      "r);\n",
      type, value, outputs);
}

} // namespace

std::vector<lower::blade> returned(const lower::model &m, const lower::formula &f) {
  return f.is_number() ? std::vector<lower::blade>{0} : f.result_kind ? lower::support(m, *f.result_kind) : f.result;
}

harness harness_for(const lower::model &m, const std::string &space, const std::vector<const compiled *> &all) {
  const std::string in = identifier(space);
  harness out;
  out.cpp = fmt::format("#include <{0}/{0}.hpp>\n#include <cstring>\nusing std::memcpy;\n", in);
  out.c = fmt::format("#include <{0}/{0}.h>\n#include <string.h>\n", in);
  const auto stored = [&](const lang::kind &k) { return m.layout(k).reals.size(); };
  const auto blades = [&](const lang::kind &k) { return lower::support(m, k).size(); };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const lower::request &r = all[i]->kernel.asked;
    const lower::formula &f = all[i]->kernel.value;
    const std::vector<lower::blade> outputs = returned(m, f);
    const auto cpp = [&](entry::from reads, const char *what, const operands &o, const std::string &value) {
      const std::string symbol = fmt::format("cpp_{}_{}", what, i);
      out.cpp += fmt::format("template <class T> static void {0}_of(const T *in, T *out) {{\n{1}{2}}}\n"
                             "extern \"C\" void {0}d(const double *in, double *out) {{ {0}_of(in, out); }}\n"
                             "extern \"C\" void {0}f(const float *in, float *out) {{ {0}_of(in, out); }}\n",
                             symbol, o.declared, returns("auto", value, outputs.size()));
      out.entries.push_back({all[i], reads, symbol, outputs});
    };
    const auto of_kind = [&](const char *suffix) {
      return
          [&in, suffix](const std::string &kind) { return fmt::format("{}::{}{}<T>", in, identifier(kind), suffix); };
    };
    const operands on_blades = read(r, "", of_kind("_blade"), blades), on_stored = read(r, "", of_kind(""), stored);
    const std::string function = fmt::format("{}::{}", in, target::kernel_function(r));
    cpp(entry::from::blades, "blades", on_blades, fmt::format("{}({})", function, on_blades.arguments));
    cpp(entry::from::stored, "stored", on_stored, fmt::format("{}({})", function, on_stored.arguments));
    if (!f.for_pairs.results.empty()) {
      const std::string s = fmt::format("{}::{}", in, identifier(r.name()));
      operands o = on_stored;
      o.declared += fmt::format("  T fa[{0}::fields_a + 1]{{}}, fb[{0}::fields_b + 1]{{}};\n  {0}::object_a({1}, fa);\n"
                                "  {0}::object_b({2}, fb);\n",
                                s, r.names[0], r.names[1]);
      cpp(entry::from::pairs, "pairs", o, fmt::format("{}::pair({}, fa, {}, fb)", s, r.names[0], r.names[1]));
    }
    for (const bool by_stored : {false, true}) {
      const std::string symbol = fmt::format("c_{}_{}", by_stored ? "stored" : "blades", i);
      for (const auto &[number, suffix] : {std::pair("double", ""), std::pair("float", "f")}) {
        const auto name = [&](const std::string &of) { return fmt::format("{}_{}{}", in, identifier(of), suffix); };
        const auto type = [&](const std::string &kind) { return name(by_stored ? kind : kind + "_blade"); };
        const operands o = by_stored ? read(r, "&", type, stored) : read(r, "&", type, blades);
        const std::string result = f.is_number()   ? number
                                   : f.result_kind ? name(f.result_kind->name + "_blade")
                                                   : name(r.name() + "_result");
        out.c += fmt::format(
            "void {0}{1}(const {2} *in, {2} *out);\nvoid {0}{1}(const {2} *in, {2} *out) {{\n{3}{4}}}\n", symbol,
            number[0], number, o.declared,
            returns(result, fmt::format("{}({})", name(by_stored ? r.name() : r.name() + "_blades"), o.arguments),
                    outputs.size()));
      }
      out.entries.push_back({all[i], by_stored ? entry::from::stored : entry::from::blades, symbol, outputs});
    }
  }
  return out;
}

} // namespace meetc::fuzz
