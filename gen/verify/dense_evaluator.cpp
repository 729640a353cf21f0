#include "gen/verify/dense_evaluator.hpp"

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

// A multivector on other vectors: vector i becomes row i.
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
} // namespace

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
  case op::divide: {
    const rational by = oracle::scalar_part(arg(1));
    if (by == 0)
      throw spec_error(e.args[1]->where, "only a number other than 0 divides");
    return {oracle::scale(1 / by, arg(0)), {}};
  }
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
