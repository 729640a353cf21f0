// Lowering to a local origin.
//
// A polynomial that a translation of all positions leaves alone is rewritten in coordinate differences: one point
// of each operand is the origin of that operand's differences, and one difference joins the two origins. In the
// conformal model this is what keeps float32 usable: the squares x^2 of world coordinates cancel exactly, here and
// not in floating point. Translation invariance is checked, not assumed: sum over positions of dp/dx = 0 an axis.
#pragma once
#include "gen/poly/poly.hpp"

#include <array>

namespace meetc::poly {

// Where a value is known: nowhere special (a constant), once an object, or once a pair.
enum class residency { scene = 0, a = 1, b = 2, pair = 3 }; // joins by bitwise or

// One stored number of the two operands, in ring order.
struct stored_number {
  int operand; // 0 or 1
  int group;   // numbers of a point or a direction share one; -1: a bare number
  int axis;
  bool position; // moved by a translation
};

// A variable of the local ring.
struct local_variable {
  residency where;
  int vector; // the vector (difference, direction, position) it is a component of, or -1
  int axis;
  int minuend, subtrahend; // base variables; subtrahend -1: the stored number itself
};

class frame {
public:
  frame(const ring &base, std::vector<stored_number> numbers);

  const ring &base() const { return base_; }
  const stored_number &stored(int v) const { return numbers_[static_cast<std::size_t>(v)]; }
  const ring &local() const { return *local_; }
  const local_variable &info(int v) const { return info_[static_cast<std::size_t>(v)]; }
  // The components of a vector, by axis, as local variables.
  const std::vector<int> &vector(int id) const { return vectors_[static_cast<std::size_t>(id)]; }
  int vectors() const { return static_cast<int>(vectors_.size()); }

  bool is_invariant(const poly &absolute) const;
  // In differences where `absolute` is translation invariant, in the stored numbers otherwise.
  poly lower(const poly &absolute) const;
  // The inverse: differences written out.
  poly raise(const poly &local) const;

private:
  struct point {
    int operand;
    std::vector<int> variables; // by axis
  };
  const ring &base_;
  std::vector<stored_number> numbers_;
  std::vector<point> points_;
  std::unique_ptr<ring> local_;
  std::vector<local_variable> info_;
  std::vector<poly> unchanged_; // base variables as local ones
  std::vector<std::vector<int>> vectors_;
  std::vector<std::vector<int>> difference_; // [i][j], i < j: the vector x_j - x_i

  std::vector<int> points_of(const poly &p) const;
};

} // namespace meetc::poly
