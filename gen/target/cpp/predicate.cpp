// A predicate or a sign as a struct: its stages, its decision and its entry points.
#include "gen/target/cpp/predicate.hpp"
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/bounds.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {

// An operand's name as a local variable, different from those that emitted functions use themselves.
std::string operand_name(const std::string &name) {
  std::string out = identifier(name);
  const bool numbered = out.size() > 1 && std::string("tlms").find(out[0]) != std::string::npos &&
                        out.find_first_not_of("0123456789", 1) == std::string::npos;
  for (const char *ours :
       {"row_a", "row_b", "f", "fa", "fb", "v", "m", "W", "leaf", "Leaf", "bits", "i", "all", "detail"})
    if (numbered || out == ours)
      return out + '_';
  return out;
}

std::string commented(const std::string &label, const std::string &text) {
  std::string out = "//   " + label;
  for (const char c : text) {
    out += c;
    if (c == '\n')
      out += "//   ";
  }
  return out + '\n';
}

constexpr const char *certified_comment =
    "Right for all valid operands (see valid()). The cheapest rung that can prove the answer gives it.";
constexpr const char *exact_comment = "Right for all valid operands (see valid()).";
constexpr const char *plain_comment =
    "Takes the sign of the value computed in T (float, double), whose error is not bounded.";

// The functions of two rows that the generated library contains.
std::string library_functions(const emitted_predicate &p, const char *type) {
  constexpr const char *rows = "(const float *row_a, const float *row_b);\n";
  std::string out;
  if (p.of.asks(lang::rung::certified))
    out += fmt::format("  static {} after_fp32{}", type, rows);
  else if (p.of.asks(lang::rung::exact))
    out += fmt::format("  static {} exactly{}", type, rows);
  if (p.has_rare() && p.of.asks(lang::rung::certified))
    out += fmt::format("  static meetc::answer whole_filter{}", rows);
  if (p.tolerant)
    out += fmt::format("  static {} tolerant_rest{}", type, rows);
  if (p.has_rare() && p.asks_plain())
    out += fmt::format("  template <class T> static bool whole_plain{}", rows);
  return out.empty() ? out
                     : "\n  // Only few pairs need these. They are compiled in the generated library, or where <" +
                           identifier(p.of.scene.space) + "/header_only.hpp> is included.\n" + out;
}

// The promise of the rung tolerant, in words.
std::string tolerance_text(const lower::tolerant_way &w) {
  const std::string way =
      w.by_distance
          ? "  // In plain fp32: the predicate compares a distance, and its error is a length.\n"
          : fmt::format("  // Numbers are rounded to multiples of 2^{}; then fp32 with its bound decides, or {} "
                        "bits.\n  // Those beyond the reach count as the nearest within it.\n",
                        w.low, w.width);
  const std::string step = w.beside_grid ? fmt::format("    // Sets may have been rounded to the scene's grid.\n"
                                                       "    static double step() {{ return {}; }}\n",
                                                       hex_literal(bound::power_of_two(w.low), ""))
                                         : "";
  const std::string base = w.by_distance ? "meetc::by_distance" : fmt::format("meetc::by_grid<{}, {}>", w.low, w.bits);
  return fmt::format(
      "\n{}  // reach: the largest coordinate; no length exceeds twice this.\n  struct tolerance : {} {{\n"
      "    static constexpr double moves = {}, reach = {};\n{}  }};\n",
      way, base, hex_literal(bound::rounded_up(w.moves, 24), ""), hex_literal(bound::rounded_up(w.reach, 53), ""),
      step);
}

std::string stages_text(const emitted_predicate &p) {
  std::string out;
  for (const lower::stage_kind which : {lower::stage_kind::reject, lower::stage_kind::common})
    if (const emitted_stage *s = p.stage(which))
      out += '\n' + stage_text(p, *s, "");
    else
      out += fmt::format("\n  using {}_stage = meetc::no_stage;\n", name_of(which));
  return out;
}

std::string detail_header(const emitted_predicate &p, const char *which) {
  return fmt::format("#include <{}/detail/{}_{}.hpp>\n", identifier(p.of.scene.space), p.kernel.asked.name(), which);
}

std::string bases(const emitted_predicate &p) {
  return p.bounds ? fmt::format(" : detail::{}_points", p.name) : "";
}

} // namespace

