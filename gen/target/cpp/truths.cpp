// The decision over signs as C++ functions.
#include "gen/target/cpp/names.hpp"
#include "gen/target/cpp/predicate.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::target {
namespace {
using lower::truth_node;

// The tests of a sign, by mask: bit 0 negative, bit 1 zero, bit 2 positive.
constexpr const char *test_names[] = {"",           "below_zero", "is_zero",       "at_most_zero",
                                      "above_zero", "not_zero",   "at_least_zero", ""};

// The stand-in for the rare parts of a decision: they themselves, nothing (no condition holds), or a truth that is not
// known.
enum class rare_parts { whole, usual, open };

// The truths that the roots need. They become statements b0, b1, ... where they are long or used more than once.
class truth_writer {
public:
  // Unless rare parts are written whole, only signs known before the rare stage are used, in called decisions too.
  truth_writer(const emitted_predicate &p, const std::vector<int> &roots, rare_parts rare)
      : p_(p), d_(p.kernel.decision.signs), rare_(rare) {
    for (const lower::sub_decision &c : p.kernel.decision.calls)
      if (p.of_scene(c) && can_be_called(c))
        calls_.emplace(rare == rare_parts::usual ? c.usual : c.whole, &c);
    for (const int r : roots)
      count(r);
  }

  std::string name(int id) {
    if (const auto it = names_.find(id); it != names_.end())
      return it->second;
    if (const auto call = calls_.find(id); call != calls_.end())
      return names_[id] = called(*call->second);
    const truth_node &n = d_.at(id);
    std::string text;
    switch (n.kind) {
    case truth_node::type::constant:
      return names_[id] = n.flag ? "true" : "false";
    case truth_node::type::test:
      text = fmt::format("meetc::{}({})", test_names[n.flag], sign(n.sign));
      break;
    case truth_node::type::both:
    case truth_node::type::either: {
      std::vector<std::string> args;
      for (const int a : n.args)
        args.push_back(name(a));
      text = fmt::format("meetc::{}({})", n.kind == truth_node::type::both ? "both" : "either", joined(args));
      break;
    }
    case truth_node::type::negate:
      text = fmt::format("meetc::negate({})", name(n.args[0]));
      break;
    case truth_node::type::choose: {
      const std::string c = name(n.args[0]), t = rare_ == rare_parts::open ? "meetc::unknown()" : name(n.args[1]),
                        e = name(n.args[2]);
      text = fmt::format("meetc::choose({}, {}, {})", c, t, e);
      break;
    }
    }
    return names_[id] = uses_[id] > 1 || text.size() > longest ? keep(text) : text;
  }
  std::string any(const std::vector<int> &roots) {
    std::vector<std::string> args;
    for (const int r : roots)
      args.push_back(name(r));
    return args.empty() ? "false" : args.size() == 1 ? args[0] : "meetc::either(" + joined(args) + ")";
  }
  std::string take() { return std::move(out_); }

private:
  static constexpr std::size_t longest = 64;
  const emitted_predicate &p_;
  const lower::decision &d_;
  rare_parts rare_;
  std::map<int, const lower::sub_decision *> calls_; // by the truth in whose place it stands
  std::map<int, int> uses_;
  std::map<int, std::string> names_;
  std::string out_;
  int next_ = 0, next_call_ = 0;

  // The number of its signs that the callee reads.
  std::size_t signs_read(const lower::sub_decision &c) const {
    return c.signs.size() - (rare_ == rare_parts::whole ? 0 : c.callee->rare.atoms.size());
  }
  bool can_be_called(const lower::sub_decision &c) const {
    const emitted_stage *rare = p_.stage(lower::stage_kind::rare);
    for (std::size_t i = 0; i < signs_read(c); ++i)
      for (const auto &[atom, e] : c.signs[i].atoms)
        if (const auto at = p_.slot.find(atom);
            at == p_.slot.end() || (rare_ != rare_parts::whole && rare && at->second >= rare->first))
          return false;
    return true;
  }
  std::string sign(const lower::sign_value &s) const {
    if (s.atoms.empty())
      return fmt::format("meetc::constant_sign<S>(meetc::sign::{})", s.unit < 0   ? "negative"
                                                                     : s.unit > 0 ? "positive"
                                                                                  : "zero");
    std::string product;
    for (const auto &[atom, e] : s.atoms)
      product += fmt::format(fmt::runtime(e == 2 ? "{}meetc::square(s[{}])" : "{}s[{}]"), product.empty() ? "" : " * ",
                             p_.slot.at(atom));
    return s.unit > 0 ? product : s.atoms.size() > 1 ? "-(" + product + ')' : '-' + product;
  }
  // A call with the callee's own signs, which are gathered from the caller's.
  std::string called(const lower::sub_decision &c) {
    std::vector<std::string> signs;
    for (std::size_t i = 0; i < signs_read(c); ++i)
      signs.push_back(sign(c.signs[i]));
    const std::string array = fmt::format("e{}", next_call_++);
    out_ += fmt::format("    // {}\n    const S {}[] = {{{}}};\n", c.text, array, joined(signs));
    const char *function = rare_ == rare_parts::whole                                   ? "whole"
                           : rare_ == rare_parts::open && !c.callee->rare.atoms.empty() ? "open"
                                                                                        : "usual";
    return keep(fmt::format("{}::{}({})", identifier(c.name), function, array));
  }

  void count(int id) {
    if (++uses_[id] > 1 || calls_.count(id) > 0)
      return;
    const truth_node &n = d_.at(id);
    for (std::size_t i = 0; i < n.args.size(); ++i)
      if (rare_ != rare_parts::open || n.kind != truth_node::type::choose || i != 1)
        count(n.args[i]);
  }
  static std::string joined(const std::vector<std::string> &args) {
    std::string out;
    for (const std::string &a : args)
      out += (out.empty() ? "" : ", ") + a;
    return out;
  }
  std::string keep(const std::string &text) {
    std::string b = fmt::format("b{}", next_++);
    out_ += fmt::format("    const auto {} = {};\n", b, text);
    return b;
  }
};

} // namespace

std::string truth_function(const emitted_predicate &p, const std::string &name, const std::vector<int> &any_of,
                           const std::string &scope) {
  truth_writer w(p, any_of,
                 name == "whole"  ? rare_parts::whole
                 : name == "open" ? rare_parts::open
                                  : rare_parts::usual);
  const std::string value = w.any(any_of), body = w.take();
  const bool reads = (body + value).find("s[") != std::string::npos;
  const std::string head = fmt::format("{}template <class S> MEETC_HD {} {}constexpr auto {}{}(const S *{}) {{",
                                       scope.empty() ? "  " : "", name == "whole" ? "MEETC_LARGE" : "MEETC_INLINED",
                                       scope.empty() ? "static " : "", scope, name, reads ? "s" : "");
  if (body.empty() && head.size() + value.size() < 95)
    return fmt::format("{} return {}; }}\n", head, value);
  return fmt::format("{}\n{}    return {};\n{}}}\n", head, body, value, scope.empty() ? "  " : "");
}

std::vector<std::string> called_by(const emitted_predicate &p) {
  std::vector<std::string> out;
  for (const lower::sub_decision &c : p.kernel.decision.calls)
    if (p.of_scene(c) && std::find(out.begin(), out.end(), c.name) == out.end())
      out.push_back(c.name);
  return out;
}

} // namespace meetc::target
