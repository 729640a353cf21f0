// Requests: the operands of a kernel and the names of its parts.
#include "gen/lower/kernel/kernel.hpp"

#include <fmt/format.h>

namespace meetc::lower {
namespace {

const char *const operand_names[] = {"X", "Y", "Z", "W"};

// Replaces kind names by operand names and collects them. Writes the name of the function as in nested calls.
lang::expr_ptr rename(const lower::model &m, const lang::expr_ptr &e, request &r) {
  if (e->kind == lang::op::name) {
    const lang::kind *k = m.spec().find_kind(e->text);
    if (!k) {
      if (m.spec().find_constant(e->text))
        return e;
      throw spec_error(e->where, fmt::format("no kind '{}'; kinds: {}{}", e->text, join(m.spec().kind_names(), ", "),
                                             nearest(e->text, m.spec().kind_names())));
    }
    if (r.kinds.size() == std::size(operand_names))
      throw spec_error(e->where, "a kernel has at most four operands");
    lang::expr renamed = *e;
    renamed.text = operand_names[r.kinds.size()];
    r.names.push_back(renamed.text);
    r.kinds.push_back(k);
    return std::make_shared<lang::expr>(std::move(renamed));
  }
  if (e->kind == lang::op::call && e->text != "sign" && e->text != "grade" && !m.spec().find_function(e->text) &&
      !lang::called_builtin(m.spec(), *e)) {
    std::vector<std::string> known;
    for (const lang::function &f : m.spec().functions)
      known.push_back(f.name);
    for (const lang::builtin &f : lang::builtins())
      known.push_back(f.name);
    throw spec_error(e->where, fmt::format("no function '{}'; functions: {}{}", e->text, join(known, ", "),
                                           nearest(e->text, known)));
  }
  if (e->kind == lang::op::call || e->kind == lang::op::builtin)
    r.function += (r.function.empty() ? "" : "_") + e->text;
  lang::expr out = *e;
  for (lang::expr_ptr &arg : out.args)
    arg = rename(m, arg, r);
  return std::make_shared<lang::expr>(std::move(out));
}

} // namespace

std::string request::name() const {
  std::string out = function;
  if (!asked)
    for (const lang::kind *k : kinds)
      out += '_' + k->name;
  return out;
}

request resolve(const lower::model &m, const lang::expr_ptr &what) {
  request r;
  r.text = lang::print(*what);
  r.where = what->where;
  if (what->kind == lang::op::name) {
    r.asked = m.spec().find_predicate(what->text);
    if (!r.asked) {
      std::vector<std::string> known;
      for (const lang::predicate &p : m.spec().predicates)
        known.push_back(p.name);
      throw spec_error(what->where, fmt::format("no predicate '{}'; predicates: {}; a function is applied to kinds, "
                                                "as in 'meet(sphere, line)'{}",
                                                what->text, join(known, ", "), nearest(what->text, known)));
    }
    r.function = r.asked->name;
    for (const lang::field &f : r.asked->of) {
      r.names.push_back(f.name);
      r.kinds.push_back(&m.kind(f.type, f.where));
    }
    return r;
  }
  if (what->kind != lang::op::call && what->kind != lang::op::builtin)
    throw spec_error(what->where, "a kernel is a predicate's name or a function applied to kinds");
  r.body = rename(m, what, r);
  return r;
}

request resolve(const lower::model &m, const lang::expr_ptr &what,
                const std::vector<std::pair<std::string, std::string>> &with) {
  request r;
  r.text = lang::print(*what);
  r.where = what->where;
  r.function = "expression";
  r.body = what;
  for (const auto &[name, kind] : with) {
    r.names.push_back(name);
    r.kinds.push_back(&m.kind(kind, {}));
  }
  return r;
}

} // namespace meetc::lower
