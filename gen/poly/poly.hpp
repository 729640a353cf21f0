// Exact rational polynomials in named variables. FLINT (https://flintlib.org, fmpq_mpoly) does the arithmetic and the
// factoring; nothing outside this header sees it.
#pragma once
#include "gen/algebra/metric.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meetc::poly {

using algebra::rational;

// The variables of polynomials. Polynomials of different rings cannot be combined.
class ring {
public:
  explicit ring(std::vector<std::string> names);
  ~ring();
  ring(const ring &) = delete;
  ring &operator=(const ring &) = delete;

  int size() const { return static_cast<int>(names_.size()); }
  const std::string &name(int v) const { return names_[static_cast<std::size_t>(v)]; }
  const std::vector<std::string> &names() const { return names_; }
  int find(const std::string &name) const; // -1 where there is none

  struct context;
  context *flint() const { return context_.get(); }

private:
  std::vector<std::string> names_;
  std::unique_ptr<context> context_;
};

struct power {
  int variable, exponent;
  auto operator<=>(const power &) const = default;
};
using monomial = std::vector<power>; // by variable, exponents > 0

struct term {
  rational coefficient;
  monomial factors;
};

class poly {
public:
  explicit poly(const ring &r); // zero
  poly(const ring &r, const rational &constant);
  static poly variable(const ring &r, int v);
  static poly from_terms(const ring &r, const std::vector<term> &terms);

  const ring &in() const { return *ring_; }
  bool is_zero() const;
  bool is_constant() const;
  rational constant() const; // for a constant polynomial
  std::size_t length() const;
  int total_degree() const;
  int degree(int v) const;

  friend poly operator+(const poly &, const poly &);
  friend poly operator-(const poly &, const poly &);
  friend poly operator*(const poly &, const poly &);
  friend bool operator==(const poly &, const poly &);
  friend std::optional<poly> quotient(const poly &a, const poly &b);
  poly scaled(const rational &) const;
  poly derivative(int v) const;

  // Terms in FLINT's canonical order: equal polynomials give equal lists.
  std::vector<term> terms() const;
  std::vector<int> variables() const; // those that occur, ascending
  std::string key() const;            // canonical bytes
  std::string text() const;           // in readable form

  // Replaces each variable v by images[v], which may belong to another ring.
  poly substitute(const std::vector<poly> &images, const ring &target) const;
  // Replaces each variable v by the variable to[v] of `target`.
  poly renamed(const std::vector<int> &to, const ring &target) const;
  rational evaluate(const std::vector<rational> &values) const;

  // this = content * primitive. The primitive has coprime integer coefficients, the leading one positive.
  std::pair<rational, poly> primitive() const;
  // this = content * product of irreducible primitives.
  struct factor {
    // (irreducible, exponent), in a canonical order
    std::vector<std::pair<poly, int>> parts;
    rational content;
  };
  factor factors() const;

private:
  const ring *ring_;
  struct storage;
  std::shared_ptr<storage> p_; // never changes after construction, so copies share it
};

// The coefficients of p as a polynomial in v alone: p = sum over k of v^k coefficient[k].
std::vector<poly> coefficients(const poly &p, int v);
// a / b where it is a polynomial.
std::optional<poly> quotient(const poly &a, const poly &b);
// (k, r) with p = k r^2, for p other than zero, where such a polynomial exists.
std::optional<std::pair<rational, poly>> square_root(const poly &p);

} // namespace meetc::poly
