// Affine forms as numbers: which signs of a stage are affine in one object's numbers, and their coefficients.
//
// Problem: the side of a plane on which a point lies is a1 x + a2 y + a3 z + d in the point's coordinates, and the plane
// alone determines the coefficients. One plane against many points then costs three multiply-adds a point. The emitted
// program does not say which signs are of that sort, nor what the coefficients are.
// Method: the program is a template on the number type, so it is run on affine forms c_0 y_0 + ... + c_(N-1) y_(N-1) + c_N
// in the numbers y of one object. Over a finite field, at compile time, with the other object's numbers replaced by
// residues, this tells which signs stay affine, which coefficients vanish, and which of them are equal. Over double, with
// a bound of the error of each coefficient, it computes the coefficients. What the residues say is used as a layout alone:
// a coefficient that they call zero, or equal to another, by accident, is counted as an error (affine_filter.hpp), so no
// proof rests on them.
// Source: Schwartz, "Fast probabilistic algorithms for verification of polynomial identities", 1980.
#ifndef MEETC_AFFINE_FORMS_HPP
#define MEETC_AFFINE_FORMS_HPP

#include <meetc/stored.hpp>
#include <meetc/tracked.hpp>

#include <cmath>
#include <cstdint>

MEETC_NAMESPACE(meetc) {

// ---- over a finite field ----

inline constexpr std::uint64_t field_prime = 0x7fffffff;

// Numbers without a simple relation, so that no polynomial of a program vanishes for them by accident (SplitMix64: Steele,
// Lea and Flood, 2014).
constexpr std::uint64_t next_residue(std::uint64_t &state) {
  state += 0x9e3779b97f4a7c15;
  std::uint64_t x = state;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return (x ^ x >> 31) % field_prime;
}

// An affine form in N variables; `affine` is false where it was multiplied by another one that is no constant.
template <int N> struct field_form {
  std::uint64_t c[N + 1] = {};
  bool affine = true;

  constexpr field_form() = default;
  constexpr explicit field_form(std::int64_t n) {
    const auto p = static_cast<std::int64_t>(field_prime);
    c[N] = static_cast<std::uint64_t>((n % p + p) % p);
  }
  template <int None>
  requires(None == 0 && N > 0) constexpr explicit field_form(const field_form<None> &constant) { c[N] = constant.c[0]; }
  constexpr bool is_constant() const {
    for (int k = 0; k < N; ++k)
      if (c[k] != 0)
        return false;
    return affine;
  }
  friend constexpr field_form operator-(field_form a) {
    for (std::uint64_t &x : a.c)
      x = (field_prime - x) % field_prime;
    return a;
  }
  friend constexpr field_form operator+(field_form a, const field_form &b) {
    for (int k = 0; k <= N; ++k)
      a.c[k] = (a.c[k] + b.c[k]) % field_prime;
    a.affine = a.affine && b.affine;
    return a;
  }
  friend constexpr field_form operator-(const field_form &a, const field_form &b) { return a + -b; }
  friend constexpr field_form operator*(const field_form &a, const field_form &b) {
    const field_form &by = a.is_constant() ? a : b;
    field_form r = a.is_constant() ? b : a;
    r.affine = r.affine && by.is_constant();
    for (std::uint64_t &x : r.c)
      x = x * by.c[N] % field_prime;
    return r;
  }
};

// ---- over double, with errors ----

using tracked = tracked_number<double>;

// An affine form whose variables lie in [-1, 1]. The product of two that are no constants is counted as an error.
template <int N> struct tracked_form {
  tracked c[N + 1];

  tracked_form() = default;
  MEETC_INLINE explicit tracked_form(tracked constant) { c[N] = constant; }
  MEETC_INLINE explicit tracked_form(double constant) : tracked_form(tracked(constant)) {}

  // A bound of what the variables add.
  MEETC_INLINE double reach() const {
    double sum = 0;
    for (int k = 0; k < N; ++k)
      sum += std::fabs(c[k].v) + c[k].e;
    return sum;
  }
  friend MEETC_INLINE tracked_form operator-(tracked_form a) {
    for (tracked &x : a.c)
      x = -x;
    return a;
  }
  friend MEETC_INLINE tracked_form operator+(tracked_form a, const tracked_form &b) {
    for (int k = 0; k <= N; ++k)
      a.c[k] = a.c[k] + b.c[k];
    return a;
  }
  friend MEETC_INLINE tracked_form operator-(tracked_form a, const tracked_form &b) {
    for (int k = 0; k <= N; ++k)
      a.c[k] = a.c[k] - b.c[k];
    return a;
  }
  friend MEETC_INLINE tracked_form operator*(const tracked_form &a, const tracked_form &b) {
    tracked_form r;
    for (int k = 0; k < N; ++k)
      r.c[k] = a.c[k] * b.c[N] + a.c[N] * b.c[k];
    r.c[N] = a.c[N] * b.c[N];
    r.c[N].e += a.reach() * b.reach();
    return r;
  }
};

// ---- the reject stage ----

enum class operand : std::uint8_t { a, b };

// Of the reject stage of P: the values of all signs as forms in the numbers of operand Of. `row` has the numbers of the
// other operand, as constants, and `variables` those of Of. Where Of's stored values contribute to a
// sign, it is not affine: over the field `beyond` says so, and over double its value means nothing and is not read.
template <class P, operand Of, class Form, class Number>
constexpr void reject_forms(const Number *row, const Form *variables, const Form &beyond, Form *v) {
  using stage = typename P::reject_stage;
  constexpr bool in_b = Of == operand::b;
  constexpr int rows = in_b ? P::inputs_a : P::inputs_b;
  constexpr int own = in_b ? stored_values_b<stage>() : stored_values_a<stage>(),
                others = in_b ? stored_values_a<stage>() : stored_values_b<stage>();
  Form constants[rows], of_own[own + 1], of_others[others + 1];
  for (int i = 0; i < rows; ++i)
    constants[i] = Form(row[i]);
  for (Form &f : of_own)
    f = beyond;
  if constexpr (others > 0) {
    Number stored[others];
    if constexpr (in_b)
      stage::object_a(row, stored);
    else
      stage::object_b(row, stored);
    for (int i = 0; i < others; ++i)
      of_others[i] = Form(stored[i]);
  }
  if constexpr (in_b)
    stage::template pair<Form, Form>(constants, of_others, variables, of_own, v);
  else
    stage::template pair<Form, Form>(variables, of_own, constants, of_others, v);
}

// The signs of P's reject stage that are affine in the numbers of operand Of, in the order of the stage, and how each is
// made: of value `turned ? -sign : sign`, coefficient place[k] - 1 goes with number k, and 0 means that it has none. Equal
// coefficients share a place. `columns` are the numbers that occur.
template <class P, operand Of> struct affine_layout {
  static constexpr int numbers = Of == operand::b ? P::inputs_b : P::inputs_a;
  static constexpr int atoms = P::reject_stage::atoms;
  int signs = 0, coefficients = 0, columns = 0;
  int sign[atoms + 1] = {}, place[atoms + 1][numbers + 1] = {}, column[numbers + 1] = {};
  bool turned[atoms + 1] = {};
};

template <class P, operand Of> constexpr affine_layout<P, Of> affine_layout_of() {
  affine_layout<P, Of> l;
  if constexpr (P::reject_stage::atoms > 0) {
    constexpr int n = affine_layout<P, Of>::numbers, atoms = affine_layout<P, Of>::atoms;
    constexpr int rows = Of == operand::b ? P::inputs_a : P::inputs_b;
    using form = field_form<n>;
    using number = field_form<0>;
    number row[rows];
    form variables[n], beyond, v[atoms];
    std::uint64_t state = 0;
    for (number &x : row)
      x.c[0] = next_residue(state);
    for (int k = 0; k < n; ++k)
      variables[k].c[k] = 1;
    beyond.affine = false;
    reject_forms<P, Of, form>(row, variables, beyond, v);
    std::uint64_t known[atoms * (n + 1)] = {};
    const auto find = [&](std::uint64_t c) {
      for (int i = 0; i < l.coefficients; ++i)
        if (known[i] == c)
          return i;
      return l.coefficients;
    };
    bool used[n] = {};
    for (int i = 0; i < atoms; ++i) {
      if (!v[i].affine || v[i].is_constant())
        continue;
      const form turned = -v[i];
      int have = 0, have_turned = 0;
      for (int k = 0; k <= n; ++k) {
        have += find(v[i].c[k]) < l.coefficients;
        have_turned += find(turned.c[k]) < l.coefficients;
      }
      l.turned[l.signs] = have_turned > have;
      const form &f = have_turned > have ? turned : v[i];
      for (int k = 0; k <= n; ++k) {
        if (f.c[k] == 0)
          continue;
        const int at = find(f.c[k]);
        if (at == l.coefficients)
          known[l.coefficients++] = f.c[k];
        l.place[l.signs][k] = at + 1;
        if (k < n)
          used[k] = true;
      }
      l.sign[l.signs++] = i;
    }
    for (int k = 0; k < n; ++k)
      if (used[k])
        l.column[l.columns++] = k;
  }
  return l;
}

} // MEETC_NAMESPACE(meetc)

#endif
