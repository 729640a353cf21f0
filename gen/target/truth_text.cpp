#include "gen/target/truth_text.hpp"

#include <fmt/format.h>

namespace meetc::target {
using lower::truth_node;

std::string sign_product(const lower::sign_value &v, const std::map<int, int> &slot) {
  std::string out;
  for (const auto &[atom, exponent] : v.atoms)
    for (int i = 0; i < exponent; ++i)
      out += fmt::format("{}sign[{}]", out.empty() ? "" : " * ", slot.at(atom));
  if (out.empty() || v.unit == 0)
    return fmt::format("{}", v.unit);
  return v.unit < 0 ? fmt::format("-({})", out) : out;
}

truth_text::truth_text(const lower::decision &d, const std::map<int, int> &slot, truth_syntax s)
    : d_(d), slot_(slot), syntax_(std::move(s)) {}

std::string truth_text::name(int id) {
  if (const auto it = names_.find(id); it != names_.end())
    return it->second;
  return names_[id] = made(d_.at(id));
}

std::string truth_text::any_of(const std::vector<int> &ids) {
  std::string out;
  for (const int id : ids)
    out += (out.empty() ? "" : syntax_.either) + name(id);
  return out.empty() ? syntax_.no : out;
}

std::string truth_text::keep(const std::string &text) {
  std::string b = fmt::format("b{}", next_++);
  before_ += syntax_.statement(b, text);
  return b;
}

std::string truth_text::made(const truth_node &n) {
  static const char *const tests[] = {nullptr, "< 0", "== 0", "<= 0", "> 0", "!= 0", ">= 0", nullptr};
  switch (n.kind) {
  case truth_node::type::constant:
    return n.flag ? syntax_.yes : syntax_.no;
  case truth_node::type::test:
    return n.flag == 0   ? syntax_.no
           : n.flag == 7 ? syntax_.yes
                         : keep(fmt::format("{} {}", sign_product(n.sign, slot_), tests[n.flag]));
  case truth_node::type::negate:
    return keep(syntax_.negate(name(n.args[0])));
  case truth_node::type::choose: {
    const std::string c = name(n.args[0]), t = name(n.args[1]), e = name(n.args[2]);
    return keep(syntax_.choose(c, t, e));
  }
  case truth_node::type::both:
  case truth_node::type::either:
    break;
  }
  std::string all;
  for (const int id : n.args)
    all += (all.empty() ? "" : n.kind == truth_node::type::both ? syntax_.both : syntax_.either) + name(id);
  return keep(all);
}

} // namespace meetc::target
