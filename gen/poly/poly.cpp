#include "gen/poly/poly.hpp"

#include <algorithm>
#include <array>
#include <flint/fmpq_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>
#include <stdexcept>

namespace meetc::poly {

struct ring::context {
  fmpq_mpoly_ctx_t value;
};
struct poly::storage {
  fmpq_mpoly_t value;
  const fmpq_mpoly_ctx_struct *context;
  explicit storage(const ring &r) : context(r.flint()->value) { fmpq_mpoly_init(value, context); }
  ~storage() { fmpq_mpoly_clear(value, context); }
  storage(const storage &) = delete;
  storage &operator=(const storage &) = delete;
};

namespace {
class flint_rational {
public:
  flint_rational() { fmpq_init(value); }
  explicit flint_rational(const rational &q) : flint_rational() { fmpq_set_mpq(value, q.get_mpq_t()); }
  ~flint_rational() { fmpq_clear(value); }
  flint_rational(const flint_rational &) = delete;
  flint_rational &operator=(const flint_rational &) = delete;
  rational get() const {
    rational q;
    fmpq_get_mpq(q.get_mpq_t(), value);
    return q;
  }
  fmpq_t value;
};
} // namespace

ring::ring(std::vector<std::string> names) : names_(std::move(names)), context_(std::make_unique<context>()) {
  // FLINT needs at least one variable.
  fmpq_mpoly_ctx_init(context_->value, std::max<slong>(1, static_cast<slong>(names_.size())), ORD_DEGLEX);
}
ring::~ring() {
  fmpq_mpoly_ctx_clear(context_->value);
}

int ring::find(const std::string &name) const {
  const auto it = std::find(names_.begin(), names_.end(), name);
  return it == names_.end() ? -1 : static_cast<int>(it - names_.begin());
}

poly::poly(const ring &r) : ring_(&r), p_(std::make_shared<storage>(r)) {}
poly::poly(const ring &r, const rational &constant) : poly(r) {
  fmpq_mpoly_set_fmpq(p_->value, flint_rational(constant).value, p_->context);
}
poly poly::variable(const ring &r, int v) {
  poly out(r);
  fmpq_mpoly_gen(out.p_->value, v, out.p_->context);
  return out;
}
poly poly::from_terms(const ring &r, const std::vector<term> &terms) {
  poly out(r);
  std::vector<ulong> exponents(static_cast<std::size_t>(std::max(1, r.size())));
  for (const term &t : terms) {
    std::fill(exponents.begin(), exponents.end(), 0);
    for (const power &f : t.factors)
      exponents[static_cast<std::size_t>(f.variable)] += static_cast<ulong>(f.exponent);
    fmpq_mpoly_push_term_fmpq_ui(out.p_->value, flint_rational(t.coefficient).value, exponents.data(), out.p_->context);
  }
  fmpq_mpoly_sort_terms(out.p_->value, out.p_->context);
  fmpq_mpoly_combine_like_terms(out.p_->value, out.p_->context);
  return out;
}
bool poly::is_zero() const {
  return fmpq_mpoly_is_zero(p_->value, p_->context) != 0;
}
bool poly::is_constant() const {
  return fmpq_mpoly_is_fmpq(p_->value, p_->context) != 0;
}
rational poly::constant() const {
  flint_rational q;
  fmpq_mpoly_get_fmpq(q.value, p_->value, p_->context);
  return q.get();
}
std::size_t poly::length() const {
  return static_cast<std::size_t>(fmpq_mpoly_length(p_->value, p_->context));
}
int poly::total_degree() const {
  return is_zero() ? 0 : static_cast<int>(fmpq_mpoly_total_degree_si(p_->value, p_->context));
}
int poly::degree(int v) const {
  return is_zero() ? 0 : static_cast<int>(fmpq_mpoly_degree_si(p_->value, v, p_->context));
}

poly operator+(const poly &a, const poly &b) {
  poly out(*a.ring_);
  fmpq_mpoly_add(out.p_->value, a.p_->value, b.p_->value, out.p_->context);
  return out;
}
poly operator-(const poly &a, const poly &b) {
  poly out(*a.ring_);
  fmpq_mpoly_sub(out.p_->value, a.p_->value, b.p_->value, out.p_->context);
  return out;
}
poly operator*(const poly &a, const poly &b) {
  poly out(*a.ring_);
  fmpq_mpoly_mul(out.p_->value, a.p_->value, b.p_->value, out.p_->context);
  return out;
}
bool operator==(const poly &a, const poly &b) {
  return a.ring_ == b.ring_ && fmpq_mpoly_equal(a.p_->value, b.p_->value, a.p_->context) != 0;
}
poly poly::scaled(const rational &q) const {
  poly out(*ring_);
  fmpq_mpoly_scalar_mul_fmpq(out.p_->value, p_->value, flint_rational(q).value, p_->context);
  return out;
}
poly poly::derivative(int v) const {
  poly out(*ring_);
  fmpq_mpoly_derivative(out.p_->value, p_->value, v, p_->context);
  return out;
}

std::vector<term> poly::terms() const {
  std::vector<term> out;
  const std::size_t n = length();
  std::vector<ulong> exponents(static_cast<std::size_t>(std::max(1, ring_->size())));
  flint_rational q;
  for (std::size_t i = 0; i < n; ++i) {
    fmpq_mpoly_get_term_coeff_fmpq(q.value, p_->value, static_cast<slong>(i), p_->context);
    fmpq_mpoly_get_term_exp_ui(exponents.data(), p_->value, static_cast<slong>(i), p_->context);
    term t{q.get(), {}};
    for (int v = 0; v < ring_->size(); ++v)
      if (exponents[static_cast<std::size_t>(v)])
        t.factors.push_back({v, static_cast<int>(exponents[static_cast<std::size_t>(v)])});
    out.push_back(std::move(t));
  }
  return out;
}

std::vector<int> poly::variables() const {
  std::vector<char> used(static_cast<std::size_t>(ring_->size()));
  for (const term &t : terms())
    for (const power &f : t.factors)
      used[static_cast<std::size_t>(f.variable)] = 1;
  std::vector<int> out;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v])
      out.push_back(static_cast<int>(v));
  return out;
}