emitted_predicate::emitted_predicate(const unit &u, std::size_t number)
    : of(u), kernel(u.kernels[number]), bounds(u.bounds[number] ? &*u.bounds[number] : nullptr),
      tolerant(number < u.tolerance.ways.size() && u.tolerance.ways[number] ? &*u.tolerance.ways[number] : nullptr),
      name(identifier(kernel.asked.name()) + (kernel.is_sign ? "_sign" : "")),
      kind_a(identifier(kernel.asked.kinds[0]->name)), kind_b(identifier(kernel.asked.kinds[1]->name)),
      a(operand_name(kernel.asked.names[0])), b(operand_name(kernel.asked.names[1])) {
  const auto codes = lower::stages(kernel.decision);
  for (const lower::stage_kind which : lower::stage_kinds) {
    const auto at = static_cast<std::size_t>(which);
    if (codes[at]->atoms.empty())
      continue;
    stages.push_back({which, codes[at], bounds ? lower::stages(*bounds)[at] : nullptr, static_cast<int>(slot.size())});
    for (const int atom : codes[at]->atoms)
      slot.emplace(atom, static_cast<int>(slot.size()));
  }
}

const emitted_stage *emitted_predicate::stage(lower::stage_kind which) const {
  for (const emitted_stage &s : stages)
    if (s.kind == which)
      return &s;
  return nullptr;
}

bool emitted_predicate::of_scene(const lower::sub_decision &c) const {
  return std::any_of(of.kernels.begin(), of.kernels.end(),
                     [&](const lower::kernel &k) { return k.asked.asked && k.asked.asked->name == c.name; });
}

std::string emitted_predicate::input(int i) const {
  const std::string &path = kernel.decision.stored_inputs[static_cast<std::size_t>(i)]; // "A.c.y"
  return (i < kernel.decision.inputs_a ? a : b) + '.' + path_identifier(path.substr(path.find('.') + 1));
}

std::string emitted_predicate::operands_in(const std::string &text, const std::string &indent) const {
  std::string out;
  const auto read = [&](const std::string &operand, const std::string &kind, const char *row) {
    // This must not be the end of a longer name.
    for (std::size_t at = text.find(operand + '.'); at != std::string::npos; at = text.find(operand + '.', at + 1))
      if (at == 0 ||
          (std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0 && text[at - 1] != '_' && text[at - 1] != '.')) {
        out += fmt::format("{}const auto {} = detail::{}_in(row_{});\n", indent, operand, kind, row);
        return;
      }
  };
  read(a, kind_a, "a");
  read(b, kind_b, "b");
  return out;
}

std::string sign_text(const unit &u, std::size_t number) {
  const emitted_predicate p(u, number);
  const lower::predicate &d = p.kernel.decision;
  constexpr auto common = lower::stage_kind::common;
  std::string out =
      fmt::format("// {}: one sign.\nstruct {}{} {{\n  static constexpr int inputs_a = {}, inputs_b = {}, "
                  "atoms = {};\n",
                  p.kernel.asked.text, p.name, bases(p), d.inputs_a, d.inputs_b, d.common.atoms.size());
  out += p.stage(common) ? '\n' + stage_text(p, *p.stage(common), "") : "  using common_stage = meetc::no_stage;\n";
  std::string product = d.value.unit == 0       ? "meetc::constant_sign<S>(meetc::sign::zero)"
                        : d.value.atoms.empty() ? "meetc::constant_sign<S>(meetc::sign::positive)"
                                                : "";
  for (const auto &[atom, e] : d.value.atoms)
    product += fmt::format(fmt::runtime(e == 2 ? "{}meetc::square(s[{}])" : "{}s[{}]"), product.empty() ? "" : " * ",
                           p.slot.at(atom));
  if (d.value.unit < 0)
    product = d.value.atoms.size() > 1 ? "-(" + product + ")" : "-" + product;
  out +=
      fmt::format("\n  template <class S> MEETC_HD static constexpr S value([[maybe_unused]] const S *s) {{ return {}; "
                  "}}\n{}}};\n",
                  product, library_functions(p, "meetc::sign"));
  const auto function = [&](const char *comment, const char *head, const char *suffix, const std::string &body) {
    out +=
        fmt::format("\n// {}\n{}MEETC_HD inline meetc::sign {}{}(const {}<float> &{}, const {}<float> &{}) {{\n{}}}\n",
                    comment, head, kernel_function(p.kernel.asked), suffix, p.kind_a, p.a, p.kind_b, p.b, body);
  };
  if (u.asks(lang::rung::certified))
    function(certified_comment, "", "", fmt::format("  return meetc::sign_certified<{}>({}, {});\n", p.name, p.a, p.b));
  else if (u.asks(lang::rung::exact))
    function(exact_comment, "", "", fmt::format("  return meetc::sign_exact<{}>({}, {});\n", p.name, p.a, p.b));
  if (p.asks_plain())
    function(plain_comment, "template <class T> ", "_plain",
             fmt::format("  return meetc::sign_plain<{}, T>({}, {});\n", p.name, p.a, p.b));
  return out;
}

