#include "gen/lower/analytic/analytic.hpp"
#include "gen/lang/analytic.hpp"
#include "gen/lang/operators.hpp"

#include <fmt/format.h>

namespace meetc::lower {

analytic_kernel compile_analytic(const model &m, const lang::expr &call) {
  if (call.args.size() != 1)
    lang::refuse_arguments(call, 1);
  const lang::expr &operand = *call.args[0];
  if (operand.kind != lang::op::name)
    throw spec_error(operand.where,
                     fmt::format("'{0}' takes a kind, as in '{0}({1})'; ask for '{2}' as another kernel, and "
                                 "pass its value on",
                                 call.text, m.spec().kinds.front().name, lang::print(operand)));
  analytic_kernel k;
  k.kind = &m.kind(operand.text, operand.where);
  k.text = lang::print(call);
  k.function = call.text;
  k.name = call.text + '_' + k.kind->name;
  k.where = call.where;
  if (call.text == "gives")
    k.read = compile_reading(m, *k.kind, call.where);
  else
    compile_motion(m, k);
  return k;
}

} // namespace meetc::lower