std::string poly::key() const {
  std::string out;
  for (const term &t : terms()) {
    out += t.coefficient.get_str();
    for (const power &f : t.factors)
      out += '*' + std::to_string(f.variable) + '^' + std::to_string(f.exponent);
    out += ';';
  }
  return out;
}

std::string poly::text() const {
  if (is_zero())
    return "0";
  std::string out;
  for (const term &t : terms()) {
    rational c = t.coefficient;
    if (!out.empty())
      out += c < 0 ? " - " : " + ";
    else if (c < 0)
      out += "-";
    c = abs(c);
    std::string factors;
    for (const power &f : t.factors) {
      factors += (factors.empty() ? "" : "*") + ring_->name(f.variable);
      if (f.exponent > 1)
        factors += '^' + std::to_string(f.exponent);
    }
    if (factors.empty())
      out += c.get_str();
    else
      out += (c == 1 ? "" : c.get_str() + "*") + factors;
  }
  return out;
}

namespace {

// t with each variable v replaced by images[v], a term or zero; nothing where the result is zero.
std::optional<term> replaced(const term &t, const std::vector<std::optional<term>> &images) {
  term out{t.coefficient, {}};
  for (const power &f : t.factors) {
    const std::optional<term> &image = images[static_cast<std::size_t>(f.variable)];
    if (!image)
      return std::nullopt;
    for (int i = 0; i < f.exponent; ++i)
      out.coefficient *= image->coefficient;
    for (const power &g : image->factors)
      out.factors.push_back({g.variable, g.exponent * f.exponent});
  }
  return out;
}

// FLINT's composition multiplies each term by a matrix of exponents, with a row and a column for each variable: where all
// images are terms, a replacement term by term takes a time that grows with the terms alone.
poly replaced(const poly &p, const std::vector<std::optional<term>> &images, const ring &target) {
  std::vector<term> terms;
  for (const term &t : p.terms())
    if (std::optional<term> r = replaced(t, images))
      terms.push_back(std::move(*r));
  return poly::from_terms(target, terms);
}

} // namespace

poly poly::substitute(const std::vector<poly> &images, const ring &target) const {
  poly out(target);
  if (is_zero())
    return out;
  const std::vector<int> used = variables();
  const auto image_of = [&](int v) -> const poly & { return images[static_cast<std::size_t>(v)]; };
  if (std::all_of(used.begin(), used.end(), [&](int v) { return image_of(v).length() <= 1; })) {
    std::vector<std::optional<term>> single(images.size());
    for (const int v : used)
      if (!image_of(v).is_zero())
        single[static_cast<std::size_t>(v)] = image_of(v).terms().front();
    return replaced(*this, single, target);
  }
  std::vector<fmpq_mpoly_struct *> pointers;
  for (const poly &image : images)
    pointers.push_back(image.p_->value);
  if (!fmpq_mpoly_compose_fmpq_mpoly(out.p_->value, p_->value, pointers.data(), p_->context, out.p_->context))
    throw std::runtime_error("a substitution is too large");
  return out;
}

poly poly::renamed(const std::vector<int> &to, const ring &target) const {
  std::vector<std::optional<term>> single(to.size());
  for (std::size_t v = 0; v < to.size(); ++v)
    if (to[v] >= 0)
      single[v] = term{1, {{to[v], 1}}};
  return replaced(*this, single, target);
}

rational poly::evaluate(const std::vector<rational> &values) const {
  rational sum = 0;
  for (const term &t : terms()) {
    rational product = t.coefficient;
    for (const power &f : t.factors)
      for (int i = 0; i < f.exponent; ++i)
        product *= values[static_cast<std::size_t>(f.variable)];
    sum += product;
  }
  return sum;
}

