// Signs and predicates in C: plain ones in float and double, and declarations of those in the library.
#include "gen/target/c/c.hpp"
#include "gen/target/cpp/names.hpp"
#include "gen/target/truth_text.hpp"

#include <fmt/format.h>
#include <map>

namespace meetc::target {
namespace {

// The plain rungs whose arithmetic C has.
struct plain_rung {
  lang::rung asked;
  const c_number &in;

  std::string suffix() const { return fmt::format("_{}", lang::info_of(asked).name); }
};
const plain_rung plain_rungs[] = {{lang::rung::fp32, c_numbers[1]}, {lang::rung::fp64, c_numbers[0]}};

truth_syntax in_c() {
  return {"true",
          "false",
          [](const std::string &x) { return '!' + x; },
          " && ",
          " || ",
          [](const std::string &c, const std::string &t, const std::string &e) {
            return fmt::format("{} ? {} : {}", c, t, e);
          },
          [](const std::string &name, const std::string &value) {
            return fmt::format("  const bool {} = {};\n", name, value);
          }};
}

class writer {
public:
  writer(const unit &u, const lower::kernel &k) : u_(u), k_(k), p_(k.decision), space_(identifier(u.scene.space)) {
    for (const lower::stage *s : lower::stages(p_))
      for (const int a : s->atoms)
        slot_.try_emplace(a, static_cast<int>(slot_.size()));
    for (std::size_t i = 0; i < 2; ++i)
      for (const lower::stored_real &r : u.kind(k.asked.kinds[i]->name).reals)
        inputs_.push_back(c_operand(k.asked.names[i]) + "->" + path_identifier(r.path));
  }

  std::string text() const {
    std::string out =
        fmt::format("/* {}{}\n   Plain: takes the sign of the computed value, whose error is not bounded. */\n",
                    k_.asked.text, k_.is_sign ? ", one sign: -1, 0 or 1." : ", closed sets.");
    if (!k_.is_sign)
      out += decision();
    for (const plain_rung &r : plain_rungs)
      if (u_.asks(r.asked))
        out += k_.is_sign ? plain_sign(r) : plain_predicate(r);
    const char *type = k_.is_sign ? "int" : "bool";
    if (u_.asks(lang::rung::fp64x2))
      out += fmt::format("/* The same in double-double; in the library. */\n{} {}({});\n", type, name("_fp64x2"),
                         parameters());
    if (u_.asks(lang::rung::certified) || u_.asks(lang::rung::exact))
      out += fmt::format("/* Never wrong for valid operands; in the library. */\n{} {}({});\n", type, name(""),
                         parameters());
    if (u_.asks(lang::rung::certified) && !k_.is_sign)
      out += fmt::format(
          "/* The first rung of the filter cascade alone: 0 no, 1 yes, both proved for valid operands; 2 unsure. */\n"
          "int {}({});\n",
          name("_filter"), parameters());
    return out + '\n';
  }

private:
  const unit &u_;
  const lower::kernel &k_;
  const lower::predicate &p_;
  std::string space_;
  std::map<int, int> slot_; // of an atom, in sign[]
  std::vector<std::string> inputs_;

  std::string name(const std::string &suffix) const { return space_ + '_' + identifier(k_.asked.name()) + suffix; }
  std::string parameters() const {
    std::string out;
    for (std::size_t i = 0; i < 2; ++i)
      out += fmt::format("{}const {} *{}", i ? ", " : "", c_name(u_, k_.asked.kinds[i]->name, c_numbers[1]),
                         c_operand(k_.asked.names[i]));
    return out;
  }
  std::string arguments() const { return c_operand(k_.asked.names[0]) + ", " + c_operand(k_.asked.names[1]); }
  std::string as_written() const { return fmt::format("  MEETC_{}_{}_AS_WRITTEN\n", space_.size(), space_); }

  // The statements that put the signs of a stage's atoms into sign[].
  std::string signs(const lower::stage &s, const c_number &n) const {
    const std::string code = c_body(
        s.code, n, n.fma,
        [&](int i) {
          const std::string &in = inputs_[static_cast<std::size_t>(i)];
          return n.suffix[0] == 'f' ? in : "(double)" + in;
        },
        [&](std::size_t i, const std::string &value) {
          return fmt::format("sign[{}] = {}_sign_of({});", slot_.at(s.atoms[i]), space_, value);
        });
    std::string unread;
    for (const std::string &operand : k_.asked.names)
      if (code.find(c_operand(operand) + "->") == std::string::npos)
        unread += fmt::format("  (void){};\n", c_operand(operand));
    return unread + code;
  }

  std::string plain_sign(const plain_rung &r) const {
    std::string out = fmt::format("static inline int {}({}) {{\n{}", name(r.suffix()), parameters(), as_written());
    if (!p_.common.atoms.empty())
      out += fmt::format("  int sign[{}];\n", p_.common.atoms.size());
    return out + signs(p_.common, r.in) + fmt::format("  return {};\n}}\n", sign_product(p_.value, slot_));
  }

  // The decision over signs, without the arithmetic that computes them.
  std::string decision() const {
    std::string out;
    const auto truth = [&](const char *suffix, const std::vector<int> &any) {
      truth_text t(p_.signs, slot_, in_c());
      const std::string value = t.any_of(any);
      const std::string before = t.take();
      out += fmt::format("static inline bool {}(const int *sign) {{\n{}{}  return {};\n}}\n", name(suffix),
                         before.find("sign[") == std::string::npos ? "  (void)sign;\n" : "", before, value);
    };
    if (!p_.reject.atoms.empty())
      truth("_rejected", p_.truths.reject);
    truth("_usual", {p_.usual});
    if (!p_.rare.atoms.empty()) {
      truth("_needs_rare", p_.conditions);
      truth("_whole", {p_.truths.hit});
    }
    return out;
  }

  std::string plain_predicate(const plain_rung &r) const {
    std::string out;
    const auto all = lower::stages(p_);
    const auto function = [&](lower::stage_kind s) { return name(fmt::format("_{}{}", name_of(s), r.suffix())); };
    for (const lower::stage_kind s : lower::stage_kinds)
      if (const lower::stage &code = *all[static_cast<std::size_t>(s)]; !code.atoms.empty())
        out += fmt::format("static inline void {}({}, int *sign) {{\n{}{}}}\n", function(s), parameters(), as_written(),
                           signs(code, r.in));
    const auto run = [&](lower::stage_kind s) { return fmt::format("  {}({}, sign);\n", function(s), arguments()); };
    out += fmt::format("static inline bool {}({}) {{\n  int sign[{}];\n", name(r.suffix()), parameters(),
                       std::max<std::size_t>(slot_.size(), 1));
    if (!p_.reject.atoms.empty())
      out += run(lower::stage_kind::reject) + fmt::format("  if ({}(sign))\n    return false;\n", name("_rejected"));
    if (!p_.common.atoms.empty())
      out += run(lower::stage_kind::common);
    if (!p_.rare.atoms.empty())
      out += fmt::format("  if ({}(sign)) {{\n  {}    return {}(sign);\n  }}\n", name("_needs_rare"),
                         run(lower::stage_kind::rare), name("_whole"));
    return out + fmt::format("  return {}(sign);\n}}\n", name("_usual"));
  }
};

} // namespace

std::string c_decision(const unit &u, const lower::kernel &k) {
  return writer(u, k).text();
}

} // namespace meetc::target
