// The command that evaluates an expression on numbers, exactly.
#include "gen/driver.hpp"
#include "gen/lower/kernel/compile.hpp"
#include "gen/operands.hpp"
#include "gen/support/output.hpp"

#include <fmt/format.h>

namespace meetc {
namespace {

using lower::rational;

// "-7/3 = -2.3333333333333335", or the whole number.
std::string text_of(const rational &q) {
  if (q.get_den() == 1)
    return q.get_str();
  const double d = q.get_d();
  return fmt::format("{} = {}", q.get_str(), d == 0 ? fmt::format("{}0", sgn(q) < 0 ? "-" : "") : fmt::format("{}", d));
}

std::string text_of(const lower::multivector &v, const lower::metric &basis) {
  if (v.is_zero())
    return "0\n";
  std::set<lower::blade> all;
  for (const auto &[at, c] : v.terms())
    all.insert(at);
  std::string out;
  for (const lower::blade at : lower::sorted_blades(basis, all))
    out += v.is_scalar() ? text_of(v.find(at)->constant()) + '\n'
                         : fmt::format("{:<16} {}\n", basis.name(at), text_of(v.find(at)->constant()));
  return out;
}

} // namespace

int eval(const eval_options &o) {
  const compilation c = load(o.scene, o.algebra_path);
  const lang::expr_ptr e = lang::parse_expression(o.expression, "-e");
  const poly::ring none({});
  lower::decision signs;
  lower::expander of(*c.model, none, signs);
  of.allow_bits(1 << 20); // exact numbers may be long
  of.allow_zero();
  lower::environment env;
  for (const given_operand &g : given_operands(*c.model, o.with)) {
    auto next = g.numbers.begin();
    env.emplace_back(g.name, of.operand(*g.kind, [&next] { return *next++; }));
  }
  const lower::value v = of.evaluate(*e, env);
  if (const auto *sign = std::get_if<lower::sign_value>(&v.is))
    say(fmt::format("{}\n", sign->unit));
  else if (const auto *t = std::get_if<lower::truth>(&v.is))
    say(signs.at(t->id).flag ? "true\n" : "false\n");
  else
    say(text_of(of.blade_of(v, e->where), of.basis()));
  return 0;
}

} // namespace meetc
