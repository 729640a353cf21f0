#include "gen/verify/dense_evaluator.hpp"

#include "gen/lang/operators.hpp"

#include <algorithm>
#include <stdexcept>

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

// The inverse of a regular matrix, by Gauss and Jordan.
oracle::matrix inverse(oracle::matrix m) {
  const std::size_t n = m.size();
  for (std::size_t i = 0; i < n; ++i) {
    m[i].resize(2 * n);
    m[i][n + i] = 1;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto pivot =
        std::find_if(m.begin() + static_cast<std::ptrdiff_t>(i), m.end(), [&](const auto &row) { return row[i] != 0; });
    if (pivot == m.end())
      throw std::invalid_argument("the vectors are no basis");
    std::swap(*pivot, m[i]);
    const rational by = m[i][i];
    for (rational &x : m[i])
      x /= by;
    for (std::size_t j = 0; j < n; ++j)
      if (const rational k = m[j][i]; j != i && k != 0)
        for (std::size_t c = 0; c < 2 * n; ++c)
          m[j][c] -= k * m[i][c];
  }
  for (auto &row : m)
    row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(n));
  return m;
}
} // namespace

multivector changed(const multivector &x, const oracle::matrix &rows) {
  multivector out(x.size());
  for (std::size_t mask = 0; mask < x.size(); ++mask) {
    if (x[mask] == 0)
      continue;
    multivector blade(x.size());
    blade[0] = x[mask];
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (mask >> i & 1) {
        multivector v(x.size());
        for (std::size_t j = 0; j < rows.size(); ++j)
          v[std::size_t{1} << j] = rows[i][j];
        blade = oracle::outer(blade, v);
      }
    out = oracle::add(out, blade);
  }
  return out;
}

dense_evaluator::dense_evaluator(const lang::algebra &a, const oracle::matrix &metric,
                                 const oracle::matrix &declared_vectors, const oracle::matrix &working_vectors)
    : spec_(a), dense_(metric),
      declared_vectors_(declared_vectors), coordinates_{inverse(working_vectors), inverse(declared_vectors)} {}

// The coefficient of m along a blade that is a multiple of a basis blade, of the working basis or else of the declared one.
rational dense_evaluator::coefficient(const multivector &m, const multivector &along, const lang::expr &index) const {
  for (const oracle::matrix &rows : coordinates_) {
    const multivector at = changed(along, rows);
    const auto nonzero = [](const rational &q) { return q != 0; };
    if (std::count_if(at.begin(), at.end(), nonzero) != 1)
      continue;
    const auto i = static_cast<std::size_t>(std::find_if(at.begin(), at.end(), nonzero) - at.begin());
    return changed(m, rows)[i] / at[i];
  }
  throw spec_error(index.where, "this is not a multiple of one basis blade");
}

dense_value dense_evaluator::operand(const lang::kind &k, const std::vector<rational> &numbers,
                                     std::size_t &next) const {
  std::map<std::string, dense_value> members;
  for (const lang::field &f : k.store)
    members[f.name] = f.type == "real" ? dense_value{dense_.scalar(numbers.at(next++)), {}}
                                       : operand(*spec_.find_kind(f.type), numbers, next);
  return made(k, std::move(members));
}

dense_value dense_evaluator::made(const lang::kind &k, std::map<std::string, dense_value> members) const {
  dense_value out{evaluate(*k.blade, members), {}, &k};
  out.members = std::move(members);
  return out;
}

multivector dense_evaluator::evaluate(const lang::expr &e, const dense_scope &scope) const {
  dense_value v = value(e, scope);
  if (!v.items.empty())
    throw spec_error(e.where, "this has no value as a dense multivector");
  return std::move(v.blade);
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
    if (v == spec_.vectors.end()) {
      multivector blade = dense_.scalar(1);
      const std::vector<std::string> vectors = lang::vectors_of_name(spec_, e.text);
      for (const std::string &name : vectors)
        blade = oracle::outer(blade, evaluate({op::name, e.where, name, {}, {}}, {}));
      if (!vectors.empty())
        return {blade, {}};
      if (e.text == "I")
        return {pseudoscalar(), {}};
      break;
    }
    multivector m = dense_.zero();
    const auto &row = declared_vectors_[static_cast<std::size_t>(v - spec_.vectors.begin())];
    for (std::size_t i = 0; i < row.size(); ++i)
      m[std::size_t{1} << i] = row[i];
    return {m, {}};
  }
  case op::builtin:
  case op::call: {
    if (lang::called_builtin(spec_, e)) {
      std::vector<multivector> arguments;
      for (std::size_t i = 0; i < e.args.size(); ++i)
        arguments.push_back(arg(i));
      return {builtin(e, arguments), {}};
    }
    if (e.text == "sign")
      return {dense_.scalar(sgn(oracle::scalar_part(arg(0)))), {}};
    std::vector<dense_value> arguments;
    for (const lang::expr_ptr &a : e.args)
      arguments.push_back(value(*a, scope));
    if (const lang::function *f = spec_.find_function(e.text)) {
      dense_scope inner;
      for (std::size_t i = 0; i < f->params.size(); ++i)
        inner[f->params[i]] = arguments[i];
      return value(*f->body, inner);
    }
    if (const lang::predicate *p = spec_.find_predicate(e.text))
      return {dense_.scalar(hit(*p, arguments) ? 1 : 0), {}};
    if (const lang::kind *k = spec_.find_kind(e.text)) {
      std::map<std::string, dense_value> members;
      for (std::size_t i = 0; i < k->store.size(); ++i)
        members[k->store[i].name] = arguments[i];
      return made(*k, std::move(members));
    }
    if (e.text == "zero") {
      const multivector &m = arguments.at(0).blade;
      const bool all = std::all_of(m.begin(), m.end(), [](const rational &q) { return q == 0; });
      return {dense_.scalar(all ? 1 : 0), {}};
    }
    break;
  }
  case op::member: {
    const dense_value base = value(*e.args[0], scope);
    if (const auto it = base.members.find(e.text); it != base.members.end())
      return it->second;
    if (base.kind)
      for (const lang::named_expr &part : base.kind->parts)
        if (part.name == e.text)
          return value(*part.body, base.members);
    break;
  }
  case op::index:
    return {dense_.scalar(coefficient(arg(0), arg(1), *e.args[1])), {}};
  case op::negate:
    return {oracle::scale(-1, arg(0)), {}};
  case op::add:
    return {oracle::add(arg(0), arg(1)), {}};
  case op::subtract:
    return {oracle::subtract(arg(0), arg(1)), {}};
  case op::multiply:
    return {dense_.geometric(arg(0), arg(1)), {}};
  case op::divide:
    return {dense_.geometric(arg(0), dense_.inverse(arg(1))), {}};
  case op::outer:
    return {oracle::outer(arg(0), arg(1)), {}};
  case op::inner:
    return {dense_.left_contraction(arg(0), arg(1)), {}};
  default:
    if (auto v = truth_value(e, scope))
      return std::move(*v);
    break;
  }
  throw spec_error(e.where, "this has no value as a dense multivector");
}

} // namespace meetc::verify
