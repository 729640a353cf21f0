#include "gen/ir/evaluate.hpp"

#include "gen/ir/fold.hpp"

namespace meetc::ir {
namespace {

// A domain for any exact type with + - * and a way to make its inputs and constants.
template <class Value, class Input, class Constant> struct exact_domain {
  using value = Value;
  Input make_input;
  Constant make_constant;

  value input(const node_ref &, int number) { return make_input(number); }
  value constant(const node_ref &, const rational &q) { return make_constant(q); }
  value negate(const node_ref &, const value &x) { return make_constant(-1) * x; }
  value add(const node_ref &, const value &x, const value &y) { return x + y; }
  value subtract(const node_ref &, const value &x, const value &y) { return x - y; }
  value multiply(const node_ref &, const value &x, const value &y) { return x * y; }
  value fused(const node_ref &, const value &x, const value &y, const value &z) { return x * y + z; }
};
template <class Value, class Input, class Constant> auto exact(Input input, Constant constant) {
  return exact_domain<Value, Input, Constant>{input, constant};
}

// Products of terms that one expansion may take.
constexpr std::size_t most_products = 4'000'000;

// Polynomials, or nothing once they have become too long.
struct bounded_poly {
  std::optional<poly::poly> p;
  std::shared_ptr<std::size_t> spent;

  static bounded_poly sum(const bounded_poly &x, std::optional<poly::poly> p) {
    if (p)
      *x.spent += p->length();
    if (*x.spent > most_products)
      p.reset();
    return {std::move(p), x.spent};
  }
  friend bounded_poly operator+(const bounded_poly &x, const bounded_poly &y) {
    return sum(x, x.p && y.p ? std::optional(*x.p + *y.p) : std::nullopt);
  }
  friend bounded_poly operator-(const bounded_poly &x, const bounded_poly &y) {
    return sum(x, x.p && y.p ? std::optional(*x.p - *y.p) : std::nullopt);
  }
  friend bounded_poly operator*(const bounded_poly &x, const bounded_poly &y) {
    if (!x.p || !y.p)
      return {std::nullopt, x.spent};
    *x.spent += x.p->length() * y.p->length();
    return {*x.spent > most_products ? std::nullopt : std::optional(*x.p * *y.p), x.spent};
  }
};

} // namespace

std::optional<std::vector<poly::poly>> short_polys(const program &p, const poly::ring &inputs) {
  const auto spent = std::make_shared<std::size_t>(0);
  const std::vector<bounded_poly> values =
      fold_results(p, exact<bounded_poly>(
                          [&](int i) {
                            return bounded_poly{poly::poly::variable(inputs, i), spent};
                          },
                          [&](const rational &q) {
                            return bounded_poly{poly::poly(inputs, q), spent};
                          }));
  std::vector<poly::poly> out;
  for (const bounded_poly &v : values) {
    if (!v.p)
      return std::nullopt;
    out.push_back(*v.p);
  }
  return out;
}

std::vector<poly::poly> to_poly(const program &p, const poly::ring &inputs) {
  return fold_results(p, exact<poly::poly>([&](int i) { return poly::poly::variable(inputs, i); },
                                           [&](const rational &q) { return poly::poly(inputs, q); }));
}

std::vector<rational> evaluate(const program &p, const std::vector<rational> &inputs) {
  return fold_results(p, exact<rational>([&](int i) { return inputs[static_cast<std::size_t>(i)]; },
                                         [](const rational &q) { return q; }));
}

} // namespace meetc::ir
