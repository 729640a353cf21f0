// Signs and predicates: plain, by the signs of values in float32.
#include "gen/target/shader/shader.hpp"
#include "gen/target/truth_text.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

class writer {
public:
  writer(const shader_language &l, const unit &u, const lower::kernel &k) : l_(l), u_(u), k_(k), p_(k.decision) {
    for (const lower::stage *s : lower::stages(p_))
      for (const int a : s->atoms)
        slot_.try_emplace(a, static_cast<int>(slot_.size()));
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string operand = shader_operand(k.asked.names[i]);
      parameters_.push_back(l.declared(shader_name(u, k.asked.kinds[i]->name), operand));
      for (const lower::stored_real &r : u.kind(k.asked.kinds[i]->name).reals)
        inputs_.push_back(operand + '.' + shader_path(r.path));
    }
  }

  std::string text() const {
    const std::string head =
        l_.head(k_.is_sign ? l_.integer : "bool", shader_name(u_, k_.asked.name() + "_fp32"), join(parameters_, ", "));
    std::string out =
        fmt::format("// {}{}\n// Plain: takes the sign of the computed value, whose error is not bounded.\n{} {{\n",
                    k_.asked.text, k_.is_sign ? ", one sign: -1, 0 or 1." : ", closed sets.", head);
    if (!slot_.empty())
      out += fmt::format("  {};\n", l_.integers(slot_.size(), "sign"));
    out += k_.is_sign ? signs(p_.common) + fmt::format("  return {};\n", sign_product(p_.value, slot_)) : decision();
    return out + "}\n\n";
  }

private:
  const shader_language &l_;
  const unit &u_;
  const lower::kernel &k_;
  const lower::predicate &p_;
  std::map<int, int> slot_; // of an atom, in sign[]
  std::vector<std::string> parameters_, inputs_;

  // A block: its names end with it.
  static std::string block(const std::string &statements) {
    return statements.empty() ? "" : fmt::format("  {{\n{}  }}\n", statements);
  }

  // The statements that put the signs of a stage's atoms into sign[].
  std::string signs(const lower::stage &s) const {
    return block(shader_body(
        l_, s.code, [&](int i) { return inputs_[static_cast<std::size_t>(i)]; },
        [&](std::size_t i, const std::string &value) {
          // A value of its own, which GLSL can mark as precise; no operand has such a name.
          const std::string v = fmt::format("of_{}", i);
          return fmt::format("{} sign[{}] = {}({});", l_.keep(v, value), slot_.at(s.atoms[i]),
                             shader_name(u_, "sign_of"), v);
        }));
  }

  // A statement about the truth that one of these holds.
  std::string told(const std::vector<int> &any, const std::string &before, const std::string &after) const {
    truth_text t(p_.signs, slot_,
                 {"true", "false", [](const std::string &x) { return '!' + x; }, " && ", " || ", l_.choose, l_.truth});
    const std::string value = t.any_of(any);
    return t.take() + fmt::format("  {}{}{}", before, value, after);
  }

  std::string decision() const {
    std::string out;
    if (!p_.reject.atoms.empty())
      out += signs(p_.reject) + block(told(p_.truths.reject, "if (", ") {\n    return false;\n  }\n"));
    out += signs(p_.common);
    if (!p_.rare.atoms.empty())
      out += block(told(p_.conditions, "if (", ") {\n") + signs(p_.rare) + told({p_.truths.hit}, "return ", ";\n") +
                   "  }\n");
    return out + told({p_.usual}, "return ", ";\n");
  }
};

} // namespace

std::string shader_decision(const shader_language &l, const unit &u, const lower::kernel &k) {
  if (!u.asks(lang::rung::fp32))
    throw spec_error(k.asked.where, fmt::format("the backend '{}' computes in float32 alone, and the scene asks for "
                                                "'{}' without the rung 'fp32'",
                                                l.backend, k.asked.text));
  return writer(l, u, k).text();
}

} // namespace meetc::target
