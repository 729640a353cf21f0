#include "gen/poly/squares.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace meetc::poly {
namespace {

// The symbol of u.v, or -1 where the form has none.
int dot_symbol(const form &f, int u, int v) {
  for (std::size_t s = 0; s < f.invariants.size(); ++s) {
    const invariant &q = f.invariants[s];
    if (q.kind == invariant::type::dot && q.i == std::min(u, v) && q.j == std::max(u, v))
      return static_cast<int>(s);
  }
  return -1;
}

poly variable(const form &f, int symbol) {
  return poly::variable(*f.symbols, symbol);
}

// A form with the symbols of v and room for made ones.
form start(const vector_form &v) {
  std::vector<std::string> names = v.symbols->names();
  for (int i = 0; i < most_made; ++i)
    names.push_back(fmt::format("m{}", i));
  auto symbols = std::make_shared<ring>(names);
  poly value = poly::from_terms(*symbols, v.form.terms());
  return {std::move(symbols), v.invariants, {}, std::move(value)};
}

// The quotient of a division by leading terms, whatever remains.
poly divided(poly a, const poly &b) {
  const term lead = b.terms().front();
  std::vector<term> out;
  while (!a.is_zero()) {
    const term t = a.terms().front();
    const poly first = poly::from_terms(a.in(), {t});
    if (const auto q = quotient(first, poly::from_terms(a.in(), {lead}))) {
      out.push_back(q->terms().front());
      a = a - *q * b;
    } else {
      a = a - first;
    }
  }
  return poly::from_terms(b.in(), out);
}

std::optional<form> complete_square(const form &f, int symbol) {
  const std::vector<poly> c = coefficients(f.value, symbol);
  if (c.size() != 3 || c[1].is_zero())
    return std::nullopt;
  const auto exact = quotient(c[1], c[2].scaled(2));
  const poly shift = exact ? *exact : divided(c[1], c[2].scaled(2));
  if (shift.is_zero())
    return std::nullopt;
  form out = f;
  const poly whole = variable(f, f.symbol(f.made.size()));
  out.made.push_back({made_symbol::type::sum, variable(f, symbol) + shift, poly(*f.symbols)});
  out.value = c[2] * whole * whole + (c[1] - c[2].scaled(2) * shift) * (whole - shift) + c[0] - c[2] * shift * shift;
  // A part of a square is worth a symbol where it shortens the form.
  if (!exact && out.value.length() >= f.value.length())
    return std::nullopt;
  return out;
}

// The coefficient of `symbol` alone: of the terms that hold it once and hold none of the others.
poly alone(const poly &p, int symbol, const std::array<int, 3> &others) {
  std::vector<term> out;
  for (term t : p.terms()) {
    const auto holds = [&](int s) {
      return std::any_of(t.factors.begin(), t.factors.end(), [&](const power &q) { return q.variable == s; });
    };
    if (!holds(symbol) || std::any_of(others.begin(), others.end(), [&](int s) { return s != symbol && holds(s); }))
      continue;
    const auto at =
        std::find_if(t.factors.begin(), t.factors.end(), [&](const power &q) { return q.variable == symbol; });
    if (at->exponent != 1)
      continue;
    t.factors.erase(at);
    out.push_back(std::move(t));
  }
  return poly::from_terms(p.in(), out);
}

std::optional<form> length(const form &f, int u, int v) {
  const std::array<int, 3> dots{dot_symbol(f, u, u), dot_symbol(f, u, v), dot_symbol(f, v, v)};
  if (std::any_of(dots.begin(), dots.end(), [](int s) { return s < 0; }))
    return std::nullopt;
  const poly uu = alone(f.value, dots[0], dots), uv = alone(f.value, dots[1], dots), vv = alone(f.value, dots[2], dots);
  if (uu.is_zero() || uv.is_zero() || vv.is_zero() || !(uv * uv == (uu * vv).scaled(4)))
    return std::nullopt;
  // uu = k a^2, and then uv = 2 k a b gives b.
  const auto root = square_root(uu);
  if (!root)
    return std::nullopt;
  const auto &[k, a] = *root;
  const auto b = quotient(uv, a.scaled(2 * k));
  if (!b)
    return std::nullopt;
  form out = f;
  out.made.push_back({made_symbol::type::length, a, *b, u, v});
  out.value = f.value - uu * variable(f, dots[0]) - uv * variable(f, dots[1]) - vv * variable(f, dots[2]) +
              variable(f, f.symbol(f.made.size())).scaled(k);
  return out;
}

// Appends what the rewritings make of f, and what they make of that.
void rewrite_all(const form &f, const std::vector<int> &vectors, std::vector<form> &out) {
  if (f.made.size() == most_made)
    return;
  const auto add = [&](const std::optional<form> &next) {
    if (!next)
      return;
    out.push_back(*next);
    rewrite_all(*next, vectors, out);
  };
  for (const int s : f.value.variables())
    add(complete_square(f, s));
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (std::size_t j = i + 1; j < vectors.size(); ++j)
      add(length(f, vectors[i], vectors[j]));
}

} // namespace

poly expanded(const form &of) {
  std::vector<poly> images;
  for (int s = 0; s < of.symbols->size(); ++s)
    images.push_back(variable(of, s));
  for (std::size_t i = 0; i < of.made.size(); ++i) {
    const made_symbol &m = of.made[i];
    const poly a = m.first.substitute(images, *of.symbols), b = m.second.substitute(images, *of.symbols);
    const auto dot = [&](int u, int v) { return variable(of, dot_symbol(of, u, v)); };
    images[static_cast<std::size_t>(of.symbol(i))] =
        m.kind == made_symbol::type::sum
            ? a
            : a * a * dot(m.u, m.u) + (a * b * dot(m.u, m.v)).scaled(2) + b * b * dot(m.v, m.v);
  }
  return of.value.substitute(images, *of.symbols);
}

std::vector<form> squares(const vector_form &v) {
  const form from = start(v);
  std::vector<int> vectors;
  for (const invariant &q : v.invariants)
    if (q.kind == invariant::type::dot && q.i == q.j)
      vectors.push_back(q.i);
  std::sort(vectors.begin(), vectors.end());
  std::vector<form> out;
  rewrite_all(from, vectors, out);
  for (const form &f : out)
    if (!(expanded(f) == from.value))
      throw std::logic_error("a form with completed squares differs from the polynomial");
  return out;
}

} // namespace meetc::poly
