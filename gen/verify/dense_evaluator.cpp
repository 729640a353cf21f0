#include "gen/verify/dense_evaluator.hpp"

#include <algorithm>

namespace meetc::verify {
namespace {
using lang::op;
using oracle::multivector;
using oracle::rational;

rational number(const std::string &text) {
  const auto dot = text.find('.');
  rational q(text.substr(0, dot), 10);
  if (dot != std::string::npos) {
    rational scale = 1;
    for (std::size_t i = dot + 1; i < text.size(); ++i) {
      scale /= 10;
      q += scale * (text[i] - '0');
    }
  }
  return q;
}
} // namespace

dense_evaluator::dense_evaluator(const lang::algebra &a, const oracle::matrix &metric,
                                 const oracle::matrix &declared_vectors)
    : spec_(a), dense_(metric), declared_vectors_(declared_vectors) {}

dense_value dense_evaluator::operand(const lang::kind &k, const std::vector<rational> &numbers,
                                     std::size_t &next) const {
  dense_value out;
  for (const lang::field &f : k.store)
    out.members[f.name] = f.type == "real" ? dense_value{dense_.scalar(numbers.at(next++)), {}}
                                           : operand(*spec_.find_kind(f.type), numbers, next);
  out.blade = evaluate(*k.blade, out.members);
  return out;
}

multivector dense_evaluator::evaluate(const lang::expr &e, const dense_scope &scope) const {
  return value(e, scope).blade;
}

dense_value dense_evaluator::value(const lang::expr &e, const dense_scope &scope) const {
  const auto arg = [&](std::size_t i) { return evaluate(*e.args[i], scope); };
  switch (e.kind) {
  case op::number:
    return {dense_.scalar(number(e.text)), {}};
  case op::name: {
    if (const auto it = scope.find(e.text); it != scope.end())
      return it->second;
    if (const lang::named_expr *c = spec_.find_constant(e.text))
      return value(*c->body, {});
    const auto v = std::find(spec_.vectors.begin(), spec_.vectors.end(), e.text);
    if (v == spec_.vectors.end())
      break;
    multivector m = dense_.zero();
    const auto &row = declared_vectors_[static_cast<std::size_t>(v - spec_.vectors.begin())];
    for (std::size_t i = 0; i < row.size(); ++i)
      m[std::size_t{1} << i] = row[i];
    return {m, {}};
  }
  case op::call: {
    if (e.text == "sign")
      return {dense_.scalar(sgn(oracle::scalar_part(arg(0)))), {}};
    const lang::function *f = spec_.find_function(e.text);
    if (!f)
      break;
    dense_scope inner;
    for (std::size_t i = 0; i < f->params.size(); ++i)
      inner[f->params[i]] = value(*e.args[i], scope);
    return value(*f->body, inner);
  }
  case op::member: {
    const dense_value base = value(*e.args[0], scope);
    if (const auto it = base.members.find(e.text); it != base.members.end())
      return it->second;
    break;
  }
  case op::index: {
    // The coefficient along a blade, which must be one basis blade here.
    const multivector m = arg(0), along = arg(1);
    const auto nonzero = [](const rational &q) { return q != 0; };
    if (std::count_if(along.begin(), along.end(), nonzero) != 1)
      break;
    const auto at = static_cast<std::size_t>(std::find_if(along.begin(), along.end(), nonzero) - along.begin());
    return {dense_.scalar(m[at] / along[at]), {}};
  }
  case op::negate:
    return {oracle::scale(-1, arg(0)), {}};
  case op::add:
    return {oracle::add(arg(0), arg(1)), {}};
  case op::subtract:
    return {oracle::subtract(arg(0), arg(1)), {}};
  case op::multiply:
    return {dense_.geometric(arg(0), arg(1)), {}};
  case op::divide:
    return {oracle::scale(1 / oracle::scalar_part(arg(1)), arg(0)), {}};
  case op::outer:
    return {oracle::outer(arg(0), arg(1)), {}};
  case op::inner:
    return {dense_.left_contraction(arg(0), arg(1)), {}};
  default:
    break;
  }
  throw spec_error(e.where, "this has no value as a dense multivector");
}

} // namespace meetc::verify
