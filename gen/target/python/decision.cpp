// Signs and predicates in Python: plain, for all elements at once.
#include "gen/target/cpp/names.hpp"
#include "gen/target/python/python.hpp"
#include "gen/target/truth_text.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {

truth_syntax in_python() {
  return {"np.True_",
          "np.False_",
          [](const std::string &x) { return fmt::format("np.logical_not({})", x); },
          " & ",
          " | ",
          [](const std::string &c, const std::string &t, const std::string &e) {
            return fmt::format("np.where({}, {}, {})", c, t, e);
          },
          [](const std::string &name, const std::string &value) { return fmt::format("    {} = {}\n", name, value); }};
}

class writer {
public:
  writer(const unit &u, const lower::kernel &k) : u_(u), k_(k), p_(k.decision) {
    for (const lower::stage *s : lower::stages(p_))
      for (const int a : s->atoms)
        slot_.try_emplace(a, static_cast<int>(slot_.size()));
    for (std::size_t i = 0; i < 2; ++i) {
      operands_.push_back(python_operand(u, k.asked.names[i]));
      for (const lower::stored_real &r : u.kind(k.asked.kinds[i]->name).reals)
        inputs_.push_back(operands_[i] + '.' + python_path(r.path));
    }
  }

  std::string text() const { return k_.is_sign ? sign() : predicate(); }

private:
  const unit &u_;
  const lower::kernel &k_;
  const lower::predicate &p_;
  std::map<int, int> slot_; // of an atom, in sign[]
  std::vector<std::string> operands_, inputs_;

  std::string name() const { return python_name(k_.asked.name()); }
  std::string head(const std::string &name, const char *type, const std::string &says, const char *more = "") const {
    std::string list;
    for (std::size_t i = 0; i < 2; ++i)
      list += fmt::format("{}{}: {}", i ? ", " : "", operands_[i], python_name(k_.asked.kinds[i]->name));
    const std::string docstring = says.empty() ? "" : fmt::format("    \"\"\"{}\"\"\"\n", says);
    return fmt::format("\n\ndef {}({}{}) -> {}:\n{}", name, list, more, type, docstring);
  }

  // The statements that append the signs of a stage to `sign`.
  std::string signs(const lower::stage &s) const {
    const statements::text code = python_body(s.code, [&](int i) { return inputs_[static_cast<std::size_t>(i)]; });
    std::string out = code.before;
    for (const std::string &value : code.results)
      out += fmt::format("    sign.append(np.sign({}))\n", value);
    return out;
  }

  std::string sign() const {
    return head(name(), "NDArray[np.int8]",
                fmt::format("{}: -1, 0 or 1, as the computed value has it. Its error is not bounded.", k_.asked.text)) +
           "    sign: list[Any] = []\n" + signs(p_.common) +
           fmt::format("    return np.asarray({}, np.int8)\n", sign_product(p_.value, slot_));
  }

  std::string predicate() const {
    std::string out;
    const auto all = lower::stages(p_);
    const auto function = [&](lower::stage_kind s) { return fmt::format("_{}_{}", name(), name_of(s)); };
    for (const lower::stage_kind s : lower::stage_kinds)
      if (const lower::stage &code = *all[static_cast<std::size_t>(s)]; !code.atoms.empty())
        out += head(function(s), "None", "", ", sign: list[Any]") + signs(code);
    const auto truth = [&](const char *suffix, const std::vector<int> &any) {
      truth_text t(p_.signs, slot_, in_python());
      const std::string value = t.any_of(any);
      out += fmt::format("\n\ndef _{}{}(sign: list[Any]) -> Any:\n{}    return {}\n", name(), suffix, t.take(), value);
    };
    if (!p_.reject.atoms.empty())
      truth("_rejected", p_.truths.reject);
    truth("_usual", {p_.usual});
    if (!p_.rare.atoms.empty()) {
      truth("_needs_rare", p_.conditions);
      truth("_whole", {p_.truths.hit});
    }
    out += head(
        name(), "NDArray[np.bool_]",
        fmt::format("{}, closed sets, by the signs of computed values. Their errors are not bounded.", k_.asked.text));
    out += "    sign: list[Any] = []\n";
    const std::string arguments = operands_[0] + ", " + operands_[1] + ", sign";
    for (const lower::stage_kind s : {lower::stage_kind::reject, lower::stage_kind::common})
      if (!all[static_cast<std::size_t>(s)]->atoms.empty())
        out += fmt::format("    {}({})\n", function(s), arguments);
    out += fmt::format("    hit = _{}_usual(sign)\n", name());
    if (!p_.rare.atoms.empty())
      out += fmt::format("    rare = _{0}_needs_rare(sign)\n    if np.any(rare):\n        {1}({2})\n"
                         "        hit = np.where(rare, _{0}_whole(sign), hit)\n",
                         name(), function(lower::stage_kind::rare), arguments);
    if (!p_.reject.atoms.empty())
      out += fmt::format("    hit = hit & np.logical_not(_{}_rejected(sign))\n", name());
    return out + "    return np.asarray(hit, np.bool_)\n";
  }
};

} // namespace

std::string python_decision(const unit &u, const lower::kernel &k) {
  return writer(u, k).text();
}

} // namespace meetc::target
