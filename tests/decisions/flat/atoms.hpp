// The expression whose sign each emitted sign is, found by running the emitted stages on polynomials.
//
// A value is recognised if it is, as a polynomial in the coordinates, exactly one of these or its
// negative:
//   determinant(a, b, c, d)  det (b - a, c - a, d - a)
//   turn(k, a, b, c)         component k of (b - a) x (c - a)
//   difference(k, a, b)      component k of a - b
// for labels of the points of both operands, A's first. Each changes its sign when two labels are swapped.
#ifndef MEETC_TESTS_DECISIONS_ATOMS_HPP
#define MEETC_TESTS_DECISIONS_ATOMS_HPP

#include "gen/poly/poly.hpp"
#include "tests/decisions/flat/chirotope.hpp"
#include <meetc/support.hpp>

#include <initializer_list>
#include <utility>

namespace meetc::decisions_test {

enum class shape { determinant, turn, difference };
struct atom {
  shape kind;
  int axis;  // 0 for a determinant
  labels of; // in ascending order
  int sign;  // the value is sign * kind(axis, of)
};

class atom_table {
public:
  atom_table(int n, std::vector<atom> atoms);
  int label_count() const { return n_; }
  const std::vector<atom> &all() const { return atoms_; }
  // The sign of kind(axis, of), with labels in any order, from the signs of the values. Throws if there is no
  // such value.
  template <class S> S read(const S *values, shape kind, int axis, std::initializer_list<int> of) const {
    const auto [index, sign] = find(kind, axis, of);
    return sign > 0 ? values[index] : -values[index];
  }

private:
  int n_;
  std::vector<atom> atoms_;
  std::array<int, 3 * 3 * 64> index_; // by kind, axis and the bits of the labels; -1 for none
  std::pair<std::size_t, int> find(shape kind, int axis, std::initializer_list<int> of) const;
};

// A number type that computes with polynomials in x0, y0, z0, x1, ..., the coordinates of at most six points.
class polynomial {
public:
  polynomial() : polynomial(0) {}
  explicit polynomial(int constant);
  static polynomial coordinate(int label, int axis);
  const poly::poly &value() const { return p_; }
  friend polynomial operator+(const polynomial &a, const polynomial &b) { return polynomial(a.p_ + b.p_); }
  friend polynomial operator-(const polynomial &a, const polynomial &b) { return polynomial(a.p_ - b.p_); }
  friend polynomial operator*(const polynomial &a, const polynomial &b) { return polynomial(a.p_ * b.p_); }
  friend polynomial operator-(const polynomial &a) { return polynomial() - a; }

private:
  explicit polynomial(poly::poly p) : p_(std::move(p)) {}
  poly::poly p_;
};

// Throws std::logic_error if a value is none of the above.
atom_table recognise(int n, const std::vector<polynomial> &values);

// The table of a predicate whose operands are points, segments and triangles; computed once.
template <class P> const atom_table &atoms_of() {
  static const atom_table table = [] {
    constexpr int first = P::inputs_a / 3, all = first + P::inputs_b / 3;
    polynomial a[P::inputs_a], b[P::inputs_b];
    for (int i = 0; i < P::inputs_a; ++i)
      a[i] = polynomial::coordinate(i / 3, i % 3);
    for (int i = 0; i < P::inputs_b; ++i)
      b[i] = polynomial::coordinate(first + i / 3, i % 3);
    std::vector<polynomial> values(P::atoms);
    each_stage<P>([&](auto stage) {
      using Stage = decltype(stage);
      meetc::stage_values<Stage>(a, b, values.data() + Stage::first);
    });
    return recognise(all, values);
  }();
  return table;
}

} // namespace meetc::decisions_test

#endif
