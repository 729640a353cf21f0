#include "gen/target/statements.hpp"

#include <fmt/format.h>

namespace meetc::target {
namespace {
constexpr std::size_t longest_inline = 72;
}

statements::statements(const ir::program &p, syntax s) : syntax_(std::move(s)) {
  for (const ir::node_id id : ir::needed(p.nodes, p.results))
    for (const ir::node_id operand : ir::operands(p.nodes.at(id)))
      ++uses_[operand];
  // A result that is requested twice is computed once.
  for (const ir::node_id r : p.results)
    ++uses_[r];
}

statements::value statements::made(const ir::place &at, value v) {
  if (uses_[at.id] <= 1 && v.text.size() <= longest_inline)
    return v;
  const std::string name = fmt::format("t{}", next_++);
  out_ += fmt::format("{}const {} {} = {};\n", syntax_.indent, syntax_.type, name, v.text);
  return {name};
}

statements::value statements::add(const ir::place &at, const value &x, const value &y) {
  return made(at, {fmt::format("{} + {}", term(x), term(y)), binding::sum});
}

statements::value statements::subtract(const ir::place &at, const value &x, const value &y) {
  return made(at, {fmt::format("{} - {}", term(x), factor(y)), binding::sum});
}

statements::value statements::multiply(const ir::place &at, const value &x, const value &y) {
  return made(at, {fmt::format("{} * {}", factor(x), factor(y)), binding::product});
}

statements::value statements::fused(const ir::place &at, const value &x, const value &y, const value &z) {
  return made(at, {fmt::format("{}({}, {}, {})", syntax_.fma, x.text, y.text, z.text)});
}

statements::text statements::of(const ir::program &p, const syntax &s) {
  statements d(p, s);
  const auto values = ir::fold(p, d);
  text out{std::move(d.out_), {}};
  for (const ir::node_id r : p.results)
    out.results.push_back(values.at(r).text);
  return out;
}

} // namespace meetc::target
