// A geometric algebra of n <= 8 vectors with any symmetric metric, over exact rationals.
//
// Basis blades are outer products of basis vectors, stored as bitmasks. Their vectors stand in basis order, unless an order
// of blades says otherwise (e3^e1 in place of e1^e3). The basis need not be orthogonal: a vector times a blade is its outer
// product plus its contraction, and a longer factor is peeled off: (a ^ A) B = a (A B) - (a . A) B. (Dorst,
// Fontijne, Mann, Geometric Algebra for Computer Science, ch. 19, change the basis instead.) Any metric will do.
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
  // order: basis blades by the numbers of their vectors. Among the places that these blades have together in reading order,
  // they take the order of this list, and their vectors the written one. None stands twice.
  metric(std::vector<std::string> names, std::vector<std::vector<rational>> squares,
         const std::vector<std::vector<int>> &order = {});

  int vectors() const { return static_cast<int>(names_.size()); }
  const std::vector<std::string> &names() const { return names_; }
  const rational &product(int i, int j) const {
    return squares_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  blade pseudoscalar() const { return (blade{1} << vectors()) - 1; }

  const blade_sum &geometric(blade a, blade b) const;
  int outer_sign(blade a, blade b) const; // 0 where they share a vector

  // The numbers of the vectors of a basis blade, in the order of its product.
  const std::vector<int> &factors(blade b) const { return factors_[b]; }
  // The sign of that product beside the one in basis order.
  int sign(blade b) const { return signs_[b]; }
  // Whether a stands before b in output.
  bool before(blade a, blade b) const { return rank_[a] < rank_[b]; }

  // "e1^e2^n"; "1" for the scalar.
  std::string name(blade b, const char *between = "^") const;

private:
  std::vector<std::string> names_;
  std::vector<std::vector<rational>> squares_;
  std::vector<std::vector<int>> factors_; // of each blade
  std::vector<int> signs_, rank_;
  // Products of blades in basis order, and of those of this algebra, both filled on demand.
  struct table {
    std::vector<blade_sum> of;
    std::vector<bool> known;
  };
  mutable table plain_, ordered_;
  bool same_signs_ = true; // as in basis order

  void take_order(const std::vector<std::vector<int>> &order);
  const blade_sum &in_basis_order(blade a, blade b) const;
  blade_sum vector_times(int v, const blade_sum &b) const;
  blade_sum contract(int v, blade b) const;
};

} // namespace meetc::algebra
