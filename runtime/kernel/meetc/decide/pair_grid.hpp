// The grid on which the numbers of a pair are integers: one for all of them, or one for each group.
//
// Problem: a plane N . x = d has a sign N . c - d, whose terms have two numbers and one. On one grid they have no common unit.
// Method: the compiler gives each number i a weight P::weight(i, j) in each group j, such that all terms of a sign have one
// degree in each group (gen/bound/grading.hpp). Group j has a step 2^low[j], and number i the unit
// 2^(sum of weight(i, j) low[j]), of which it is a multiple. Then a sign's value is an integer times the product of the steps,
// each to the power of the sign's degree in the group. A number of weight 1 in one group alone gives that group's step its
// exponent, and all others lower the steps, the highest first, until their units divide them.
// Widths: number i is below 2^(w b) units for its whole weight w, where b = bits(), so values are below
// 2^(degree b + growth), as on one grid. A step is at least 2^-149: where all of a number's groups had such steps or lower
// ones, its unit would be 2^(-149 w) or less and divide it. Hence, for numbers below 2^129, b <= 278.
#ifndef MEETC_DECIDE_PAIR_GRID_HPP
#define MEETC_DECIDE_PAIR_GRID_HPP

#include <meetc/number/grid.hpp>

#include <type_traits>

MEETC_NAMESPACE(meetc) {

// Whether the numbers of P have groups. Where they have none, there is one grid.
template <class P>
concept grouped = requires {
  P::groups;
};

template <class P> MEETC_HD constexpr int weight_of(int i) {
  int sum = 0;
  for (int j = 0; j < P::groups; ++j)
    sum += P::weight(i, j);
  return sum;
}

template <class P> class group_grid {
public:
  int low[P::groups]; // exponents of the steps

  MEETC_HD group_grid(const float *row_a, const float *row_b) {
    constexpr int n = P::inputs_a + P::inputs_b;
    int high[P::groups];
    for (int j = 0; j < P::groups; ++j)
      low[j] = 127, high[j] = -1000;
    const auto number = [&](int i) { return decode(i < P::inputs_a ? row_a[i] : row_b[i - P::inputs_a]); };
    const auto top = [](const decoded &d) { return d.e + 1 + highest_bit(d.m); };
    for (int i = 0; i < n; ++i) {
      const decoded d = number(i);
      if (d.m == 0)
        continue;
      largest_ = top(d) > largest_ ? top(d) : largest_;
      const int lowest = d.e + lowest_bit(d.m);
      if (weight_of<P>(i) == 1)
        for (int j = 0; j < P::groups; ++j)
          if (P::weight(i, j) == 1) {
            low[j] = lowest < low[j] ? lowest : low[j];
            high[j] = top(d) > high[j] ? top(d) : high[j];
          }
    }
    for (int i = 0; i < n; ++i)
      if (const decoded d = number(i); d.m != 0 && weight_of<P>(i) > 1)
        while (unit(i) > d.e + lowest_bit(d.m))
          --low[highest_of(i)];
    for (int j = 0; j < P::groups; ++j)
      bits_ = high[j] - low[j] > bits_ ? high[j] - low[j] : bits_;
    for (int i = 0; i < n; ++i)
      if (const decoded d = number(i); d.m != 0 && weight_of<P>(i) > 1) {
        const int w = weight_of<P>(i), beyond = top(d) - unit(i) - w * bits_;
        bits_ += beyond > 0 ? (beyond + w - 1) / w : 0;
      }
  }
  // The exponent of number i's unit.
  MEETC_HD int unit(int i) const {
    int e = 0;
    for (int j = 0; j < P::groups; ++j)
      e += P::weight(i, j) * low[j];
    return e;
  }
  MEETC_HD int bits() const { return bits_; }
  MEETC_HD bool finite() const { return largest_ <= 128; }

private:
  int bits_ = 0, largest_ = -1000;

  // The group of number i with the highest step.
  MEETC_HD int highest_of(int i) const {
    int at = -1;
    for (int j = 0; j < P::groups; ++j)
      if (P::weight(i, j) > 0 && (at < 0 || low[j] > low[at]))
        at = j;
    return at;
  }
};

template <class P, bool = grouped<P>> struct pair_grid_of { using type = grid; };
template <class P> struct pair_grid_of<P, true> { using type = group_grid<P>; };
template <class P> using pair_grid = typename pair_grid_of<P>::type;

template <class P> MEETC_HD inline pair_grid<P> grid_of_pair(const float *row_a, const float *row_b) {
  if constexpr (grouped<P>)
    return group_grid<P>(row_a, row_b);
  else
    return join(grid_of(row_a, P::inputs_a), grid_of(row_b, P::inputs_b));
}

// v as a multiple of its unit, for number i of a pair. A number that no sign reads is 0.
MEETC_HD inline int unit_of(int low, int) {
  return low;
}
MEETC_HD inline int unit_of(const grid &g, int) {
  return g.low;
}
template <class P> MEETC_HD inline int unit_of(const group_grid<P> &g, int i) {
  return g.unit(i);
}
template <class P> MEETC_HD inline float as_read(float v, [[maybe_unused]] int i) {
  if constexpr (grouped<P>)
    return weight_of<P>(i) > 0 ? v : 0.0F;
  else
    return v;
}

// The exponent of the unit of sign i of a stage.
template <class Stage> MEETC_HD inline int unit_of_sign(const grid &g, int i) {
  return g.low * Stage::degree_of(i);
}
template <class Stage, class P> MEETC_HD inline int unit_of_sign(const group_grid<P> &g, int i) {
  int e = 0;
  for (int j = 0; j < P::groups; ++j)
    e += Stage::degree_in(i, j) * g.low[j];
  return e;
}

// The exponents of the least step and of the largest number that is counted in steps, both no nearer to 0 than 0.
struct exponent_range {
  int low, high;
};
MEETC_HD inline exponent_range range_of(const grid &g, int bits) {
  return {g.low < 0 ? g.low : 0, g.low + bits > 0 ? g.low + bits : 0};
}
template <class P> MEETC_HD inline exponent_range range_of(const group_grid<P> &g, int bits) {
  exponent_range r{0, 0};
  for (int j = 0; j < P::groups; ++j) {
    r.low = g.low[j] < r.low ? g.low[j] : r.low;
    r.high = g.low[j] + bits > r.high ? g.low[j] + bits : r.high;
  }
  return r;
}

} // MEETC_NAMESPACE(meetc)

#endif
