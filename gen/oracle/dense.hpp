// Dense geometric algebra over the rationals: simple, slow and intended to be obviously right.
//
// This is one of the two judges of the compiler (the other is convex.hpp). It shares no code with the compiler.
#ifndef MEETC_GEN_ORACLE_DENSE_HPP
#define MEETC_GEN_ORACLE_DENSE_HPP

#include <cstddef>
#include <gmpxx.h>
#include <vector>

namespace meetc::oracle {

using rational = mpq_class;

// A square matrix, by rows.
using matrix = std::vector<std::vector<rational>>;

// 2^n coefficients. Index m, read as a bit mask, is the OUTER product of the declared basis vectors whose bits are set,
// in declared order: with 5 vectors, index 0b10011 is v0 ^ v1 ^ v4. Index 0 is the scalar.
using multivector = std::vector<rational>;

// ---- operations that need no metric ----
// Both operands must have the same size, else std::invalid_argument is thrown.

[[nodiscard]] multivector add(const multivector &a, const multivector &b);
[[nodiscard]] multivector subtract(const multivector &a, const multivector &b);
[[nodiscard]] multivector scale(const rational &k, const multivector &a);
[[nodiscard]] multivector outer(const multivector &a, const multivector &b);

// The part of grade k; zero where no blade has grade k.
[[nodiscard]] multivector grade_part(const multivector &a, int k);
// The products of the same vectors in the opposite order, and of their negatives in the same order.
[[nodiscard]] multivector reverse(const multivector &a);
[[nodiscard]] multivector involute(const multivector &a);
// For each basis blade b: b ^ right_complement(b) = i, and left_complement(b) ^ b = i. Here i is a multiple of the last blade,
// else std::invalid_argument is thrown.
[[nodiscard]] multivector right_complement(const multivector &a, const multivector &i);
[[nodiscard]] multivector left_complement(const multivector &a, const multivector &i);
[[nodiscard]] rational scalar_part(const multivector &a);
[[nodiscard]] bool is_zero(const multivector &a);

// The geometric algebra of n vectors, 1 <= n <= 8, with a symmetric rational metric: metric[i][j] is the
// inner product of the declared vectors i and j. The metric may be indefinite, degenerate, or have a zero
// diagonal (null vectors).
//
// With a diagonal metric, blades are multiplied by counting swaps. Any other metric is diagonalised by an exact
// congruence, and products go through the orthogonal basis and back.
class dense_algebra {
public:
  // Throws std::invalid_argument unless the matrix is square, symmetric and of size 1 to 8.
  explicit dense_algebra(const matrix &metric);
  // The diagonal metric with these squares.
  [[nodiscard]] static dense_algebra diagonal(const std::vector<rational> &squares);

  [[nodiscard]] int dimension() const { return n_; }
  [[nodiscard]] std::size_t size() const { return std::size_t{1} << n_; }

  [[nodiscard]] multivector zero() const { return multivector(size()); }
  [[nodiscard]] multivector scalar(const rational &k) const;
  // The declared vector i, 0 <= i < n.
  [[nodiscard]] multivector vector(int i) const;
  // The outer product of all declared vectors in declared order. A spec may name another I: see meet.
  [[nodiscard]] multivector pseudoscalar() const;

  [[nodiscard]] multivector geometric(const multivector &a, const multivector &b) const;
  // a ⌋ b: the part of grade s - r of the product of grades r and s; zero where r > s.
  [[nodiscard]] multivector left_contraction(const multivector &a, const multivector &b) const;
  // The part of grade |r - s| of the product of grades r and s.
  [[nodiscard]] multivector symmetric_dot(const multivector &a, const multivector &b) const;
  // The x with x a = 1. Throws std::domain_error where there is none, or more than one.
  [[nodiscard]] multivector inverse(const multivector &a) const;
  // The meet (I x) ⌋ y, where I is the pseudoscalar above or the given one.
  [[nodiscard]] multivector meet(const multivector &x, const multivector &y) const;
  [[nodiscard]] multivector meet(const multivector &x, const multivector &y, const multivector &pseudo) const;

private:
  int n_;
  std::vector<rational> squares_; // of the orthogonal vectors
  std::vector<multivector> to_,
      from_; // images of blades, from declared to orthogonal and back; empty: the same basis

  [[nodiscard]] multivector orthogonal_product(const multivector &a, const multivector &b, bool contract) const;
  [[nodiscard]] multivector product(const multivector &a, const multivector &b, bool contract) const;
};

} // namespace meetc::oracle

#endif
