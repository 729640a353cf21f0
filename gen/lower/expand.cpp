#include "gen/lower/expand.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <optional>

namespace meetc::lower {
namespace {
using lang::op;

// Limits far above any reasonable spec, which turn a runaway spec into an error.
constexpr long most_steps = 2'000'000;
constexpr int most_depth = 400; // protects the stack, even with sanitizers
constexpr std::size_t most_terms = 200'000;
constexpr int most_degree = 100;
constexpr std::size_t most_bits = 4096; // of a constant

bool compare_ints(op kind, int a, int b) {
  switch (kind) {
  case op::less:
    return a < b;
  case op::less_equal:
    return a <= b;
  case op::equal:
    return a == b;
  case op::not_equal:
    return a != b;
  case op::greater_equal:
    return a >= b;
  default:
    return a > b;
  }
}

sign_mask mask_for(op kind, int against) {
  sign_mask mask = 0;
  for (int s = -1; s <= 1; ++s)
    if (compare_ints(kind, s, against))
      mask |= 1 << (s + 1);
  return mask;
}

std::size_t length(const multivector &m) {
  std::size_t terms = 0;
  for (const auto &[at, c] : m.terms())
    terms += c.length();
  return terms;
}

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
  if (steps_ > most_steps)
    throw spec_error(where, fmt::format("this expands to more than {} steps", most_steps));
}

std::string expander::said(const lang::expr &e, const environment &env) {
  // Replaces from the last part to the first, so that the positions of earlier parts stay valid.
  std::string out = lang::print(e);
  const std::function<void(const lang::expr &)> replace = [&](const lang::expr &part) {
    const bool bound = part.kind == op::name &&
                       std::any_of(env.begin(), env.end(), [&](const auto &b) { return b.first == part.text; });
    if (bound || part.kind == op::member) {
      const long steps = steps_; // this work is not the spec's and does not count
      const std::string text = evaluate(part, env).text;
      steps_ = steps;
      if (!text.empty()) {
        out.replace(part.where.offset - e.where.offset, part.where.length, text);
        return;
      }
    }
    for (auto arg = part.args.rbegin(); arg != part.args.rend(); ++arg)
      replace(**arg);
  };
  replace(e);
  return out;
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
  throw spec_error(e.where, fmt::format("unknown name '{}'", e.text));
}

value expander::call(const lang::expr &e, const environment &env) {
  // Expressions of a spec were checked when they were read; those of a scene or the command line were not.
  const lang::function *defined = model_.spec().find_function(e.text);
  const lang::predicate *asked = model_.spec().find_predicate(e.text);
  const lang::kind *made = model_.spec().find_kind(e.text);
  const std::size_t want = defined ? defined->params.size() : asked ? asked->of.size() : made ? made->store.size() : 1;
  if (e.args.size() != want && (defined || asked || made || e.text == "sign" || e.text == "grade"))
    throw spec_error(
        e.where, fmt::format("'{}' takes {} argument{}, not {}", e.text, want, want == 1 ? "" : "s", e.args.size()));
  const long before = signs_.mark();
  const auto described = [&](value v) {
    if (const auto *s = std::get_if<sign_value>(&v.is))
      signs_.describe(*s, said(e, env), before);
    return v;
  };
  if (e.text == "sign")
    return described({sign_of(scalar_of(evaluate_multivector(*e.args[0], env), e.args[0]->where))});
  if (e.text == "grade") {
    const int g = evaluate_multivector(*e.args[0], env).homogeneous_grade();
    if (g < 0)
      throw spec_error(e.args[0]->where, "this has no single grade: it is zero or of mixed grade");
    return {number(g)};
  }
  std::vector<value> args;
  for (const auto &arg : e.args)
    args.push_back(evaluate(*arg, env));
  try {
    if (const lang::function *f = model_.spec().find_function(e.text)) {
      environment inner;
      for (std::size_t i = 0; i < args.size() && i < f->params.size(); ++i)
        inner.emplace_back(f->params[i], args[i]);
      if (f->domain) {
        const truth_node &domain = signs_.at(truth_of(*f->domain, inner));
        if (domain.kind != truth_node::type::constant)
          throw spec_error(f->domain->where, "the domain of a function must not depend on numbers");
        if (!domain.flag) {
          std::vector<std::string> grades;
          for (std::size_t i = 0; i < args.size(); ++i)
            grades.push_back(
                fmt::format("grade({}) = {}", f->params[i], blade_of(args[i], e.args[i]->where).homogeneous_grade()));
          throw spec_error(e.where, fmt::format("{} is not defined here: {} does not hold, {}", lang::print(e),
                                                lang::print(*f->domain), join(grades, ", ")));
        }
      }
      return described(evaluate(*f->body, inner));
    }
    if (const lang::predicate *p = model_.spec().find_predicate(e.text)) {
      const std::size_t first = taken_.size();
      const environment inner = bind(*p, args, e.where);
      const int id = truth_of(*p->hit, inner);
      calls_.push_back({id, p, said(e, env), {taken_.begin() + static_cast<std::ptrdiff_t>(first), taken_.end()}});
      return {truth{id}};
    }
    if (const lang::kind *k = model_.spec().find_kind(e.text)) {
      auto o = std::make_shared<object>(object{k, args, nullptr});
      for (std::size_t i = 0; i < args.size(); ++i) {
        const lang::field &f = k->store[i];
        const auto *part = std::get_if<std::shared_ptr<const object>>(&args[i].is);
        const bool fits =
            f.type == "real" ? std::holds_alternative<multivector>(args[i].is) : part && (*part)->kind->name == f.type;
        if (!fits)
          throw spec_error(e.args[i]->where,
                           fmt::format("'{}' of {} is a {}, not {}", f.name, k->name, f.type, describe(args[i])));
      }
      return {std::shared_ptr<const object>(std::move(o)), said(e, env)};
    }
  } catch (spec_error &error) {
    error.add_step(lang::print(e), e.where);
    throw;
  }
  throw spec_error(e.where, fmt::format("unknown function '{}'", e.text));
}

environment expander::bind(const lang::predicate &p, const std::vector<value> &args, const location &where) {
  environment env;
  for (std::size_t i = 0; i < p.of.size(); ++i) {
    const auto *o = std::get_if<std::shared_ptr<const object>>(&args[i].is);
    if (!o || (*o)->kind->name != p.of[i].type)
      throw spec_error(
          where, fmt::format("'{}' of {} is a {}, not {}", p.of[i].name, p.name, p.of[i].type, describe(args[i])));
    env.emplace_back(p.of[i].name, args[i]);
  }
  for (const lang::named_expr &l : p.lets)
    env.emplace_back(l.name, evaluate(*l.body, env));
  return env;
}

staged expander::evaluate_predicate(const lang::predicate &p, const std::vector<value> &args,
                                    std::vector<sign_value> *taken) {
  const auto first = static_cast<std::ptrdiff_t>(taken_.size());
  const environment env = bind(p, args, p.where);
  const auto lets = static_cast<std::ptrdiff_t>(taken_.size());
  staged out;
  for (const auto &r : p.reject)
    out.reject.push_back(truth_of(*r, env));
  const auto hit = static_cast<std::ptrdiff_t>(taken_.size());
  out.hit = truth_of(*p.hit, env);
  if (taken) {
    taken->assign(taken_.begin() + first, taken_.begin() + lets);
    taken->insert(taken->end(), taken_.begin() + hit, taken_.end());
  }
  return out;
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

// M[E]: the coefficient of M along the blade E, in the working or the declared basis, whichever has E as a basis blade.
value expander::index(const lang::expr &e, const environment &env) {
  const multivector m = evaluate_multivector(*e.args[0], env);
  const multivector along = evaluate_multivector(*e.args[1], env);
  const auto coefficient = [&](const multivector &from, const multivector &at) -> std::optional<value> {
    if (at.terms().size() != 1 || !at.terms().begin()->second.is_constant())
      return std::nullopt;
    const auto &[b, weight] = *at.terms().begin();
    const poly::poly *c = from.find(b);
    multivector out;
    if (c)
      out.add(0, c->scaled(1 / weight.constant()));
    return value{out};
  };
  if (auto v = coefficient(m, along))
    return *v;
  if (basis_ == &model_.working())
    if (auto v = coefficient(algebra::outermorphism(m, model_.to_declared()),
                             algebra::outermorphism(along, model_.to_declared())))
      return *v;
  throw spec_error(e.args[1]->where, "this is not a multiple of one basis blade");
}

value expander::compare(const lang::expr &e, const environment &env) {
  const value a = evaluate(*e.args[0], env), b = evaluate(*e.args[1], env);
  const auto *sa = std::get_if<sign_value>(&a.is);
  const auto *sb = std::get_if<sign_value>(&b.is);
  if (!sa && !sb) {
    const poly::poly difference = scalar_of(blade_of(a, e.args[0]->where), e.args[0]->where) -
                                  scalar_of(blade_of(b, e.args[1]->where), e.args[1]->where);
    const long before = signs_.mark();
    const sign_value s = sign_of(difference);
    signs_.describe(s, said(*e.args[0], env) + " - " + said(*e.args[1], env), before);
    return {truth{signs_.test(s, mask_for(e.kind, 0))}};
  }
  if (sa && sb) {
    std::vector<int> cases;
    for (int s = -1; s <= 1; ++s) {
      sign_mask other = 0;
      for (int t = -1; t <= 1; ++t)
        if (compare_ints(e.kind, s, t))
          other |= 1 << (t + 1);
      cases.push_back(signs_.both({signs_.test(*sa, 1 << (s + 1)), signs_.test(*sb, other)}));
    }
    return {truth{signs_.either(cases)}};
  }
  const std::size_t plain = sa ? 1 : 0;
  const poly::poly number = scalar_of(blade_of(sa ? b : a, e.args[plain]->where), e.args[plain]->where);
  if (!number.is_constant() || number.constant().get_den() != 1 || abs(number.constant()) > 1)
    throw spec_error(e.args[plain]->where, "a sign compares with -1, 0, 1 or another sign");
  const int constant = static_cast<int>(number.is_zero() ? 0 : number.constant().get_num().get_si());
  if (sa)
    return {truth{signs_.test(*sa, mask_for(e.kind, constant))}};
  sign_mask mask = 0;
  for (int s = -1; s <= 1; ++s)
    if (compare_ints(e.kind, constant, s))
      mask |= 1 << (s + 1);
  return {truth{signs_.test(*sb, mask)}};
}

value expander::quantify(const lang::expr &e, const environment &env) {
  std::vector<environment> environments{env};
  for (const lang::binder &b : e.binders) {
    std::vector<environment> next;
    for (const environment &outer : environments) {
      const value over = evaluate(*b.over, outer);
      const auto *items = std::get_if<std::shared_ptr<const list>>(&over.is);
      if (!items)
        throw spec_error(b.over->where, fmt::format("{} where a list is needed", describe(over)));
      for (const value &item : **items) {
        charge(1, b.over->where);
        next.push_back(outer);
        next.back().emplace_back(b.name, item);
      }
    }
    environments = std::move(next);
  }
  if (e.kind == op::each) {
    auto items = std::make_shared<list>();
    for (const environment &inner : environments)
      items->push_back(evaluate(*e.args[0], inner));
    return {std::shared_ptr<const list>(std::move(items))};
  }
  std::vector<int> truths;
  for (const environment &inner : environments)
    truths.push_back(truth_of(*e.args[0], inner));
  return {truth{e.kind == op::all ? signs_.both(truths) : signs_.either(truths)}};
}

value expander::arithmetic(const lang::expr &e, const environment &env) {
  const value a = evaluate(*e.args[0], env);
  const auto *sa = std::get_if<sign_value>(&a.is);
  if (e.kind == op::negate)
    return sa ? value{-*sa} : value{blade_of(a, e.args[0]->where).scaled(-1)};
  const value b = evaluate(*e.args[1], env);
  const auto *sb = std::get_if<sign_value>(&b.is);
  if (sa || sb) {
    if (!sa || !sb || e.kind != op::multiply)
      throw spec_error(e.where, fmt::format("{} and {}: signs only multiply with signs", describe(a), describe(b)));
    return {*sa * *sb};
  }
  const multivector x = blade_of(a, e.args[0]->where), y = blade_of(b, e.args[1]->where);
  if (e.kind == op::multiply || e.kind == op::outer || e.kind == op::inner)
    charge(4 * x.terms().size() * y.terms().size() + length(x) * length(y) / 64, e.where);
  multivector out;
  switch (e.kind) {
  case op::add:
    out = x + y;
    break;
  case op::subtract:
    out = x - y;
    break;
  case op::multiply:
    out = algebra::geometric(*basis_, x, y);
    break;
  case op::outer:
    out = algebra::outer(x, y);
    break;
  case op::inner:
    out = algebra::inner(*basis_, x, y);
    break;
  default: {
    const poly::poly divisor = scalar_of(y, e.args[1]->where);
    if (divisor.is_zero() || !divisor.is_constant())
      throw spec_error(e.args[1]->where, "only a number other than 0 divides");
    out = x.scaled(1 / divisor.constant());
  }
  }
  if (length(out) > most_terms)
    throw spec_error(e.where, fmt::format("this expands to more than {} terms", most_terms));
  for (const auto &[at, c] : out.terms()) {
    if (c.total_degree() > most_degree)
      throw spec_error(e.where, fmt::format("this is of a degree above {}", most_degree));
    if (c.is_constant()) {
      const rational q = c.constant();
      if (mpz_sizeinbase(q.get_num_mpz_t(), 2) + mpz_sizeinbase(q.get_den_mpz_t(), 2) > most_bits)
        throw spec_error(e.where, fmt::format("this number has more than {} bits", most_bits));
    }
  }
  return {out};
}

} // namespace meetc::lower
