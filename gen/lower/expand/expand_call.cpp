// Expansion of calls: functions, predicates, and kinds as constructors.
#include "gen/lang/analytic.hpp"
#include "gen/lower/expand/expand.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace meetc::lower {
namespace {
using lang::op;

} // namespace

std::string on_one_line(const std::string &text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\n' && c != '\r' && c != '\t')
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  return out;
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
  return on_one_line(out);
}

value expander::call(const lang::expr &e, const environment &env) {
  // Expressions of a spec were checked when they were read; those of a scene or the command line were not.
  const lang::function *defined = model_.spec().find_function(e.text);
  const lang::predicate *asked = model_.spec().find_predicate(e.text);
  const lang::kind *made = model_.spec().find_kind(e.text);
  const std::size_t want = defined ? defined->params.size() : asked ? asked->of.size() : made ? made->store.size() : 1;
  const lang::builtin *of_language = lang::called_builtin(model_.spec(), e);
  if (of_language && of_language->params.size() == e.args.size())
    return builtin(*of_language, e, env);
  if (of_language)
    lang::refuse_arguments(e, of_language->params.size());
  if (e.args.size() != want && (defined || asked || made || e.text == "sign" || e.text == "grade" || e.text == "zero"))
    lang::refuse_arguments(e, want);
  const long before = signs_.mark();
  const auto described = [&](value v) {
    if (const auto *s = std::get_if<sign_value>(&v.is))
      signs_.describe(*s, said(e, env), before);
    return v;
  };
  if (e.text == "sign")
    return described({sign_of(scalar_of(evaluate_multivector(*e.args[0], env), e.args[0]->where))});
  if (lang::called_analytic(model_.spec(), e)) {
    if (!roots_ || e.text != "sqrt")
      lang::refuse_analytic(e);
    if (e.args.size() != 1)
      lang::refuse_arguments(e, 1);
    const poly::poly x = scalar_of(evaluate_multivector(*e.args[0], env), e.args[0]->where);
    return {multivector(0, x.is_zero() ? x : roots_->root(x, e.where))};
  }
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
      check_domain(*f, args, e);
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
  if (e.text == "zero") { // which no declaration hides here
    std::vector<int> truths;
    const multivector m = blade_of(args.front(), e.args[0]->where);
    for (const auto &[at, coefficient] : m.terms()) {
      const sign_value s = sign_of(coefficient);
      signs_.describe(s, "a coefficient of " + said(*e.args[0], env), before);
      truths.push_back(signs_.test(s, 2));
    }
    return {truth{signs_.both(truths)}};
  }
  throw spec_error(e.where, fmt::format("unknown function '{}'", e.text));
}

// Whether some argument is 0, and the domain holds for some grades of those that are.
bool expander::holds_for_grades_of_zero(const lang::function &f, const std::vector<value> &args,
                                        const lang::expr &call) {
  std::vector<std::size_t> zeros;
  environment inner;
  for (std::size_t i = 0; i < args.size(); ++i) {
    inner.emplace_back(f.params[i], args[i]);
    if (blade_of(args[i], call.args[i]->where).is_zero())
      zeros.push_back(i);
  }
  const std::size_t grades = static_cast<std::size_t>(basis().vectors()) + 1;
  std::size_t choices = zeros.empty() ? 0 : 1;
  for (std::size_t i = 0; i < zeros.size(); ++i)
    choices *= grades;
  const poly::poly one = *number(1).find(0);
  for (std::size_t choice = 0; choice < choices; ++choice) {
    std::size_t rest = choice;
    for (const std::size_t i : zeros) {
      inner[i].second = value{multivector((blade{1} << rest % grades) - 1, one)};
      rest /= grades;
    }
    const truth_node &domain = signs_.at(truth_of(*f.domain, inner));
    if (domain.kind == truth_node::type::constant && domain.flag)
      return true;
  }
  return false;
}

void expander::check_domain(const lang::function &f, const std::vector<value> &args, const lang::expr &call) {
  if (!f.domain)
    return;
  if (zero_allowed_ && holds_for_grades_of_zero(f, args, call))
    return;
  environment inner;
  for (std::size_t i = 0; i < args.size(); ++i)
    inner.emplace_back(f.params[i], args[i]);
  const truth_node &domain = signs_.at(truth_of(*f.domain, inner));
  if (domain.kind != truth_node::type::constant)
    throw spec_error(f.domain->where, "the domain of a function must not depend on numbers");
  if (domain.flag)
    return;
  std::vector<std::string> grades;
  for (std::size_t i = 0; i < args.size(); ++i)
    grades.push_back(
        fmt::format("grade({}) = {}", f.params[i], blade_of(args[i], call.args[i]->where).homogeneous_grade()));
  throw spec_error(call.where, fmt::format("{} is not defined here: {} does not hold, {}", lang::print(call),
                                           lang::print(*f.domain), join(grades, ", ")));
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

} // namespace meetc::lower
