// The decision over signs as C++ functions.
#include "gen/target/cpp/predicate.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {
using lower::truth_node;

// What a sign passes, by its mask: bit 0 negative, bit 1 zero, bit 2 positive.
constexpr const char *test_names[] = {"",           "below_zero", "is_zero",       "at_most_zero",
                                      "above_zero", "not_zero",   "at_least_zero", ""};

// The truths that the roots need, as statements b0, b1, ... where they are long or used more than once.
class truth_writer {
public:
  truth_writer(const emitted_predicate &p, const std::vector<int> &roots) : p_(p), d_(p.kernel.decision.signs) {
    for (const int r : roots)
      count(r);
  }

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
        product += fmt::format(fmt::runtime(e == 2 ? "{}meetc::square(s[{}])" : "{}s[{}]"),
                               product.empty() ? "" : " * ", p_.slot.at(atom));
      text = fmt::format("meetc::{}({})", test_names[n.flag], product);
      break;
    }
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
      const std::string c = name(n.args[0]), t = name(n.args[1]), e = name(n.args[2]);
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
  std::map<int, int> uses_;
  std::map<int, std::string> names_;
  std::string out_;
  int next_ = 0;

  void count(int id) {
    if (++uses_[id] == 1)
      for (const int a : d_.at(id).args)
        count(a);
  }
  static std::string joined(const std::vector<std::string> &args) {
    std::string out;
    for (const std::string &a : args)
      out += (out.empty() ? "" : ", ") + a;
    return out;
  }
  std::string keep(const std::string &text) {
    const std::string b = fmt::format("b{}", next_++);
    out_ += fmt::format("    const auto {} = {};\n", b, text);
    return b;
  }
};

} // namespace

std::string truth_function(const emitted_predicate &p, const char *name, const std::vector<int> &any_of,
                           const std::string &scope) {
  truth_writer w(p, any_of);
  const std::string value = w.any(any_of), body = w.take();
  const bool reads = (body + value).find("s[") != std::string::npos;
  const std::string head =
      fmt::format("{}template <class S> MEETC_HD {}constexpr auto {}{}(const S *{}) {{", scope.empty() ? "  " : "",
                  scope.empty() ? "static " : "", scope, name, reads ? "s" : "");
  if (body.empty() && head.size() + value.size() < 95)
    return fmt::format("{} return {}; }}\n", head, value);
  return fmt::format("{}\n{}    return {};\n{}}}\n", head, body, value, scope.empty() ? "  " : "");
}

} // namespace meetc::target
