// Expansion of the operators that every algebra has (gen/lang/operators.hpp).
#include "gen/algebra/operators.hpp"
#include "gen/lower/expand/expand.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::lower {
using lang::operation;

const lang::expr &body_of(const lang::builtin &of, algebra::parity versor, const lang::expr &call) {
  if (of.does != operation::of_versor || versor == algebra::parity::even)
    return *of.body;
  if (versor == algebra::parity::mixed)
    throw spec_error(call.where, fmt::format("{0} needs an even or an odd {1}, and this {1} has grades of both sorts; "
                                             "take its parts, as in grade({1}, 1)",
                                             lang::print(call), of.params[versor_argument(of)]));
  return *of.odd_body;
}

std::size_t versor_argument(const lang::builtin &of) {
  return of.name == "reflect" ? 1 : 0;
}

multivector expander::pseudoscalar(const location &where) {
  const blade all = model_.declared().pseudoscalar();
  if (const lang::named_expr *c = model_.spec().find_constant("I")) {
    multivector i = blade_of(name({lang::op::name, where, c->name, {}, {}}, {}), where);
    if (!(i.terms().size() == 1 && i.terms().begin()->first == all && i.terms().begin()->second.is_constant()))
      throw spec_error(where, fmt::format("this needs the pseudoscalar, and the constant I, declared at {}, is no "
                                          "multiple of {}",
                                          c->where.text(), model_.declared().name(all)));
    return i;
  }
  return in_expansion({all, poly::poly(ring_, model_.declared().sign(all))}); // in the order of `vectors`
}

multivector expander::in_declared(const multivector &m) const {
  return basis_ == &model_.working() ? model_.in_declared(m) : m;
}
multivector expander::in_working(const multivector &m) const {
  return basis_ == &model_.working() ? m : model_.in_working(m);
}
multivector expander::in_expansion(const multivector &declared) const {
  return basis_ == &model_.working() ? model_.in_working(declared) : declared;
}

// I and I^2.
std::pair<multivector, rational> expander::squared_pseudoscalar(const location &where) {
  const multivector i = pseudoscalar(where);
  const multivector square = algebra::geometric(*basis_, i, i);
  return {i, square.is_zero() ? rational(0) : square.terms().begin()->second.constant()};
}

multivector expander::complement(const multivector &m, bool right, const lang::expr &e) {
  const multivector i = in_declared(pseudoscalar(e.where));
  const algebra::blade_term at{i.terms().begin()->first, i.terms().begin()->second.constant()};
  if (abs(at.weight) != 1)
    throw spec_error(e.where,
                     fmt::format("a complement needs I to be {0} or -({0}), and the constant I of this algebra is "
                                 "{1} times that",
                                 model_.declared().name(at.at), at.weight.get_str()));
  const multivector declared = in_declared(m);
  const metric &basis = model_.declared();
  return in_expansion(right ? algebra::right_complement(basis, declared, at)
                            : algebra::left_complement(basis, declared, at));
}

// A number of the spec that says a grade.
int expander::grade_of(const lang::expr &e, const environment &env) {
  const multivector m = evaluate_multivector(e, env);
  const int most = basis_->vectors();
  const poly::poly *c = m.find(0);
  if (m.is_scalar() && (m.is_zero() || c->is_constant())) {
    const rational k = m.is_zero() ? rational(0) : c->constant();
    if (k.get_den() == 1 && k >= 0 && k <= most)
      return static_cast<int>(k.get_num().get_si());
  }
  throw spec_error(e.where, fmt::format("a grade is a whole number from 0 to {}", most));
}

// ~V / (V ~V), where V ~V is a number other than 0 whatever the operands are.
multivector expander::inverse(const multivector &v, const lang::expr &of) {
  const multivector reverse = algebra::reverse(v);
  charge(4 * v.terms().size() * v.terms().size(), of.where);
  const multivector square = algebra::geometric(*basis_, v, reverse);
  const poly::poly *n = square.find(0);
  if (square.is_scalar() && n && n->is_constant())
    return reverse.scaled(1 / n->constant());
  const std::string text = lang::print(of);
  if (square.is_zero())
    throw spec_error(of.where, fmt::format("'{0}' has no inverse: its product with its reverse is 0", text));
  if (v.is_scalar())
    throw spec_error(of.where,
                     fmt::format("nothing says that '{}' is not 0, and only a number other than 0 divides; leave the "
                                 "factor out here, and divide where the value is used",
                                 text));
  throw spec_error(of.where,
                   fmt::format("nothing says that V = '{}' has an inverse: V*~V depends on the operands, and may be 0; "
                               "multiply by ~V here, and divide by rnorm2(V) where the value is used",
                               text));
}

value expander::builtin(const lang::builtin &of, const lang::expr &e, const environment &env) {
  const auto arg = [&](std::size_t i) { return evaluate_multivector(*e.args[i], env); };
  switch (of.does) {
  case operation::expression:
  case operation::of_versor: {
    environment inner;
    for (std::size_t i = 0; i < e.args.size(); ++i)
      inner.emplace_back(of.params[i], value{arg(i)});
    const multivector &versor = std::get<multivector>(inner[versor_argument(of)].second.is);
    const lang::expr &body = body_of(of, algebra::parity_of(versor.terms()), e);
    try {
      return evaluate(body, inner);
    } catch (const too_long &error) { // at a place of the spec
      throw too_long(e.where, error.message());
    } catch (const spec_error &error) {
      throw spec_error(e.where, error.message());
    }
  }
  case operation::grade_part:
    return {algebra::grade_part(arg(0), grade_of(*e.args[1], env))};
  case operation::scalar_part:
    return {algebra::grade_part(arg(0), 0)};
  case operation::reverse:
    return {algebra::reverse(arg(0))};
  case operation::involute:
    return {algebra::involute(arg(0))};
  case operation::conjugate:
    return {algebra::conjugate(arg(0))};
  case operation::right_complement:
  case operation::left_complement:
    return checked(complement(arg(0), of.does == operation::right_complement, e), e.where);
  case operation::dual:
  case operation::undual: {
    const bool back = of.does == operation::undual;
    const auto [i, square] = squared_pseudoscalar(e.where);
    if (square == 0)
      return checked(complement(arg(0), !back, e), e.where);
    return checked(algebra::inner(*basis_, arg(0), back ? i : i.scaled(1 / square)), e.where);
  }
  case operation::dot: {
    const multivector x = arg(0), y = arg(1);
    charge_product(x, y, e.where);
    return checked(algebra::dot(*basis_, x, y), e.where);
  }
  case operation::inverse:
    break;
  }
  return checked(inverse(arg(0), *e.args[0]), e.where);
}

} // namespace meetc::lower
