// A predicate as a struct: its stages and its decision.
#include "gen/target/cpp/body.hpp"
#include "gen/target/cpp/bounds.hpp"
#include "gen/target/cpp/bytecode.hpp"
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <fmt/format.h>
#include <functional>
#include <map>

namespace meetc::target {
namespace {
using lower::truth_node;

std::string stage_text(const lower::predicate &p, const lower::stage &st, const bound::stage_bounds *b,
                       const char *name, const char *what, std::map<int, int> &slot) {
  if (st.atoms.empty())
    return fmt::format("  using {} = ::meetc::no_stage;\n", name);
  const int first = static_cast<int>(slot.size());
  for (const int a : st.atoms) {
    const int next = static_cast<int>(slot.size());
    slot.try_emplace(a, next);
  }
  const parts text = split_body(st.code, p.inputs_a, b && b->mixed, "      ");
  std::string out =
      fmt::format("  // {}: signs {} to {}, degree {}.\n", what, first, slot.size() - 1, (b ? b->degree : 0));
  const auto counted = [&](poly::residency r) { return count_text(ir::count(st.code, r)); };
  out += fmt::format("  // Of object A alone: {}; of B alone: {}; of the pair: {}. All of it runs for every pair.\n",
                     counted(poly::residency::a), counted(poly::residency::b), counted(poly::residency::pair));
  out +=
      fmt::format("  struct {} {{\n    static constexpr int first = {}, atoms = {}, fields_a = {}, fields_b = {};\n"
                  "    // With inputs that are integers below 2^bits every value is below 2^(degree bits + growth).\n"
                  "    static constexpr int degree = {}, growth = {};\n",
                  name, first, st.atoms.size(), text.fields_a, text.fields_b, (b ? b->degree : 0), (b ? b->growth : 0));
  out +=
      fmt::format("    template <class T>\n    MEETC_HD MEETC_INLINE static void object_a([[maybe_unused]] const T *a, "
                  "[[maybe_unused]] T *f) {{\n{}    }}\n",
                  text.object_a);
  out +=
      fmt::format("    template <class T>\n    MEETC_HD MEETC_INLINE static void object_b([[maybe_unused]] const T *b, "
                  "[[maybe_unused]] T *f) {{\n{}    }}\n",
                  text.object_b);
  out += fmt::format(
      "    // The values, whose signs are wanted; W holds those of degree 3 and more.\n"
      "    template <class T, class W = T>\n    MEETC_HD MEETC_INLINE static void pair([[maybe_unused]] const T *a, "
      "[[maybe_unused]] const T *fa,\n        [[maybe_unused]] const T *b, "
      "[[maybe_unused]] const T *fb, W *v) {{\n{}    }}\n",
      text.pair);
  if (b)
    out += stage_bounds_text(*b, st, p.inputs_a) + steps_text(st.code, p.inputs_a + p.inputs_b);
  return out + "  };\n";
}

// The truths that `roots` need, as statements b0, b1, ...; gives the names of the roots.
class truth_writer {
public:
  truth_writer(const lower::decision &d, const std::map<int, int> &slot) : d_(d), slot_(slot) {}

  std::string name(int id) {
    if (const auto it = names_.find(id); it != names_.end())
      return it->second;
    const truth_node &n = d_.at(id);
    std::string text;
    switch (n.kind) {
    case truth_node::type::constant:
      return names_[id] = n.flag ? "true" : "false";
    case truth_node::type::test: {
      std::string product;
      for (const auto &[atom, e] : n.sign.atoms)
        product += fmt::format(fmt::runtime(e == 2 ? "{}::meetc::square(s[{}])" : "{}s[{}]"),
                               product.empty() ? "" : " * ", slot_.at(atom));
      text = fmt::format("::meetc::in<{}>({})", n.flag, product);
      break;
    }
    case truth_node::type::both:
    case truth_node::type::either: {
      const char *f = n.kind == truth_node::type::both ? "both" : "either";
      text = name(n.args[0]);
      for (std::size_t i = 1; i < n.args.size(); ++i) {
        if (text.size() > 90)
          text = keep(text);
        const std::string next = name(n.args[i]);
        text = fmt::format("::meetc::{}({}, {})", f, text, next);
      }
      break;
    }
    case truth_node::type::negate:
      text = fmt::format("::meetc::negate({})", name(n.args[0]));
      break;
    case truth_node::type::choose: {
      const std::string c = name(n.args[0]), t = name(n.args[1]), e = name(n.args[2]);
      text = fmt::format("::meetc::either(::meetc::both({0}, {1}), ::meetc::both(::meetc::negate({0}), {2}))", c, t, e);
      break;
    }
    }
    return names_[id] = keep(text);
  }
  std::string take() { return std::move(out_); }

private:
  const lower::decision &d_;
  const std::map<int, int> &slot_;
  std::map<int, std::string> names_;
  std::string out_;
  int next_ = 0;

