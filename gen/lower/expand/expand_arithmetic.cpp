// Expansion of sums, products and quotients of multivectors, with limits on the result.
#include "gen/lower/expand/expand.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc::lower {
namespace {
using lang::op;

// Limits far above any reasonable spec, which turn a runaway spec into an error.
constexpr int most_degree = 100;

std::size_t length(const multivector &m) {
  std::size_t terms = 0;
  for (const auto &[at, c] : m.terms())
    terms += c.length();
  return terms;
}

// Whether an expression consists of numbers alone, written or as constants.
bool is_number(const lang::expr &e, const lang::algebra &spec, const environment &env) {
  if (e.kind == op::name) {
    const bool local = std::any_of(env.begin(), env.end(), [&](const auto &b) { return b.first == e.text; });
    const lang::named_expr *constant = local ? nullptr : spec.find_constant(e.text);
    return constant && is_number(*constant->body, spec, {});
  }
  return e.kind == op::number ||
         ((e.kind == op::negate || e.kind == op::add || e.kind == op::subtract || e.kind == op::multiply ||
           e.kind == op::divide) &&
          std::all_of(e.args.begin(), e.args.end(), [&](const lang::expr_ptr &a) { return is_number(*a, spec, env); }));
}

// Whether a text is a factor as it stands: one name, one call, or one pair of parentheses.
bool is_factor(const lang::expr &e, const std::string &text) {
  int depth = 0;
  std::size_t closed = 0; // where the first parenthesis is closed
  for (std::size_t i = 0; i < text.size() && text.front() == '(' && closed == 0; ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    closed = depth == 0 ? i : 0;
  }
  return e.kind == op::name || e.kind == op::call || (closed > 0 && closed + 1 == text.size());
}

// The likely meaning of a number after '^': a power.
std::string meant(const std::string &factor, const lang::expr &exponent) {
  const std::string n = lang::print(exponent);
  if (n == "-1" || n == "(-1)")
    return fmt::format("write inverse({}) for an inverse, and '*' to scale", factor);
  const bool power = n.size() == 1 && n[0] > '2' && n[0] <= '9';
  std::string product = factor + '*' + factor;
  for (int i = 2; power && i < n[0] - '0'; ++i)
    product += '*' + factor;
  return fmt::format("write {} for a {}, and '*' to scale", product, power ? "power" : "square");
}

// A^2 is no square, and A | 2 is hardly ever meant.
void refuse_number(const lang::expr &e, const lang::algebra &spec, const environment &env) {
  for (std::size_t i = 0; i < 2; ++i)
    if (is_number(*e.args[i], spec, env)) {
      const lang::expr &other = *e.args[1 - i];
      const std::string text = lang::print(other);
      const std::string factor = is_factor(other, text) ? text : '(' + text + ')';
      throw spec_error(e.where, e.kind == op::outer
                                    ? "'^' is the outer product, which a number only scales: " +
                                          (i == 1 ? meant(factor, *e.args[1]) : "write '*' to scale")
                                    : "'|' is the inner product, and a number has none with what is no number: "
                                      "write '*' to scale");
    }
}

} // namespace

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
  if (e.kind == op::outer || e.kind == op::inner)
    refuse_number(e, model_.spec(), env);
  const multivector x = blade_of(a, e.args[0]->where), y = blade_of(b, e.args[1]->where);
  if (e.kind == op::multiply || e.kind == op::outer || e.kind == op::inner)
    charge_product(x, y, e.where);
  switch (e.kind) {
  case op::add:
    return checked(x + y, e.where);
  case op::subtract:
    return checked(x - y, e.where);
  case op::multiply:
    return checked(algebra::geometric(*basis_, x, y), e.where);
  case op::outer:
    return checked(algebra::outer(*basis_, x, y), e.where);
  case op::inner:
    return checked(algebra::inner(*basis_, x, y), e.where);
  default:
    break;
  }
  if (roots_ && y.is_scalar() && !y.is_zero() && !y.terms().begin()->second.is_constant()) {
    const multivector one_over(0, roots_->reciprocal(y.terms().begin()->second, e.args[1]->where));
    charge_product(x, one_over, e.where);
    return checked(algebra::geometric(*basis_, x, one_over), e.where);
  }
  const multivector by = inverse(y, *e.args[1]);
  if (by.is_scalar())
    return checked(x.scaled(by.terms().begin()->second.constant()), e.where);
  charge_product(x, by, e.where);
  return checked(algebra::geometric(*basis_, x, by), e.where);
}

void expander::charge_product(const multivector &x, const multivector &y, const location &where) {
  charge(4 * x.terms().size() * y.terms().size() + length(x) * length(y) / 64, where);
}

value expander::checked(const multivector &m, const location &where) const {
  if (length(m) > most_terms)
    throw too_long(where, fmt::format("this expands to more than {} terms", most_terms));
  for (const auto &[at, c] : m.terms()) {
    if (c.total_degree() > most_degree)
      throw spec_error(where, fmt::format("this is of a degree above {}", most_degree));
    if (c.is_constant()) {
      const rational q = c.constant();
      if (mpz_sizeinbase(q.get_num_mpz_t(), 2) + mpz_sizeinbase(q.get_den_mpz_t(), 2) > most_bits_)
        throw spec_error(where, fmt::format("this number has more than {} bits", most_bits_));
    }
  }
  return {m};
}

} // namespace meetc::lower
