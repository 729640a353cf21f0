// A geometric algebra of n <= 8 vectors with any symmetric metric, over exact rationals.
//
// Basis blades are outer products of basis vectors, stored as bitmasks in basis order. The basis need not be
// orthogonal: a vector times a blade is its outer product plus its contraction, and a longer factor is peeled off one
// vector at a time, (a ^ A) B = a (A B) - (a . A) B. (Dorst, Fontijne, Mann, Geometric Algebra for Computer Science,
// ch. 19, change the basis instead; peeling needs no change and works for degenerate metrics too.)
#pragma once
#include <cstdint>
#include <gmpxx.h>
#include <map>
#include <string>
#include <vector>

namespace meetc::algebra {

using rational = mpq_class;
using blade = std::uint32_t; // bit i: the i-th basis vector is a factor

struct blade_term {
  blade at;
  rational weight;
};
using blade_sum = std::vector<blade_term>; // sorted by blade, no zero weights

int grade(blade b);

class metric {
public:
  metric(std::vector<std::string> names, std::vector<std::vector<rational>> squares);

  int vectors() const { return static_cast<int>(names_.size()); }
  const std::vector<std::string> &names() const { return names_; }
  const rational &product(int i, int j) const {
    return squares_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  blade pseudoscalar() const { return (blade{1} << vectors()) - 1; }

  const blade_sum &geometric(blade a, blade b) const;
  static int outer_sign(blade a, blade b); // 0 where they share a vector

  // "e1^e2^n"; "1" for the scalar.
  std::string name(blade b, const char *between = "^") const;

private:
  std::vector<std::string> names_;
  std::vector<std::vector<rational>> squares_;
  mutable std::vector<blade_sum> table_; // filled on demand
  mutable std::vector<bool> known_;

  blade_sum vector_times(int v, const blade_sum &b) const;
  blade_sum contract(int v, blade b) const;
};

// Orders blades by grade, then by their vectors in basis order: e1^e2, e1^e3, ... This is the order for output.
bool in_reading_order(blade a, blade b);

} // namespace meetc::algebra