  std::string keep(const std::string &text) {
    const std::string b = fmt::format("b{}", next_++);
    out_ += fmt::format("    const auto {} = {};\n", b, text);
    return b;
  }
};

std::string truth_function(const lower::predicate &p, const std::map<int, int> &slot, const char *name,
                           const std::vector<int> &any_of) {
  truth_writer w(p.signs, slot);
  std::string value;
  for (const int id : any_of) {
    const std::string next = w.name(id);
    value = value.empty() ? next : fmt::format("::meetc::either({}, {})", value, next);
  }
  if (value.empty())
    value = "false";
  return fmt::format(
      "  template <class S> MEETC_HD static constexpr auto {}([[maybe_unused]] const S *s) {{\n{}    return {};\n"
      "  }}\n",
      name, w.take(), value);
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
    "Right for any valid operands, see valid(); the cheapest rung that proves its answer gives it.";
constexpr const char *exact_comment = "Right for any valid operands, see valid().";
constexpr const char *plain_comment =
    "By the sign of the value computed in T (float, double); says nothing about how wrong it can be.";
} // namespace

std::string sign_text(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  const bound::kernel_bounds *bounds = u.bounds[kernel] ? &*u.bounds[kernel] : nullptr;
  const lower::predicate &p = k.decision;
  const std::string name = identifier(k.asked.name()), a = identifier(k.asked.kinds[0]->name),
                    b = identifier(k.asked.kinds[1]->name);
  std::map<int, int> slot;
  std::string out =
      fmt::format("// {}: one sign.\nstruct {}_sign {{\n  static constexpr int inputs_a = {}, inputs_b = {}, "
                  "atoms = {};\n",
                  k.asked.text, name, p.inputs_a, p.inputs_b, p.common.atoms.size());
  if (bounds)
    out += kernel_bounds_text(*bounds, p.inputs_a);
  out += stage_text(p, p.common, bounds ? &bounds->common : nullptr, "common_stage", "The sign", slot);
  std::string product = p.value.unit == 0       ? "::meetc::constant_sign<S>(::meetc::sign::zero)"
                        : p.value.atoms.empty() ? "::meetc::constant_sign<S>(::meetc::sign::positive)"
                                                : "";
  for (const auto &[atom, e] : p.value.atoms)
    product += fmt::format(fmt::runtime(e == 2 ? "{}::meetc::square(s[{}])" : "{}s[{}]"), product.empty() ? "" : " * ",
                           slot.at(atom));
  if (p.value.unit < 0)
    product = "-(" + product + ")";
  out +=
      fmt::format("  template <class S> MEETC_HD static constexpr S value([[maybe_unused]] const S *s) {{ return {}; "
                  "}}\n}};\n",
                  product);
  const auto function = [&](const char *comment, const char *head, const char *suffix, const std::string &body) {
    out += fmt::format(
        "// {}\n{}MEETC_HD inline ::meetc::sign {}{}(const {}<float> &operand_a, const {}<float> &operand_b) {{\n"
        "{}}}\n",
        comment, head, kernel_function(k.asked), suffix, a, b, body);
  };
  if (u.asks("certified"))
    function(certified_comment, "", "",
             fmt::format("  return ::meetc::sign_certified<{}_sign>(operand_a, operand_b);\n", name));
  else if (u.asks("exact"))
    function(exact_comment, "", "",
             fmt::format("  return ::meetc::sign_exact<{}_sign>(operand_a, operand_b);\n", name));
  if (u.asks("fp32") || u.asks("fp64") || u.asks("fp64x2"))
    function(
        plain_comment, "template <class T> ", "_plain",
        fmt::format("  const ::meetc::rows_of<{0}_sign, {1}<float>, {2}<float>> rows(operand_a, operand_b);\n"
                    "  return ::meetc::decide_sign<{0}_sign>(::meetc::plain_signs<{0}_sign, T>(rows.a, rows.b));\n",
                    name, a, b));
  return out;
}

std::string predicate_text(const unit &u, std::size_t kernel) {
  const lower::kernel &k = u.kernels[kernel];
  const bound::kernel_bounds *bounds = u.bounds[kernel] ? &*u.bounds[kernel] : nullptr;
  const lower::predicate &p = k.decision;
  const lang::predicate &asked = *k.asked.asked;
  const std::string name = identifier(asked.name), a = identifier(asked.of[0].type), b = identifier(asked.of[1].type);
  std::string out = fmt::format("// {}({}: {}, {}: {}), closed sets.\n", asked.name, asked.of[0].name, asked.of[0].type,
                                asked.of[1].name, asked.of[1].type);
  for (const lang::named_expr &l : asked.lets)
    out += commented(l.name + " = ", lang::print(*l.body));
  for (const lang::expr_ptr &r : asked.reject)
    out += commented("miss if ", lang::print(*r));
  out += commented("hit if ", lang::print(*asked.hit));
  out += fmt::format("struct {} {{\n  static constexpr int inputs_a = {}, inputs_b = {}, atoms = {};\n\n", name,
                     p.inputs_a, p.inputs_b, p.signs.atoms().size());
  std::map<int, int> slot;
  if (bounds)
    out += kernel_bounds_text(*bounds, p.inputs_a) + '\n';
  out += stage_text(p, p.reject, bounds ? &bounds->reject : nullptr, "reject_stage", "Decides most misses", slot);
  out += stage_text(p, p.common, bounds ? &bounds->common : nullptr, "common_stage", "The usual case", slot);
  out += stage_text(p, p.rare, bounds ? &bounds->rare : nullptr, "rare_stage", "The rare case", slot);
  out += "\n  // The decision over the signs s, for sign (bool) and sign_set (three-valued truth).\n";
  out += truth_function(p, slot, "rejected", p.truths.reject);
  out += truth_function(p, slot, "needs_rare", p.conditions);
  out += truth_function(p, slot, "usual", {p.usual});
  out += truth_function(p, slot, "whole", {p.truths.hit});
  const auto method = [&](const char *comment, const char *head, const char *type, const char *function,
                          const std::string &body) {
    out +=
        fmt::format("\n  // {}\n  {}MEETC_HD static {} {}(const {}<float> &operand_a, const {}<float> &operand_b) {{\n"
                    "{}  }}\n",
                    comment, head, type, function, a, b, body);
  };
  if (u.asks("certified")) {
    method(certified_comment, "", "bool", "hit",
           fmt::format("    return ::meetc::hit_certified<{}>(operand_a, operand_b);\n", name));
    method("The first rung alone, in fp32: no and yes are proved for valid operands.", "", "::meetc::answer", "filter",
           fmt::format("    return ::meetc::filter_fp32<{}>(operand_a, operand_b);\n", name));
  } else if (u.asks("exact")) {
    method(exact_comment, "", "bool", "hit",
           fmt::format("    return ::meetc::hit_exact<{}>(operand_a, operand_b);\n", name));
  }
  if (u.asks("fp32") || u.asks("fp64") || u.asks("fp64x2"))
    method(plain_comment, "template <class T> ", "bool", "plain",
           fmt::format("    const ::meetc::rows_of<{0}, {1}<float>, {2}<float>> rows(operand_a, operand_b);\n"
                       "    return ::meetc::decide<{0}>(::meetc::plain_signs<{0}, T>(rows.a, rows.b));\n",
                       name, a, b));
  return out + "};\n";
}

} // namespace meetc::target
