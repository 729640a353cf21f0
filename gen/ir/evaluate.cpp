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

} // namespace

std::vector<poly::poly> to_poly(const program &p, const poly::ring &inputs) {
  return fold_results(p, exact<poly::poly>([&](int i) { return poly::poly::variable(inputs, i); },
                                           [&](const rational &q) { return poly::poly(inputs, q); }));
}

std::vector<rational> evaluate(const program &p, const std::vector<rational> &inputs) {
  return fold_results(p, exact<rational>([&](int i) { return inputs[static_cast<std::size_t>(i)]; },
                                         [](const rational &q) { return q; }));
}

} // namespace meetc::ir
