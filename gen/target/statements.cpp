#include "gen/target/statements.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {
constexpr std::size_t longest_inline = 72;

std::vector<ir::node_id> keys(const std::map<ir::node_id, std::string> &given) {
  std::vector<ir::node_id> out;
  for (const auto &[id, name] : given)
    out.push_back(id);
  return out;
}
} // namespace

statements::statements(const ir::program &p, const std::vector<ir::node_id> &results, syntax s,
                       std::map<ir::node_id, std::string> given)
    : syntax_(std::move(s)), names_(p.names), given_(std::move(given)) {
  // A result that is requested twice is computed once.
  for (const ir::node_id r : results)
    ++uses_[r];
  // Users come before their operands. A negation is written wherever it is used, together with its operand.
  const std::vector<ir::node_id> order = ir::needed(p.nodes, results, keys(given_));
  for (auto id = order.rbegin(); id != order.rend(); ++id)
    if (!given_.count(*id))
      for (const ir::node_id operand : ir::operands(p.nodes.at(*id)))
        uses_[operand] += p.nodes.at(*id).kind == ir::op::negate ? uses_[*id] : 1;
}

statements::value statements::made(const ir::node_ref &at, value v) {
  if (uses_[at.id] <= 1 && v.text.size() <= longest_inline)
    return v;
  const auto named = names_.find(at.id);
  const std::string name = named == names_.end() ? fmt::format("t{}", next_++)
                           : syntax_.local       ? syntax_.local(named->second)
                                                 : named->second;
  out_ += syntax_.indent;
  out_ += syntax_.keep ? syntax_.keep(name, v.text)
                       : fmt::format("const {} {} = {};", wide(at.id) ? syntax_.wide_type : syntax_.type, name, v.text);
  out_ += '\n';
  return {name};
}

// A negation costs nothing: it is written where it is used.
statements::value statements::negate(const ir::node_ref &, const value &x) const {
  return {'-' + factor(x), binding::sum};
}

statements::value statements::add(const ir::node_ref &at, const value &x, const value &y) {
  return made(at, {fmt::format("{} + {}", term(x), term(y)), binding::sum});
}

statements::value statements::subtract(const ir::node_ref &at, const value &x, const value &y) {
  return made(at, {fmt::format("{} - {}", term(x), factor(y)), binding::sum});
}

statements::value statements::multiply(const ir::node_ref &at, const value &x, const value &y) {
  const ir::node &n = at.operation();
  if (wide(at.id) && !wide(n.a) && !wide(n.b))
    return made(at, {fmt::format("{}({}, {})", syntax_.wide_product, x.text, y.text)});
  return made(at, {fmt::format("{} * {}", factor(x), factor(y)), binding::product});
}

statements::value statements::fused(const ir::node_ref &at, const value &x, const value &y, const value &z) {
  if (syntax_.fma.empty())
    return made(at, {fmt::format("{} * {} + {}", factor(x), factor(y), term(z)), binding::sum});
  return made(at, {fmt::format("{}({}, {}, {})", syntax_.fma, x.text, y.text, z.text)});
}

statements::text statements::of(const ir::program &p, const std::vector<ir::node_id> &results, const syntax &s,
                                const std::map<ir::node_id, std::string> &given) {
  statements d(p, results, s, given);
  const auto values = ir::fold(p.nodes, d, ir::needed(p.nodes, results, keys(given)));
  text out{std::move(d.out_), {}};
  for (const ir::node_id r : results)
    out.results.push_back(values.at(r).text);
  return out;
}

statements::text statements::of(const ir::program &p, const syntax &s) {
  return of(p, p.results, s);
}

} // namespace meetc::target
