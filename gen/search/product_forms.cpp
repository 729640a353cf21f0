#include "gen/search/product_forms.hpp"

#include <algorithm>
#include <set>

namespace meetc::search {
namespace {

using poly::poly;
using poly_ring = meetc::poly::ring;

// The variables of an operand's coefficients.
std::set<int> variables_of(const multivector &m) {
  std::set<int> out;
  for (const auto &[at, c] : m.terms())
    for (const int v : c.variables())
      out.insert(v);
  return out;
}

// The degree that all terms of p have in these variables; -1 where it differs.
int degree_in(const poly &p, const std::set<int> &variables) {
  int out = -1;
  for (const meetc::poly::term &t : p.terms()) {
    int sum = 0;
    for (const meetc::poly::power &f : t.factors)
      sum += variables.count(f.variable) ? f.exponent : 0;
    if (out >= 0 && sum != out)
      return -1;
    out = sum;
  }
  return out;
}

poly coefficient(const multivector &m, blade at, const poly_ring &ring) {
  const poly *c = m.find(at);
  return c ? *c : poly(ring);
}

bool agree(const multivector &m, const product_subject &of, int sign) {
  for (std::size_t i = 0; i < of.result.size(); ++i)
    if (!(coefficient(m, of.result[i], of.numbers).scaled(sign) == of.values[i]))
      return false;
  return true;
}

// Renamed into the ring of a system, in which leaves come first.
class raised {
public:
  raised(const value_system &s, const poly_ring &from) : s_(s) {
    for (int v = 0; v < from.size(); ++v)
      same_.push_back(v);
  }
  poly operator()(const poly &p) const { return p.renamed(same_, *s_.numbers); }
  multivector operator()(const multivector &m) const {
    multivector out;
    for (const auto &[at, c] : m.terms())
      out.add(at, (*this)(c));
    return out;
  }

private:
  const value_system &s_;
  std::vector<int> same_;
};

// The coefficients of m as values of s, from value `first` on.
multivector as_values(value_system &s, const raised &up, const multivector &m, std::size_t first) {
  multivector out;
  for (const auto &[at, c] : m.terms()) {
    s.values[first] = up(c);
    out.add(at, s.variable_of(first++));
  }
  return out;
}

// A relation that says of p which number it is: r = k (p - number).
struct known_number {
  std::size_t relation;
  rational scale, number;
};
std::optional<known_number> number_of(const poly &p, const std::vector<poly> &relations) {
  for (std::size_t i = 0; i < relations.size(); ++i) {
    if (relations[i].is_zero() || p.is_zero())
      continue;
    const rational k = relations[i].terms().front().coefficient / p.terms().front().coefficient;
    const poly rest = relations[i] - p.scaled(k);
    if (rest.is_zero() || rest.is_constant())
      return known_number{i, k, rest.is_zero() ? rational(0) : rational(-rest.constant() / k)};
  }
  return std::nullopt;
}

// The forms of V X ~V, or of its negative.
void sandwich_forms(const product_subject &of, const multivector &v, const multivector &x, int sign,
                    std::vector<known_form> &out) {
  const multivector back = reversed(v);
  const multivector norm = algebra::geometric(of.basis, v, back);
  const multivector difference = algebra::geometric(of.basis, v, x) - algebra::geometric(of.basis, x, v);
  const auto start = [&](std::size_t values) { return with_values(system_of(of.numbers, {}), values); };
  const auto outputs = [&](value_system &s, const multivector &all) {
    for (const blade at : of.result)
      s.outputs.push_back(coefficient(all, at, *s.numbers).scaled(sign));
  };
  { // N as values
    value_system s = start(norm.terms().size() + difference.terms().size());
    const raised up(s, of.numbers);
    const multivector n = as_values(s, up, norm, 0), m = as_values(s, up, difference, norm.terms().size());
    outputs(s, algebra::geometric(of.basis, up(x), n) + algebra::geometric(of.basis, m, up(back)));
    out.push_back({std::move(s), {}});
  }
  { // the expanded outputs, modulo the values' definitions
    value_system s = start(norm.terms().size());
    const raised up(s, of.numbers);
    as_values(s, up, norm, 0);
    for (const poly &p : of.values)
      s.outputs.push_back(up(p));
    for (std::size_t i = 0; i < s.values.size(); ++i)
      s.relations.push_back(s.values[i] - s.variable_of(i));
    out.push_back({std::move(s), {}});
  }
  if (of.relations.empty())
    return;
  // N as numbers, where relations say which.
  value_system s = start(norm.terms().size() + difference.terms().size());
  const raised up(s, of.numbers);
  const multivector m = as_values(s, up, difference, norm.terms().size());
  known_form form{{}, {}};
  multivector n;
  bool any = false;
  std::size_t at_value = 0;
  for (const auto &[at, c] : norm.terms()) {
    const auto number = number_of(c, of.relations);
    s.values[at_value] = up(c);
    if (number) {
      any = true;
      n.add(at, poly(*s.numbers, number->number));
      // V X ~V has c where the form has the number: c - number = relation / scale.
      const multivector left =
          algebra::geometric(of.basis, x, multivector(at, poly(of.numbers, rational(sign) / number->scale)));
      for (std::size_t i = 0; i < of.result.size(); ++i)
        if (const poly *f = left.find(of.result[i]))
          form.differences.push_back({i, number->relation, *f});
    } else {
      n.add(at, s.variable_of(at_value));
    }
    ++at_value;
  }
  if (!any)
    return;
  outputs(s, algebra::geometric(of.basis, up(x), n) + algebra::geometric(of.basis, m, up(back)));
  form.system = std::move(s);
  out.push_back(std::move(form));
}

bool add_sandwiches(const product_subject &of, std::size_t versor, std::size_t object, std::vector<known_form> &out) {
  const multivector &v = of.operands[versor], &x = of.operands[object];
  const std::set<int> of_v = variables_of(v), of_x = variables_of(x);
  if (of_v.size() < 2 || of_x.empty())
    return false;
  bool any = false;
  for (const poly &p : of.values) {
    const int in_v = degree_in(p, of_v), in_x = degree_in(p, of_x);
    if (!p.is_zero() && (in_v != 2 || in_x < 0 || in_x > 1))
      return false;
    any = any || !p.is_zero();
  }
  if (!any)
    return false;
  for (const multivector &used : {v, reversed(v)}) {
    const multivector product = algebra::geometric(of.basis, algebra::geometric(of.basis, used, x), reversed(used));
    for (const int sign : {1, -1})
      if (agree(product, of, sign)) {
        sandwich_forms(of, used, x, sign, out);
        return true;
      }
  }
  return false;
}

// (a, b) with f = a p + b q.
std::optional<std::pair<rational, rational>> solved(const poly &f, const poly &p, const poly &q) {
  std::map<meetc::poly::monomial, std::array<rational, 3>> rows;
  const poly *const all[] = {&p, &q, &f};
  for (std::size_t i = 0; i < 3; ++i)
    for (const meetc::poly::term &t : all[i]->terms())
      rows[t.factors][i] = t.coefficient;
  for (auto r = rows.begin(); r != rows.end(); ++r)
    for (auto s = std::next(r); s != rows.end(); ++s) {
      const auto &[a, b] = std::pair(r->second, s->second);
      const rational det = a[0] * b[1] - a[1] * b[0];
      if (det == 0)
        continue;
      const rational x = (a[2] * b[1] - a[1] * b[2]) / det, y = (a[0] * b[2] - a[2] * b[0]) / det;
      if (p.scaled(x) + q.scaled(y) == f)
        return std::pair(x, y);
      return std::nullopt;
    }
  return std::nullopt;
}

void add_grams(const product_subject &of, std::vector<known_form> &out) {
  if (of.result != std::vector<blade>{0} || of.values[0].is_zero())
    return;
  const multivector &x = of.operands[0], &y = of.operands[1];
  if (degree_in(of.values[0], variables_of(x)) != 2 || degree_in(of.values[0], variables_of(y)) != 2)
    return;
  const auto square = [&](const multivector &m) {
    return coefficient(algebra::product(of.basis, m, m, [](blade, blade, blade z) { return z == 0; }), 0,
                       m.terms().begin()->second.in());
  };
  if (x.is_zero() || y.is_zero())
    return;
  const poly xx = square(x), yy = square(y);
  const multivector both = algebra::geometric(of.basis, x, y);
  std::set<int> grades;
  for (const auto &[at, c] : both.terms())
    grades.insert(algebra::grade(at));
  for (const int k : grades) {
    multivector part;
    for (const auto &[at, c] : both.terms())
      if (algebra::grade(at) == k)
        part.add(at, c);
    const auto factors = solved(of.values[0], xx * yy, square(part));
    if (!factors)
      continue;
    value_system s = with_values(system_of(of.numbers, {}), 2 + part.terms().size());
    const raised up(s, of.numbers);
    s.values[0] = up(xx);
    s.values[1] = up(yy);
    const multivector values = as_values(s, up, part, 2);
    s.outputs = {(s.variable_of(0) * s.variable_of(1)).scaled(factors->first) + square(values).scaled(factors->second)};
    out.push_back({std::move(s), {}});
  }
}

} // namespace

multivector reversed(const multivector &m) {
  multivector out;
  for (const auto &[at, c] : m.terms()) {
    const int g = algebra::grade(at);
    out.add(at, c.scaled(g * (g - 1) / 2 % 2 ? -1 : 1));
  }
  return out;
}

std::vector<known_form> product_forms(const product_subject &of) {
  std::vector<known_form> out;
  if (of.operands.size() != 2)
    return out;
  if (!add_sandwiches(of, 0, 1, out))
    add_sandwiches(of, 1, 0, out);
  add_grams(of, out);
  return out;
}

} // namespace meetc::search
