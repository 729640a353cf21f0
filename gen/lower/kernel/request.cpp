// Requests: the operands of a kernel and the names of its parts.
#include "gen/lang/analytic.hpp"
#include "gen/lang/hints.hpp"
#include "gen/lower/kernel/kernel.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::lower {
namespace {
using lang::op;

constexpr std::size_t most_operands = 16;

// X, Y, Z, W, X5, X6, ..., without those that the algebra declares, since an operand hides them.
std::string operand_name(const lang::algebra &a, std::size_t i) {
  static const char *const usual[] = {"X", "Y", "Z", "W"};
  std::string out = i < std::size(usual) ? usual[i] : fmt::format("X{}", i + 1);
  while (a.find_constant(out) || std::find(a.vectors.begin(), a.vectors.end(), out) != a.vectors.end())
    out += 'o';
  return out;
}

// A word of the name of a kernel that is no call.
const char *word(op kind) {
  switch (kind) {
  case op::negate:
    return "negative";
  case op::add:
    return "sum";
  case op::subtract:
    return "difference";
  case op::multiply:
    return "product";
  case op::divide:
    return "quotient";
  case op::outer:
    return "wedge";
  case op::inner:
    return "inner";
  case op::index:
    return "part";
  default:
    return nullptr;
  }
}

[[noreturn]] void refuse_form(const location &where) {
  throw spec_error(where,
                   "a kernel is a predicate's name, or an expression of kinds with one value or one sign, as in "
                   "'norm2(meet(sphere, line))'; all else is said by a predicate of the algebra: [predicates.NAME]");
}

// Makes a request of an expression: kinds become operands.
class namer {
public:
  namer(const model &m, request &r) : spec_(m.spec()), request_(r) {}

  lang::expr_ptr rename(const lang::expr_ptr &e) {
    lang::expr out = *e;
    switch (e->kind) {
    case op::name:
      return name(e);
    case op::number: {
      std::string text = e->text;
      std::replace(text.begin(), text.end(), '.', '_');
      say(text);
      return e;
    }
    case op::call:
      if (e->text != "sign" && e->text != "grade" && !spec_.find_function(e->text) && !lang::called_builtin(spec_, *e))
        unknown(*e);
      say(e->text);
      break;
    case op::builtin:
      say(e->text);
      break;
    case op::member:
      throw spec_error(e->where, "a kernel takes kinds as wholes, which also stand for blades without stored parts; a "
                                 "function of the algebra that takes a sign may read parts");
    default:
      if (!word(e->kind))
        refuse_form(e->where);
      say(word(e->kind));
    }
    for (lang::expr_ptr &arg : out.args)
      arg = rename(arg);
    return std::make_shared<lang::expr>(std::move(out));
  }

private:
  const lang::algebra &spec_;
  request &request_;

  void say(const std::string &part) { request_.function += (request_.function.empty() ? "" : "_") + part; }

  lang::expr_ptr name(const lang::expr_ptr &e) {
    if (const lang::kind *k = spec_.find_kind(e->text)) {
      if (request_.kinds.size() == most_operands)
        throw spec_error(e->where, fmt::format("a kernel has at most {} operands", most_operands));
      lang::expr renamed = *e;
      renamed.text = operand_name(spec_, request_.kinds.size());
      request_.names.push_back(renamed.text);
      request_.kinds.push_back(k);
      return std::make_shared<lang::expr>(std::move(renamed));
    }
    if (spec_.find_constant(e->text))
      return e;
    const bool vector = std::find(spec_.vectors.begin(), spec_.vectors.end(), e->text) != spec_.vectors.end();
    if (vector || e->text == "I" || !lang::vectors_of_name(spec_, e->text).empty()) {
      say(e->text);
      return e;
    }
    if (e->text == "*")
      throw spec_error(e->where, "'*' stands for all kinds in the kernels of a scene alone");
    const std::string hint = lang::hint_for_name(spec_, e->text);
    throw spec_error(e->where, fmt::format("no kind '{}'; kinds: {}{}", e->text, join(spec_.kind_names(), ", "),
                                           hint.empty() ? nearest(e->text, spec_.kind_names()) : hint));
  }

  [[noreturn]] void unknown(const lang::expr &e) const {
    if (lang::called_analytic(spec_, e))
      lang::refuse_analytic(e);
    std::vector<std::string> known;
    for (const lang::function &f : spec_.functions)
      known.push_back(f.name);
    const std::string declared = join(known, ", ");
    for (const lang::builtin &f : lang::builtins())
      known.push_back(f.name);
    if (spec_.find_predicate(e.text))
      throw spec_error(e.where, fmt::format("'{0}' is a predicate, whose kinds are its own; write '{0}'", e.text));
    const std::string hint = lang::hint_for_function(e.text);
    throw spec_error(e.where, fmt::format("no function '{}'; functions: {}{}", e.text, declared,
                                          hint.empty() ? nearest(e.text, known) : hint));
  }
};

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
    if (!r.asked && m.spec().find_kind(what->text))
      throw spec_error(what->where, fmt::format("'{0}' is a kind; a kernel is a predicate's name, or an expression of "
                                                "kinds, as in 'rev({0})'",
                                                what->text));
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
  if (what->kind == lang::op::number)
    refuse_form(what->where);
  r.body = namer(m, r).rename(what);
  if (r.kinds.empty())
    throw spec_error(what->where, fmt::format("'{}' names no kind, and so is one number or multivector for ever; "
                                              "meetc eval prints it",
                                              r.text));
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
