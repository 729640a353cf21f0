#include "gen/lower/expand/expand.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <optional>

namespace meetc::lower {
namespace {
using lang::op;

// Far above any reasonable spec, which turns a runaway spec into an error.
constexpr int most_depth = 400; // protects the stack, even with sanitizers

rational parse_number(const std::string &text) {
  const auto dot = text.find('.');
  if (dot == std::string::npos)
    return rational(text, 10);
  const std::size_t decimals = text.size() - dot - 1;
  rational q(text.substr(0, dot) + text.substr(dot + 1) + "/1" + std::string(decimals, '0'), 10);
  q.canonicalize();
  return q;
}
} // namespace

expander::expander(const model &m, const poly::ring &numbers, decision &signs)
    : expander(m, numbers, signs, m.working(), m.to_working()) {}

expander::expander(const model &m, const poly::ring &numbers, decision &signs, const metric &basis,
                   std::vector<std::vector<rational>> declared_vectors)
    : model_(m), ring_(numbers), signs_(signs), basis_(&basis), declared_vectors_(std::move(declared_vectors)) {}

multivector expander::number(const rational &q) const {
  return {0, poly::poly(ring_, q)};
}

value expander::operand(const lang::kind &k, const std::string &prefix) const {
  auto o = std::make_shared<object>(object{&k, {}, nullptr});
  for (const lang::field &f : k.store)
    if (f.type == "real")
      o->fields.push_back({multivector(0, poly::poly::variable(ring_, ring_.find(prefix + f.name))), prefix + f.name});
    else
      o->fields.push_back(operand(*model_.spec().find_kind(f.type), prefix + f.name + '.'));
  return {std::shared_ptr<const object>(std::move(o)), prefix.substr(0, prefix.empty() ? 0 : prefix.size() - 1)};
}

value expander::operand(const lang::kind &k, const std::function<rational()> &next) const {
  auto o = std::make_shared<object>(object{&k, {}, nullptr});
  for (const lang::field &f : k.store)
    o->fields.push_back(f.type == "real" ? value{number(next())} : operand(*model_.spec().find_kind(f.type), next));
  return {std::shared_ptr<const object>(std::move(o))};
}

value expander::general(const std::vector<blade> &blades, const std::vector<std::string> &names) const {
  multivector m;
  for (std::size_t i = 0; i < blades.size(); ++i)
    m.add(blades[i], poly::poly::variable(ring_, ring_.find(names[i])));
  return {m};
}

std::string expander::describe(const value &v) {
  struct visitor {
    std::string operator()(const multivector &m) const { return m.is_scalar() ? "a number" : "a multivector"; }
    std::string operator()(const sign_value &) const { return "a sign"; }
    std::string operator()(const truth &) const { return "a truth"; }
    std::string operator()(const std::shared_ptr<const object> &o) const { return "a " + o->kind->name; }
    std::string operator()(const std::shared_ptr<const list> &) const { return "a list"; }
  };
  return std::visit(visitor{}, v.is);
}

environment expander::bind(const object &o) const {
  environment env;
  for (std::size_t i = 0; i < o.fields.size(); ++i)
    env.emplace_back(o.kind->store[i].name, o.fields[i]);
  return env;
}

multivector expander::blade_of(const value &v, const location &where) {
  if (const auto *m = std::get_if<multivector>(&v.is))
    return *m;
  if (const auto *o = std::get_if<std::shared_ptr<const object>>(&v.is)) {
    if (!(*o)->blade)
      (*o)->blade = std::make_unique<multivector>(evaluate_multivector(*(*o)->kind->blade, bind(**o)));
    return *(*o)->blade;
  }
  throw spec_error(where, fmt::format("{} where a number or a multivector is needed", describe(v)));
}

multivector expander::evaluate_multivector(const lang::expr &e, const environment &env) {
  return blade_of(evaluate(e, env), e.where);
}

poly::poly expander::scalar_of(const multivector &m, const location &where) const {
  if (m.is_zero())
    return poly::poly(ring_);
  if (!m.is_scalar())
    throw spec_error(where, "a multivector where a number is needed; take one coefficient, as in B[1]");
  return m.terms().begin()->second;
}

int expander::truth_of(const lang::expr &e, const environment &env) {
  const value v = evaluate(e, env);
  if (const auto *t = std::get_if<truth>(&v.is))
    return t->id;
  throw spec_error(e.where, fmt::format("{} where a truth is needed; compare it, as in 's > 0'", describe(v)));
}

sign_value expander::sign_of(const poly::poly &p) {
  taken_.push_back(signs_.sign_of(p));
  return taken_.back();
}

void expander::charge(std::size_t work, const location &where) {
  steps_ += static_cast<long>(work);
  if (steps_ > limit_)
    throw too_long(where, fmt::format("this expands to more than {} steps", limit_));
}

struct expander::level {
  expander &of;
  explicit level(expander &x) : of(x) { ++of.depth_; }
  ~level() { --of.depth_; }
  level(const level &) = delete;
  level &operator=(const level &) = delete;
};

value expander::evaluate(const lang::expr &e, const environment &env) {
  const level one(*this);
  if (depth_ > most_depth)
    throw spec_error(e.where, fmt::format("this expands to more than {} levels", most_depth));
  charge(1, e.where);
  switch (e.kind) {
  case op::number:
    return {number(parse_number(e.text))};
  case op::name:
    return name(e, env);
  case op::call:
    return call(e, env);
  case op::member:
    return member(e, env);
  case op::index:
    return index(e, env);
  case op::list: {
    auto items = std::make_shared<list>();
    for (const auto &arg : e.args) {
      items->push_back(evaluate(*arg, env));
      if (items->back().text.empty() && arg->kind == op::name)
        items->back().text = arg->text;
    }
    return {std::shared_ptr<const list>(std::move(items))};
  }
  case op::negate:
  case op::add:
  case op::subtract:
  case op::multiply:
  case op::divide:
  case op::outer:
  case op::inner:
    return arithmetic(e, env);
  case op::builtin:
    return builtin(*lang::find_builtin(e.text), e, env);
  case op::logical_not:
    return {truth{signs_.negate(truth_of(*e.args[0], env))}};
  case op::logical_and:
    return {truth{signs_.both({truth_of(*e.args[0], env), truth_of(*e.args[1], env)})}};
  case op::logical_or:
    return {truth{signs_.either({truth_of(*e.args[0], env), truth_of(*e.args[1], env)})}};
  case op::conditional: {
    const int c = truth_of(*e.args[0], env);
    const int t = truth_of(*e.args[1], env);
    return {truth{signs_.choose(c, t, truth_of(*e.args[2], env))}};
  }
  case op::all:
  case op::any:
  case op::each:
    return quantify(e, env);
  default:
    return compare(e, env);
  }
}

value expander::name(const lang::expr &e, const environment &env) {
  const auto local = std::find_if(env.rbegin(), env.rend(), [&](const auto &b) { return b.first == e.text; });
  if (local != env.rend())
    return local->second;
  const auto known =
      std::find_if(constants_.begin(), constants_.end(), [&](const auto &c) { return c.first == e.text; });
  if (known != constants_.end())
    return known->second;
  if (const lang::named_expr *c = model_.spec().find_constant(e.text)) {
    value v = evaluate(*c->body, {});
    constants_.emplace_back(e.text, v);
    return v;
  }
  const auto &vectors = model_.spec().vectors;
  const auto vector = std::find(vectors.begin(), vectors.end(), e.text);
  if (vector != vectors.end()) {
    multivector m;
    const auto &row = declared_vectors_[static_cast<std::size_t>(vector - vectors.begin())];
    for (std::size_t i = 0; i < row.size(); ++i)
      m.add(blade{1} << i, poly::poly(ring_, row[i]));
    return {m};
  }
  if (model_.spec().find_kind(e.text))
    throw spec_error(e.where, fmt::format("'{}' is a kind, not a value", e.text));
  if (const std::vector<std::string> named = lang::vectors_of_name(model_.spec(), e.text); !named.empty()) {
    multivector m = number(1);
    for (const std::string &v : named) {
      lang::expr one = e;
      one.text = v;
      m = algebra::outer(*basis_, m, evaluate_multivector(one, {}));
    }
    return {m};
  }
  if (e.text == "I")
    return {pseudoscalar(e.where)};
  throw spec_error(e.where, fmt::format("unknown name '{}'", e.text));
}

value expander::member(const lang::expr &e, const environment &env) {
  const value base = evaluate(*e.args[0], env);
  const auto *o = std::get_if<std::shared_ptr<const object>>(&base.is);
  if (!o)
    throw spec_error(e.where, fmt::format("{} has no members; a formula is taken on blades too, which have no stored "
                                          "parts; a sign or a predicate may read them",
                                          describe(base)));
  const lang::kind &k = *(*o)->kind;
  std::vector<std::string> known;
  for (std::size_t i = 0; i < k.store.size(); ++i) {
    if (k.store[i].name == e.text)
      return (*o)->fields[i];
    known.push_back(k.store[i].name);
  }
  for (const lang::named_expr &part : k.parts) {
    if (part.name == e.text)
      return evaluate(*part.body, bind(**o));
    known.push_back(part.name);
  }
  throw spec_error(
      e.where, fmt::format("{} has no '{}'; it has: {}{}", k.name, e.text, join(known, ", "), nearest(e.text, known)));
}

// Refuses a product of vectors with a square in it: e1*e1 is the number 1, and no blade.
void expander::check_index(const lang::expr &e, const environment &env) {
  for (const lang::expr_ptr &arg : e.args)
    check_index(*arg, env);
  if (e.kind != op::multiply)
    return;
  const int x = evaluate_multivector(*e.args[0], env).homogeneous_grade(),
            y = evaluate_multivector(*e.args[1], env).homogeneous_grade();
  if (x > 0 && y > 0 && evaluate_multivector(e, env).homogeneous_grade() != x + y)
    throw spec_error(e.where, fmt::format("'{}' is not the product of different basis vectors; write a blade with '^', "
                                          "and the scalar part as [1]",
                                          lang::print(e)));
}

// M[E]: the coefficient of M along the blade E, which is a multiple of a basis blade of the working basis or else of the
// declared one. The meaning does not depend on the basis of expansion.
value expander::index(const lang::expr &e, const environment &env) {
  const multivector m = evaluate_multivector(*e.args[0], env);
  const multivector along = evaluate_multivector(*e.args[1], env);
  check_index(*e.args[1], env);
  const auto coefficient = [](const multivector &from, const multivector &at) -> std::optional<value> {
    if (at.terms().size() != 1 || !at.terms().begin()->second.is_constant())
      return std::nullopt;
    const auto &[b, weight] = *at.terms().begin();
    const poly::poly *c = from.find(b);
    multivector out;
    if (c)
      out.add(0, c->scaled(1 / weight.constant()));
    return value{out};
  };
  if (auto v = coefficient(in_working(m), in_working(along)))
    return *v;
  if (auto v = coefficient(in_declared(m), in_declared(along)))
    return *v;
  throw spec_error(e.args[1]->where, "this is not a multiple of one basis blade");
}

} // namespace meetc::lower