std::pair<rational, poly> poly::primitive() const {
  if (is_zero())
    return {0, *this};
  const std::vector<term> all = terms();
  mpz_class g = 0, l = 1;
  for (const term &t : all) {
    g = gcd(g, t.coefficient.get_num());
    l = lcm(l, t.coefficient.get_den());
  }
  rational content(g, l);
  content.canonicalize();
  if (all.front().coefficient < 0)
    content = -content;
  return {content, scaled(1 / content)};
}

namespace {
// Whether a primitive polynomial is seen to have no factors: a variable occurs in one term only, to the first power, and no
// variable is in all terms. The one of two factors without the former variable divides its cofactor, which is a monomial,
// and all other terms; so it is a number. Sums of products are of this form, and the general search, in tens of variables,
// takes most of the time of a compilation.
bool is_plainly_irreducible(const std::vector<term> &terms, int variables) {
  std::vector<int> occurrences(static_cast<std::size_t>(variables)), exponents = occurrences;
  for (const term &t : terms)
    for (const power &f : t.factors)
      ++occurrences[static_cast<std::size_t>(f.variable)],
          exponents[static_cast<std::size_t>(f.variable)] += f.exponent;
  const auto all = static_cast<int>(terms.size());
  return all > 1 && std::find(occurrences.begin(), occurrences.end(), all) == occurrences.end() &&
         std::find(exponents.begin(), exponents.end(), 1) != exponents.end();
}
} // namespace

poly::factor poly::factors() const {
  auto [content, rest] = primitive();
  factor out{{}, content};
  if (rest.is_constant()) {
    out.content *= rest.is_zero() ? rational(0) : rest.constant();
    return out;
  }
  if (is_plainly_irreducible(rest.terms(), ring_->size())) {
    out.parts.emplace_back(std::move(rest), 1);
    return out;
  }
  auto *integers = const_cast<fmpz_mpoly_ctx_struct *>(rest.p_->context->zctx);
  fmpz_mpoly_factor_t f;
  fmpz_mpoly_factor_init(f, integers);
  if (!fmpz_mpoly_factor(f, rest.p_->value->zpoly, integers)) {
    fmpz_mpoly_factor_clear(f, integers);
    out.parts.emplace_back(rest, 1); // FLINT did not succeed; one factor is still correct
    return out;
  }
  for (slong i = 0; i < fmpz_mpoly_factor_length(f, integers); ++i) {
    poly part(*ring_);
    fmpz_mpoly_factor_get_base(part.p_->value->zpoly, f, i, integers);
    fmpq_one(part.p_->value->content);
    const slong exponent = fmpz_mpoly_factor_get_exp_si(f, i, integers);
    auto [unit, base] = part.primitive();
    out.parts.emplace_back(base, static_cast<int>(exponent));
  }
  fmpz_mpoly_factor_clear(f, integers);
  std::vector<std::pair<std::string, std::size_t>> order;
  for (std::size_t i = 0; i < out.parts.size(); ++i)
    order.emplace_back(out.parts[i].first.key(), i);
  std::sort(order.begin(), order.end());
  std::vector<std::pair<poly, int>> sorted;
  rational leading = 1; // of the product: terms are in a monomial order
  for (const auto &[key, i] : order) {
    const rational part = out.parts[i].first.terms().front().coefficient;
    for (int k = 0; k < out.parts[i].second; ++k)
      leading *= part;
    sorted.push_back(out.parts[i]);
  }
  out.parts = std::move(sorted);
  // The quotient of the primitive and the product of primitives is a sign.
  out.content = terms().front().coefficient / leading;
  return out;
}

std::optional<poly> quotient(const poly &a, const poly &b) {
  poly out(*a.ring_);
  if (b.is_zero() || !fmpq_mpoly_divides(out.p_->value, a.p_->value, b.p_->value, out.p_->context))
    return std::nullopt;
  return out;
}

std::optional<std::pair<rational, poly>> square_root(const poly &p) {
  const poly::factor f = p.factors();
  poly root(p.in(), 1);
  for (const auto &[part, exponent] : f.parts) {
    if (exponent % 2)
      return std::nullopt;
    for (int i = 0; i < exponent / 2; ++i)
      root = root * part;
  }
  return std::pair{f.content, root};
}

std::vector<poly> coefficients(const poly &p, int v) {
  std::vector<std::vector<term>> parts(static_cast<std::size_t>(p.degree(v)) + 1);
  for (term t : p.terms()) {
    const auto it = std::find_if(t.factors.begin(), t.factors.end(), [&](const power &f) { return f.variable == v; });
    std::size_t k = 0;
    if (it != t.factors.end()) {
      k = static_cast<std::size_t>(it->exponent);
      t.factors.erase(it);
    }
    parts[k].push_back(std::move(t));
  }
  std::vector<poly> out;
  for (const auto &part : parts)
    out.push_back(poly::from_terms(p.in(), part));
  return out;
}

} // namespace meetc::poly
