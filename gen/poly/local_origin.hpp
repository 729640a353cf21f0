// Lowering to a local origin.
//
// A polynomial that does not change under a translation of all positions is rewritten in coordinate differences: one
// point of each operand is the origin of that operand's differences, and one difference joins the two origins. In the
// conformal model this makes float32 usable: the squares x^2 of world coordinates cancel exactly, here and not in
// floating point. Translation invariance is checked, not assumed: for each axis, the sum of dp/dx over all positions is
// 0.
#pragma once
#include "gen/poly/poly.hpp"

#include <array>

namespace meetc::poly {

// The scope of a value, which depends on nothing (a constant), on one object, or on the pair.
enum class residency { scene = 0, a = 1, b = 2, pair = 3 }; // bitwise or joins two of them

// One stored number of the two operands, in ring order.
struct stored_number {
  int operand; // 0 or 1
  int group;   // the numbers of one point or direction share a group; -1: a bare number
  int axis;
  bool position; // moved by a translation
};

// A variable of the local ring.
struct local_variable {
  residency where;
  int vector; // the vector (difference, direction, position) of which it is a component, or -1
  int axis;
  int minuend, subtrahend; // base variables; subtrahend -1: the stored number itself
};

class local_origin {
public:
  local_origin(const ring &base, std::vector<stored_number> numbers);

  const ring &base() const { return base_; }
  const stored_number &stored(int v) const { return numbers_[static_cast<std::size_t>(v)]; }
  const ring &local() const { return *local_; }
  const local_variable &info(int v) const { return info_[static_cast<std::size_t>(v)]; }
  // The components of a vector, by axis, as local variables.
  const std::vector<int> &vector(int id) const { return vectors_[static_cast<std::size_t>(id)]; }
  int vectors() const { return static_cast<int>(vectors_.size()); }

  bool is_invariant(const poly &absolute) const;
  // Writes `absolute` in differences if it is translation invariant, and otherwise in the stored numbers.
  poly lower(const poly &absolute) const;
  // The inverse: replaces differences by stored numbers.
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
