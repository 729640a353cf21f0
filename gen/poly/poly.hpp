// Exact rational polynomials in named variables. FLINT (https://flintlib.org, fmpq_mpoly) does the arithmetic and
// the factoring and stays behind this header.
#pragma once
#include "gen/algebra/metric.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace meetc::poly {

using algebra::rational;

// The variables that polynomials are written in. Polynomials of different rings do not mix.
class ring {
public:
  explicit ring(std::vector<std::string> names);
  ~ring();
  ring(const ring &) = delete;
  ring &operator=(const ring &) = delete;

  int size() const { return static_cast<int>(names_.size()); }
  const std::string &name(int v) const { return names_[static_cast<std::size_t>(v)]; }
  const std::vector<std::string> &names() const { return names_; }
  int find(const std::string &name) const; // -1 when there is none

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
  rational constant() const; // of a constant polynomial
  std::size_t length() const;
  int total_degree() const;
  int degree(int v) const;

  friend poly operator+(const poly &, const poly &);
  friend poly operator-(const poly &, const poly &);
  friend poly operator*(const poly &, const poly &);
  friend bool operator==(const poly &, const poly &);
  poly scaled(const rational &) const;
  poly derivative(int v) const;

  // Terms in FLINT's canonical order: equal polynomials give equal lists.
  std::vector<term> terms() const;
  std::vector<int> variables() const; // that occur, ascending
  std::string key() const;            // canonical bytes
  std::string text() const;           // for people

  // Each variable v replaced by images[v], which may live in another ring.
  poly substitute(const std::vector<poly> &images, const ring &target) const;
  rational evaluate(const std::vector<rational> &values) const;

  // this = content * primitive, primitive with coprime integer coefficients and a positive leading one.
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
  std::shared_ptr<storage> p_; // never changed once a poly is made, so copies share it
};

// sum over v of variable^k coefficient[k]: the polynomial seen as one in v alone.
std::vector<poly> coefficients(const poly &p, int v);

} // namespace meetc::poly