std::string predicate_text(const unit &u, std::size_t number) {
  const emitted_predicate p(u, number);
  const lower::predicate &d = p.kernel.decision;
  const lang::predicate &asked = *p.kernel.asked.asked;
  std::string out = fmt::format("// {}({}: {}, {}: {}), closed sets.\n", asked.name, asked.of[0].name, asked.of[0].type,
                                asked.of[1].name, asked.of[1].type);
  for (const lang::named_expr &l : asked.lets)
    out += commented(l.name + " = ", lang::print(*l.body));
  for (const lang::expr_ptr &r : asked.reject)
    out += commented("miss: ", lang::print(*r));
  out += commented("hit: ", lang::print(*asked.hit));
  if (asked.means != lang::meaning::touch)
    out += commented("means: ", lang::text_of(asked));
  out += fmt::format("struct {}{} {{\n  static constexpr int inputs_a = {}, inputs_b = {}, atoms = {};\n"
                     "  static constexpr bool symmetric = {};{}\n",
                     p.name, bases(p), d.inputs_a, d.inputs_b, d.signs.atoms().size(), d.symmetric,
                     d.symmetric ? " // proved: the exact answer is the same with the operands exchanged" : "");
  const auto method = [&](const char *comment, const char *head, const char *type, const char *function,
                          const std::string &body) {
    out += fmt::format("\n  // {}\n  {}MEETC_HD static {} {}(const {}<float> &{}, const {}<float> &{}) {{\n"
                       "    return meetc::{}({}, {});\n  }}\n",
                       comment, head, type, function, p.kind_a, p.a, p.kind_b, p.b, body, p.a, p.b);
  };
  if (u.asks(lang::rung::certified)) {
    method(certified_comment, "", "bool", "hit", fmt::format("hit_certified<{}>", p.name));
    method("The first rung alone, in fp32: no and yes are proved for valid operands.", "", "meetc::answer", "filter",
           fmt::format("filter_fp32<{}>", p.name));
  } else if (u.asks(lang::rung::exact)) {
    method(exact_comment, "", "bool", "hit", fmt::format("hit_exact<{}>", p.name));
  }
  if (p.tolerant) {
    out += tolerance_text(*p.tolerant);
    method("For operands within reach: wrong only where moving one of them by at most tolerance::moves changes the "
           "answer.",
           "", "bool", "tolerant", fmt::format("hit_tolerant<{}>", p.name));
  }
  if (p.asks_plain())
    method(plain_comment, "template <class T> ", "bool", "plain", fmt::format("hit_plain<{}, T>", p.name));
  out += library_functions(p, "bool") + stages_text(p);
  out += p.has_rare() ? fmt::format("\n  struct rare_stage; // detail/{}_later.hpp\n", p.kernel.asked.name())
                      : "\n  using rare_stage = meetc::no_stage;\n";
  out += "\n  // The decision over the signs s, for sign (bool) and sign_set (three-valued truth).\n";
  out += truth_function(p, "rejected", d.truths.reject, "");
  out += truth_function(p, "needs_rare", d.conditions, "");
  out += truth_function(p, "usual", {d.usual}, "");
  if (p.has_rare())
    out += "  // The decision as far as it is known without the signs of the rare stage.\n" +
           truth_function(p, "open", {d.truths.hit}, "");
  out += p.has_rare()
             ? fmt::format("  template <class S> MEETC_HD MEETC_LARGE static constexpr auto whole(const S *s); // "
                           "detail/{}_later.hpp\n",
                           p.kernel.asked.name())
             : "  template <class S> MEETC_HD MEETC_INLINED static constexpr auto whole(const S *s) { return usual(s); "
               "}\n";
  return out + "};\n";
}

std::string kernel_header(const unit &u, std::size_t number) {
  const emitted_predicate p(u, number);
  const std::string name = p.kernel.asked.name();
  std::vector<std::string> includes{"kinds.hpp"};
  if (p.bounds)
    includes.push_back(fmt::format("detail/{}_bounds.hpp", name));
  for (const std::string &callee : called_by(p))
    includes.push_back(callee + ".hpp");
  return open_header(u.scene, "kernel_" + name, includes,
                     p.tolerant ? std::vector<std::string>{"decide/tolerant.hpp"} : std::vector<std::string>{}) +
         (p.kernel.is_sign ? sign_text(u, number) : predicate_text(u, number)) +
         fmt::format("\n}} // namespace {}\n\n#if defined(__CUDACC__) // on a device, all code is "
                     "inline\n{}#endif\n\n#endif\n",
                     identifier(u.scene.space), detail_header(p, "later"));
}

} // namespace meetc::target
